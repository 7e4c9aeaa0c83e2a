// What the tests of pixels draw: images at a raster position, with pixels that differ from each other.
#pragma once

#include "run/test.h"
#include "script/pixel_types.h"

namespace softgl::suite {

Test pixel_test(const char* name, const char* section, const char* sentence,
                std::function<void(Script&)> body, Need need = {}, const char* open = "");

/// The raster position at window coordinates of the window's lower left corner, in pixels.
void place(Script& s, double x, double y);
/// Elements that cover the range of the type; floats reach beyond [0, 1], indexes stay below 16.
Memory elements_of(GLenum type, int count, bool index = false);
/// An image of `width` x `height` pixels from (8, 8) on, each `zoom` pixels large.
void draw_image(Script& s, GLenum format, GLenum type, int width = 8, int height = 8, double zoom = 8);
/// The maps from indexes to colors.
void index_maps(Script& s);
/// Alpha is seen in colors.
void show_alpha(Script& s);
/// A sheet of triangles over the whole model, with colors that vary.
void varied_sheet(Script& s, double z_left = 0, double z_right = 0);

} // namespace softgl::suite
