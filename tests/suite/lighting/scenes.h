// What the lighting tests draw: black lights and materials that a test gives one term after another, and
// shapes whose normals turn through a wide range.
#pragma once

#include "run/test.h"

namespace softgl::suite {

/// Lighting is on; the scene, the material and all its terms are black.
void dark(Script& s);
/// The light is on, black, at the position.
void lamp(Script& s, GLenum light, V position);
/// dark, and light 0 of the color at the position, with a white diffuse material.
void diffuse_scene(Script& s, V position = {1, 2, 3, 0}, V color = {0.9, 0.7, 0.5, 1});
/// dark, and light 0 with a white highlight of the exponent.
void specular_scene(Script& s, V position, double shininess);

struct Dome {
  int cells = 8;
  double tilt = 1.5;        // tangent of the normal's angle at the middle of a side
  double normal_length = 1; // of the normals that are given
  bool inward = false;      // the triangles run clockwise
  double x = 0, y = 0, size = 1;
};
/// A dome of triangles over [-1, 1] x [-1, 1], 0.2 high, each vertex with its normal.
void dome(Script& s, const Dome& d = {});
/// The vertex of a dome at (x, y) in [-1, 1].
void dome_vertex(Script& s, const Dome& d, double x, double y);
/// Two triangles over the rectangle, facing the viewer, with the current normal.
void sheet(Script& s, double left, double bottom, double right, double top, double z = 0);
/// A grid of small sheets, each with a normal of its own that points anywhere into the half space of the
/// viewer.
void chart(Script& s, int rows = 7);
/// A projection with perspective in which the model covers the same pixels.
void perspective(Script& s);

} // namespace softgl::suite
