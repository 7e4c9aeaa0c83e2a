// The tests of lighting (2.14).
#pragma once

#include "run/test.h"

namespace softgl::suite {

std::vector<Test> lighting_tests();

// A function for each file of tests; each returns its rows.
std::vector<Test> lighting_term_tests();
std::vector<Test> lighting_attenuation_tests();
std::vector<Test> lighting_spot_tests();
std::vector<Test> lighting_position_tests();
std::vector<Test> lighting_count_tests();
std::vector<Test> lighting_normal_tests();
std::vector<Test> lighting_face_tests();
std::vector<Test> lighting_material_tests();
std::vector<Test> lighting_color_material_tests();
std::vector<Test> lighting_result_tests();
std::vector<Test> lighting_flat_tests();
std::vector<Test> lighting_sequence_tests();
std::vector<Test> lighting_phong_tests();

} // namespace softgl::suite
