// Points and lines of any size that glPointSize and glLineWidth take (GL 1.5, 3.3 and 3.4: sizes are clamped
// to the range that is supported).
#include <catch2/catch.hpp>
#include <limits>

#include "support/runner.h"

namespace softgl::test {
namespace {

float size_of_all; // read by the scene

void draw_sizes(Stage& s) {
  s.gl.LineWidth(size_of_all);
  s.gl.PointSize(size_of_all);
  s.gl.Begin(GL_LINES);
  s.gl.Vertex2f(-0.9f, -0.1f), s.gl.Vertex2f(-0.5f, 0.13f);
  s.gl.End();
  s.gl.Begin(GL_POINTS);
  s.gl.Vertex2f(0.3f, 0.3f);
  s.gl.End();
}

Picture drawn(const Gl& gl, float size) {
  size_of_all = size;
  return draw(gl, {"sizes", draw_sizes, false, 600, 600}, 0);
}

} // namespace

TEST_CASE("points and lines are at most 255 pixels wide", "[spec]") {
  const Picture widest = drawn(softgl_library(), 255);
  CHECK(compare(widest, drawn(softgl_library(), 254)).any());
  for (const float size : {255.4f, 256.0f, 300.0f, 1e10f, std::numeric_limits<float>::max(),
                           std::numeric_limits<float>::infinity()}) {
    INFO("size " << size);
    CHECK_FALSE(compare(drawn(softgl_library(), size), widest).any());
    CHECK_FALSE(compare(drawn(osmesa_library(), size), widest).any());
  }
}

TEST_CASE("sizes that are not a number draw what size 1 draws", "[spec]") {
  CHECK_FALSE(
      compare(drawn(softgl_library(), std::numeric_limits<float>::quiet_NaN()), drawn(softgl_library(), 1))
          .any());
}

} // namespace softgl::test
