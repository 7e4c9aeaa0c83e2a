#include "vertices/chapter.h"

namespace softgl::suite {

std::vector<Test> vertices_tests() {
  return joined({vertices_primitive_tests, vertices_edge_flag_tests, vertices_command_tests,
                 vertices_array_tests, vertices_matrix_tests, vertices_clipping_tests,
                 vertices_raster_position_tests, vertices_list_tests, vertices_stack_tests,
                 vertices_error_tests});
}

} // namespace softgl::suite
