// Ten random lighting states a scene: the family `lighting`, and the scenes that are compared with
// shaders/glsl and reference/spec.
#pragma once

#include "support/scene.h"

namespace softgl::test {

struct LightingStateOptions {
  bool exponent_zero = true; // materials with the exponent 0, where OSMesa has answers of its own (x^x, 0^0)
  bool phong = false;        // GL_PHONG_WIN instead of GL_SMOOTH and GL_FLAT
  bool illumination = false; // reflection vectors in half the scenes, single terms in a third of them
  // Rounding decides nothing that can be seen: no vertex where the eye is, and no cone so narrow that one
  // step of its cosine as a float is seen as a pixel. (At a cut-off of half a degree, a light 100 away moves
  // its rim by a fiftieth of a pixel for each; one scene in a hundred had a pixel there that equation 2.5
  // lights in one order of the sums and not in another.)
  bool well_conditioned = false;
  bool back_colors = false; // back materials may follow the color under two-sided lighting
};

void draw_lighting_states(Stage& s, const LightingStateOptions& options);

} // namespace softgl::test
