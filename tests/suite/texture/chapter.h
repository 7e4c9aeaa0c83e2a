// The tests of texturing (3.8), and of the coordinates that it takes (2.11.2, 2.11.4).
#pragma once

#include "run/test.h"

namespace softgl::suite {

std::vector<Test> texture_tests();

// A function for each file of tests; each returns its rows.
std::vector<Test> texture_image_tests();
std::vector<Test> texture_compressed_tests();
std::vector<Test> texture_part_tests();
std::vector<Test> texture_query_tests();
std::vector<Test> texture_filter_tests();
std::vector<Test> texture_environment_tests();
std::vector<Test> texture_coordinate_tests();
std::vector<Test> texture_object_tests();
std::vector<Test> texture_error_tests();

} // namespace softgl::suite
