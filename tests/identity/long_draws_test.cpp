// Draws that are cut in pieces: their vertices are shaded piece by piece where they are read in order, and
// all at once where there are indices. Both draw the same.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <string>

#include "support/environment.h"
#include "support/runner.h"

namespace softgl::test {
namespace {

/// 20,001 colored vertices on a spiral, part of it outside the view, so that clipping has work too.
struct Spiral {
  std::vector<float> position, color;
  std::vector<GLuint> index;
  Spiral() : index(20001) {
    std::iota(index.begin(), index.end(), 0u);
    for (size_t i = 0; i < index.size(); ++i) {
      const float t = float(i) / float(index.size()), angle = 200.0f * t,
                  radius = 1.3f * t + 0.06f * float(i % 3);
      position.insert(position.end(),
                      {radius * std::cos(angle), radius * std::sin(angle), 1.4f * t - 0.2f * float(i % 2)});
      color.insert(color.end(), {t, float(i % 5) / 4.0f, 1.0f - t});
    }
  }
};

GLenum mode; // read by the scene while it draws
bool indexed;

void draw_spiral(Stage& s) {
  static const Spiral spiral;
  s.gl.Enable(GL_DEPTH_TEST);
  s.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  s.gl.PointSize(3);
  s.gl.EnableClientState(GL_VERTEX_ARRAY);
  s.gl.VertexPointer(3, GL_FLOAT, 0, spiral.position.data());
  s.gl.EnableClientState(GL_COLOR_ARRAY);
  s.gl.ColorPointer(3, GL_FLOAT, 0, spiral.color.data());
  const auto count = GLsizei(spiral.index.size()) - 1; // not from the first vertex
  if (indexed)
    s.gl.DrawElements(mode, count, GL_UNSIGNED_INT, spiral.index.data() + 1);
  else
    s.gl.DrawArrays(mode, 1, count);
}

Picture spiral_of(const Gl& gl, bool with_indices) {
  indexed = with_indices;
  return draw(gl, {"spiral", draw_spiral}, 0);
}

} // namespace

TEST_CASE("long draws with and without indices draw the same", "[identity]") {
  mode = GENERATE(as<GLenum>(), GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_TRIANGLES,
                  GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON);
  const Picture arrays = spiral_of(softgl_library(), false), elements = spiral_of(softgl_library(), true);
  INFO("mode " << mode);
  CHECK(compare(arrays, elements).text == std::string());
  if (mode == GL_QUADS) return; // OSMesa cuts clipped ones along the other diagonal (reference/DEVIATIONS.md)
  CHECK(compare(arrays, spiral_of(osmesa_library(), false)).text == std::string());
}

} // namespace softgl::test
