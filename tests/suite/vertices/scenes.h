// Shapes with a color at each vertex.
#pragma once

#include "run/test.h"

namespace softgl::suite {

/// The i-th of seven bright colors becomes current.
void tint(Script& s, int i);
/// A triangle that is like none of its mirror images, around the origin, 0.8 wide; each corner of another
/// color.
void arrow(Script& s);
/// Vertices in a zigzag from left to right, of several colors, between glBegin and glEnd.
void zigzag(Script& s, GLenum mode, int count);
/// Vertices on a circle, of several colors; with `center` the first one is in the middle.
void ring(Script& s, GLenum mode, int count, bool center = false);
/// Quadrilaterals beside each other, of one color each, and `extra` vertices more.
void quads(Script& s, int count, int extra = 0);
/// A grid of cells x cells squares of two triangles over the rectangle; the color runs with x, y and z.
void mesh(Script& s, double left, double bottom, double right, double top, int cells, double z_left = 0,
          double z_right = 0);
/// A small square of the current color around (x, y).
void patch(Script& s, double x, double y, double half = 0.12);

/// A row whose specification leaves nothing open.
Test row(const char* name, const char* section, const char* sentence, std::function<void(Script&)> body,
         Need need = {});

} // namespace softgl::suite
