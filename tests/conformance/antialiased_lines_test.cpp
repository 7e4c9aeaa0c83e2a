// Antialiased lines that OSMesa draws in a way of its own: those without length, and stippled strips.
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

/// Strips and loops inside the view volume, whose lines have no whole lengths: each goes on with the pattern
/// behind the last step of the line before it, a whole step even where the line ends within it (3.4.4).
void draw_stippled_strips(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.ClearColor(0.2f, 0.3f, 0.4f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_LINE_SMOOTH);
  gl.Enable(GL_LINE_STIPPLE);
  (r.chance(70) ? gl.Enable : gl.Disable)(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (int strip = 0; strip < 4; ++strip) {
    gl.LineWidth(r.real(0.5f, 6));
    gl.LineStipple(r.integer(1, 4), GLushort(r.bits()));
    gl.Color4f(r.real(0, 1), r.real(0, 1), 0.5f, 1);
    gl.Begin(GLenum(r.pick({GL_LINE_STRIP, GL_LINE_LOOP})));
    for (int corner = r.integer(3, 30); corner > 0; --corner)
      gl.Vertex2f(r.real(-0.9f, 0.9f), r.real(-0.9f, 0.9f));
    gl.End();
  }
}

void compare_with_osmesa(const Scene& scene) {
  for (uint64_t seed = 0; seed < 15; ++seed) {
    INFO("seed " << seed);
    const Picture theirs = draw(osmesa_library(), scene, seed);
    const Difference difference = compare(draw(softgl_library(), scene, seed), theirs);
    INFO(difference.text);
    CHECK_FALSE(difference.any());
  }
}

} // namespace

TEST_CASE("antialiased lines without length are drawn as OSMesa draws them", "[conformance][smooth]") {
  compare_with_osmesa({"repeated_corners", draw_repeated_corners});
}

TEST_CASE("the stipple of antialiased strips counts whole steps", "[conformance][smooth]") {
  compare_with_osmesa({"stippled_strips", draw_stippled_strips});
}

} // namespace softgl::test
