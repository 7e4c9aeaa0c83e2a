// The tests of points, lines and polygons (3.3 to 3.5), fog and antialiasing (3.10, 3.11), and the operations
// on fragments and the framebuffer (4.1, 4.2).
#pragma once

#include "run/test.h"

namespace softgl::suite {

std::vector<Test> raster_tests();

// A function for each file of tests; each returns its rows.
std::vector<Test> raster_point_tests();
std::vector<Test> raster_line_tests();
std::vector<Test> raster_polygon_tests();
std::vector<Test> raster_offset_tests();
std::vector<Test> raster_antialiasing_tests();
std::vector<Test> raster_fog_tests();
std::vector<Test> raster_scissor_and_alpha_tests();
std::vector<Test> raster_stencil_tests();
std::vector<Test> raster_depth_tests();
std::vector<Test> raster_query_tests();
std::vector<Test> raster_blend_tests();
std::vector<Test> raster_mask_tests();
std::vector<Test> raster_accumulation_tests();
std::vector<Test> raster_error_tests();

} // namespace softgl::suite
