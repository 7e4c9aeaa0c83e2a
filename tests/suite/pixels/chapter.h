// The tests of pixel rectangles and bitmaps, drawn, read and copied (3.6, 3.7, 4.3).
#pragma once

#include "run/test.h"

namespace softgl::suite {

std::vector<Test> pixels_tests();

// A function for each file of tests; each returns its rows.
std::vector<Test> pixel_format_tests();
std::vector<Test> pixel_store_tests();
std::vector<Test> pixel_draw_tests();
std::vector<Test> pixel_read_tests();
std::vector<Test> pixel_stencil_tests();
std::vector<Test> pixel_error_tests();

} // namespace softgl::suite
