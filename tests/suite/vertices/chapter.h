// The tests of vertices, matrices, clipping and the raster position (2.5 to 2.13), without lighting.
#pragma once

#include "run/test.h"

namespace softgl::suite {

std::vector<Test> vertices_tests();

// A function for each file of tests; each returns its rows.
std::vector<Test> vertices_primitive_tests();
std::vector<Test> vertices_edge_flag_tests();
std::vector<Test> vertices_command_tests();
std::vector<Test> vertices_array_tests();
std::vector<Test> vertices_matrix_tests();
std::vector<Test> vertices_clipping_tests();
std::vector<Test> vertices_raster_position_tests();
std::vector<Test> vertices_list_tests();
std::vector<Test> vertices_stack_tests();
std::vector<Test> vertices_error_tests();

} // namespace softgl::suite
