// Filled shapes with smooth edges, on a picture.
#pragma once

#include <array>
#include <vector>

#include "image/picture.h"

namespace softgl::cli {

using Color = std::array<uint8_t, 3>;

// In pixels from the picture's top left corner, y downwards.
struct Point {
  double x = 0, y = 0;
};

// Lays a color over an RGB picture, as opaque as each byte of the mask says (rows from the top, 255: opaque).
// The mask's left top corner is at (left, top), and may be outside.
void blend_mask(Picture& picture, const uint8_t* mask, int left, int top, int width, int height,
                const Color& color, double opacity = 1);

// Fills what lies inside of any of the polygons, once where they overlap.
void fill_polygons(Picture& picture, const std::vector<std::vector<Point>>& polygons, const Color& color,
                   double opacity = 1);

// A line with round corners and ends.
void stroke_line(Picture& picture, const std::vector<Point>& points, bool closed, double width,
                 const Color& color, double opacity = 1);

} // namespace softgl::cli
