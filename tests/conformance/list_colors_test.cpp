// Where a list sets a color decides its last bits: between Begin and End it belongs to the vertices and is
// interpolated, in front of Begin it is constant.
#include <catch2/catch.hpp>

#include "support/runner.h"

namespace softgl::test {
namespace {

GLenum mode; // read by the scene
int place;   // of the color: in front of the list, in front of Begin, behind Begin, at each vertex

void draw_halves(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.MatrixMode(GL_PROJECTION);
  gl.Frustum(-0.5, 0.5, -0.5, 0.5, 0.5, 9);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Translatef(0, 0, -1.2f);
  GLfloat color[4]; // each rounds either way
  for (GLfloat& c : color) c = (float(r.integer(0, 254)) + 0.5f) / 255;
  const auto set = [&](int here) {
    if (here == place) gl.Color4fv(color);
  };
  set(0);
  gl.NewList(1, GL_COMPILE);
  set(1);
  gl.Begin(mode);
  set(2);
  for (int i = 0; i < 6; i++) {
    set(3);
    const float x = r.real(-1, 1), y = r.real(-1, 1), z = r.real(-1, 1.3f); // some behind the eye
    gl.Vertex3f(x, y, z);
  }
  gl.End();
  gl.EndList();
  gl.CallList(1);
}

} // namespace

TEST_CASE("a color that a list sets between Begin and End has the bits of an interpolated one",
          "[conformance][lists]") {
  const Scene scene{"halves", draw_halves, true};
  for (mode = GL_TRIANGLES; mode <= GL_POLYGON; mode++) {
    if (mode == GL_QUADS || mode == GL_QUAD_STRIP) continue; // diagonals: reference/DEVIATIONS.md
    for (place = 0; place <= 3; place++)
      for (uint64_t seed = 0; seed < 20; seed++) {
        const Difference d =
            compare(draw(softgl_library(), scene, seed), draw(osmesa_library(), scene, seed));
        INFO("mode " << mode << ", place " << place << ", seed " << seed << ": " << d.text);
        CHECK_FALSE(d.any());
      }
  }
}

} // namespace softgl::test
