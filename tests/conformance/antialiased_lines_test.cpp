// Antialiased lines that OSMesa draws in a way of its own: those without length.
#include <catch2/catch.hpp>

#include "support/random.h"
#include "support/runner.h"

namespace softgl::test {
namespace {

/// Strips and loops whose corners repeat, as at the poles of a sphere. The fragments of a line without length
/// have the coverage 0: they take nothing from the color below, but they write their depth.
void draw_repeated_corners(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.ClearColor(0.2f, 0.3f, 0.4f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_LINE_SMOOTH);
  gl.Enable(GL_DEPTH_TEST);
  (r.chance(70) ? gl.Enable : gl.Disable)(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (int strip = 0; strip < 8; ++strip) {
    gl.LineWidth(r.real(0.5f, 6));
    gl.Begin(GLenum(r.pick({GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP})));
    for (int corner = 0; corner < 6; ++corner) {
      const float x = r.real(-1, 1), y = r.real(-1, 1), z = r.real(-0.9f, 0.9f);
      const float red = r.real(0, 1), green = r.real(0, 1);
      gl.Color4f(red, green, 0.5f, 1);
      for (int again = r.integer(1, 3); again > 0; --again) gl.Vertex3f(x, y, z);
    }
    gl.End();
  }
}

} // namespace

TEST_CASE("antialiased lines without length are drawn as OSMesa draws them", "[conformance][smooth]") {
  const Scene scene{"repeated_corners", draw_repeated_corners};
  for (uint64_t seed = 0; seed < 15; ++seed) {
    INFO("seed " << seed);
    const Picture theirs = draw(osmesa_library(), scene, seed);
    const Difference difference = compare(draw(softgl_library(), scene, seed), theirs);
    INFO(difference.text);
    CHECK_FALSE(difference.any());
  }
}

} // namespace softgl::test
