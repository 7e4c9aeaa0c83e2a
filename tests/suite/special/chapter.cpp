#include "special/chapter.h"

namespace softgl::suite {

std::vector<Test> special_tests() {
  return joined({special_feedback_tests, special_feedback_value_tests, special_feedback_mode_tests,
                 special_selection_tests, special_name_tests, special_curve_tests, special_surface_tests,
                 special_mesh_tests, special_list_tests, special_error_tests});
}

} // namespace softgl::suite
