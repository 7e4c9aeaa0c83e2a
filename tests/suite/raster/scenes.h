// What the tests of rasterization draw: shapes whose corners are given in pixels of the window.
#pragma once

#include <utility>

#include "run/test.h"
#include "vertices/scenes.h"

namespace softgl::suite {

/// `name` without the chapter's.
Test raster_test(const std::string& name, const char* section, const char* sentence,
                 std::function<void(Script&)> body, Need need = {}, const char* open = "");

/// A vertex at window coordinates; z is the model's.
void pixel_vertex(Script& s, double x, double y, double z = 0);
/// A rectangle of the current color with corners in pixels.
void box(Script& s, double left, double bottom, double right, double top, double z = 0);
/// A triangle of the current color.
void triangle(Script& s, std::initializer_list<std::pair<double, double>> corners, double z = 0);
/// Lines in all directions that do not touch, with colors that vary, or of one color each.
void star(Script& s, double inner = 12, bool varied = true);
/// Two triangles beside each other: a green front face on the left, a yellow back face on the right.
void two_faces(Script& s);
/// A slope that goes away from the eye to the left.
void slope(Script& s, double moved = 0);
/// Vertical stripes of colors with alpha, and horizontal ones over them.
void stripes(Script& s);
void crossing_stripes(Script& s);

constexpr std::pair<const char*, GLenum> kComparisons[] = {
    {"never", GL_NEVER},     {"less", GL_LESS},         {"equal", GL_EQUAL},   {"lequal", GL_LEQUAL},
    {"greater", GL_GREATER}, {"notequal", GL_NOTEQUAL}, {"gequal", GL_GEQUAL}, {"always", GL_ALWAYS}};

} // namespace softgl::suite
