// GL 1.5, 3.4.2: the counter of a stipple pattern starts at each Begin, and at each line of GL_LINES, and
// nowhere else.
#include <catch2/catch.hpp>

#include <cmath>

#include "spec/state_snapshot.h"
#include "support/runner.h"

namespace softgl::test {
namespace {

constexpr int kVertices = 300000; // more than a chunk of vertices
GLenum mode;                      // read by the scenes
bool in_array, after_another, late_color;

void draw_long_strip(Stage& s) {
  std::vector<Float2> v;
  for (int i = 0; i < kVertices; i++) {
    const float t = float(i) / float(kVertices - 1), turn = 40 * t;
    v.push_back({t * std::cos(turn), t * std::sin(turn)});
  }
  const Gl& gl = s.gl;
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineStipple(2, 0x3fff); // every line of a spiral is far shorter than the pattern
  if (in_array) {
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, v.data());
    gl.DrawArrays(mode, 0, kVertices);
    return gl.Finish();
  }
  gl.Begin(mode);
  for (const Float2& p : v) gl.Vertex2fv(p.data());
  gl.End();
}

// The first line of the strip is out of view. Another strip before it leaves nothing but, in OSMesa, its
// counter.
void draw_after_another(Stage& s) {
  const Gl& gl = s.gl;
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineStipple(1, 0x00ff);
  if (after_another) {
    gl.ColorMask(0, 0, 0, 0);
    gl.Begin(GL_LINE_STRIP);
    gl.Vertex2f(-0.9f, 0);
    gl.Vertex2f(-0.8f, 0);
    gl.End();
    gl.ColorMask(1, 1, 1, 1);
  }
  gl.Begin(GL_LINE_STRIP);
  gl.Vertex2f(3, 3);
  gl.Vertex2f(3, 0);
  gl.Vertex2f(-0.9f, 0);
  gl.End();
}

// The second color has four components to OSMesa, which cuts the strip there.
void draw_cut_strip(Stage& s) {
  const Gl& gl = s.gl;
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineStipple(1, 0x00ff);
  gl.Begin(GL_LINE_STRIP);
  gl.Color3f(1, 1, 1);
  gl.Vertex2f(-0.9f, 0);
  gl.Vertex2f(-0.83f, 0);
  if (late_color) gl.Color3d(1, 1, 1);
  gl.Vertex2f(0.9f, 0);
  gl.End();
}

bool changed_by_late_color(const Gl& gl) {
  const Scene scene{"cut_strip", draw_cut_strip};
  late_color = false;
  const Picture without = draw(gl, scene, 0);
  late_color = true;
  return compare(draw(gl, scene, 0), without).any();
}

// Lines around a polygon. Its color, which stays white, is set in front of a vertex or not at all.
GLushort pattern;
int colored_vertex;
void draw_colored_polygon(Stage& s) {
  const Gl& gl = s.gl;
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineStipple(3, pattern);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.Begin(mode);
  for (int i = 0; i < 8; i++) {
    if (i == colored_vertex) gl.Color3f(1, 1, 1);
    gl.Vertex2f(0.9f * std::cos(float(i) * 0.7f), 0.9f * std::sin(float(i) * 0.7f));
  }
  gl.End();
}

bool changed_by_another(const Gl& gl) {
  const Scene scene{"after_another", draw_after_another};
  after_another = false;
  const Picture alone = draw(gl, scene, 0);
  after_another = true;
  return compare(draw(gl, scene, 0), alone).any();
}

} // namespace

TEST_CASE("the stipple pattern of a long strip runs on", "[spec][lines]") {
  for (GLenum m : {GL_LINE_STRIP, GL_LINE_LOOP}) {
    mode = m;
    const Scene scene{"long_strip", draw_long_strip};
    in_array = true;
    const Picture expected = draw(softgl_library(), scene, 0);
    CHECK_FALSE(compare(expected, draw(osmesa_library(), scene, 0)).any());
    in_array = false;
    const Difference d = compare(draw(softgl_library(), scene, 0), expected);
    INFO(d.text);
    CHECK_FALSE(d.any());
  }
}

TEST_CASE("the stipple pattern starts anew with a strip whose first line is out of view",
          "[spec][lines][deviation]") {
  CHECK_FALSE(changed_by_another(softgl_library()));
  CHECK(changed_by_another(osmesa_library()));
}

TEST_CASE("a color that comes late changes neither the pattern nor the edges of lines", "[spec][lines]") {
  const Scene scene{"colored_polygon", draw_colored_polygon};
  for (const GLenum m : {GL_LINE_STRIP, GL_LINE_LOOP, GL_POLYGON})
    for (const GLushort p : {0x00ff, 0xffff}) {
      mode = m, pattern = p, colored_vertex = -1;
      const Picture expected = draw(softgl_library(), scene, 0);
      for (colored_vertex = 1; colored_vertex < 8; colored_vertex++) {
        const Difference d = compare(draw(softgl_library(), scene, 0), expected);
        INFO("mode " << m << ", pattern " << p << ", vertex " << colored_vertex << ": " << d.text);
        CHECK_FALSE(d.any());
      }
    }
}

// In OSMesa such a strip becomes single lines (reference/DEVIATIONS.md).
TEST_CASE("a strip in front of lines in a list has one pattern", "[spec][lines][lists]") {
  const Gl& gl = softgl_library();
  const auto picture = [&](bool listed) {
    CurrentContext context(gl);
    gl.Enable(GL_LINE_STIPPLE);
    gl.LineStipple(1, 0x00ff);
    if (listed) gl.NewList(1, GL_COMPILE);
    gl.Begin(GL_LINE_STRIP);
    for (const float x : {-0.9f, -0.3f, 0.9f}) gl.Vertex2f(x, 0.5f);
    gl.End();
    gl.Begin(GL_LINES);
    for (const float x : {-0.9f, -0.3f, 0.0f, 0.9f}) gl.Vertex2f(x, 0);
    gl.End();
    if (listed) gl.EndList(), gl.CallList(1);
    std::vector<GLubyte> pixels(64 * 64 * 4);
    gl.ReadPixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  };
  CHECK((picture(true) == picture(false)));
}

TEST_CASE("a color within a strip does not begin its stipple anew", "[spec][lines][deviation]") {
  CHECK_FALSE(changed_by_late_color(softgl_library()));
  CHECK(changed_by_late_color(osmesa_library()));
}

} // namespace softgl::test
