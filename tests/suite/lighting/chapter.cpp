#include "lighting/chapter.h"

namespace softgl::suite {

std::vector<Test> lighting_tests() {
  return joined({lighting_term_tests, lighting_attenuation_tests, lighting_spot_tests,
                 lighting_position_tests, lighting_count_tests, lighting_normal_tests, lighting_face_tests,
                 lighting_material_tests, lighting_color_material_tests, lighting_result_tests,
                 lighting_flat_tests, lighting_sequence_tests, lighting_phong_tests});
}

} // namespace softgl::suite
