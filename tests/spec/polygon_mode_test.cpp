// GL 1.5, 2.6.2, 3.5.4 and 3.5.5: polygons that are not filled.
#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

#include "support/runner.h"

namespace softgl::test {
namespace {

enum class Path { Immediate, List, Arrays, Elements };
Path path; // these are read by the scenes
GLenum primitive, mode;
std::vector<GLboolean> flags;
bool late, front_first, along_view;

// Six corners of two squares, in the order that the primitive wants: (-0.8, 0, 0.8) x (-0.8, 0.8).
std::vector<Float3> corners() {
  const Float3 p[6] = {{-0.8f, -0.8f, 0}, {-0.8f, 0.8f, 0}, {0, -0.8f, 0},
                       {0, 0.8f, 0},      {0.8f, -0.8f, 0}, {0.8f, 0.8f, 0}};
  switch (primitive) {
  case GL_TRIANGLE_FAN: return {p[0], p[1], p[3], p[5], p[4], p[2]};
  case GL_POLYGON: return {p[0], p[1], p[3], p[5], p[4], p[2]};
  case GL_QUADS: return {p[0], p[1], p[3], p[2]};
  default: return {p[0], p[1], p[2], p[3], p[4], p[5]};
  }
}

void draw_squares(Stage& s) {
  const Gl& gl = s.gl;
  const std::vector<Float3> v = corners();
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.PolygonMode(GL_FRONT_AND_BACK, mode);
  if (path == Path::Immediate || path == Path::List) {
    if (path == Path::List) gl.NewList(1, GL_COMPILE);
    gl.Begin(primitive);
    for (size_t i = 0; i < v.size(); ++i) gl.EdgeFlag(flags[i]), gl.Vertex3fv(v[i].data());
    gl.End();
    if (path == Path::List) gl.EndList(), gl.CallList(1);
    return gl.Finish();
  }
  const GLubyte index[6] = {0, 1, 2, 3, 4, 5};
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_EDGE_FLAG_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, v.data());
  gl.EdgeFlagPointer(0, flags.data());
  if (path == Path::Arrays)
    gl.DrawArrays(primitive, 0, GLsizei(v.size()));
  else
    gl.DrawElements(primitive, GLsizei(v.size()), GL_UNSIGNED_BYTE, index);
  gl.Finish();
}

Picture squares(const Gl& gl, GLenum p, GLenum m, std::vector<GLboolean> f = {1, 1, 1, 1, 1, 1},
                Path with = Path::Immediate) {
  primitive = p, mode = m, flags = std::move(f), path = with;
  return draw(gl, {"squares", draw_squares}, 0);
}

int drawn_pixels(const Picture& p) {
  int n = 0;
  for (size_t i = 0; i < p.color.size(); i += 4) n += p.color[i] != 0;
  return n;
}

// A polygon whose third vertex is the first to have a normal, which changes nothing without lighting.
void draw_late_normal(Stage& s) {
  const Gl& gl = s.gl;
  primitive = GL_POLYGON;
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.Begin(GL_POLYGON);
  int i = 0;
  for (const Float3& v : corners()) {
    if (late && i++ == 3) gl.Normal3f(0, 0, 1);
    gl.Vertex3fv(v.data());
  }
  gl.End();
}

// A polygon of each face, at the same depth; only that of lines is offset.
void draw_offset(Stage& s) {
  const Gl& gl = s.gl;
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.PolygonMode(GL_FRONT, GL_POINT);
  gl.PolygonMode(GL_BACK, GL_LINE);
  gl.PolygonOffset(0, 1e6f);
  gl.Enable(GL_POLYGON_OFFSET_LINE);
  gl.Begin(GL_TRIANGLES);
  for (int k = 0; k < 2; ++k) {
    const bool front = (k == 0) == front_first;
    const GLfloat x = front ? -0.5f : 0.5f;
    gl.Vertex2f(x - 0.3f, -0.5f);
    gl.Vertex2f(x + (front ? 0.3f : 0.0f), front ? -0.5f : 0.5f);
    gl.Vertex2f(x + (front ? 0.0f : 0.3f), front ? 0.5f : -0.5f);
  }
  gl.End();
}

uint32_t farthest(const Picture& p, bool right) {
  uint32_t far = 0;
  for (int y = 0; y < p.height; ++y)
    for (int x = right ? p.width / 2 : 0; x < (right ? p.width : p.width / 2); ++x) {
      const uint32_t z = p.depth[size_t(y) * size_t(p.width) + size_t(x)];
      if (z != 0xffffff && z > far) far = z;
    }
  return far;
}

// A polygon that leaves the view volume, which is smaller than the window, on the right.
void draw_cut(Stage& s) {
  const Gl& gl = s.gl;
  gl.Viewport(0, 0, s.width / 2, s.height);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  const GLdouble plane[4] = {-1, 0, 0, 0.5};
  if (!along_view) gl.ClipPlane(GL_CLIP_PLANE0, plane), gl.Enable(GL_CLIP_PLANE0);
  gl.Begin(GL_TRIANGLES);
  gl.Vertex2f(-0.5f, -0.9f), gl.Vertex2f(1.5f, -0.9f), gl.Vertex2f(1.5f, 0.9f);
  gl.End();
}

int pixels_of_column(const Picture& p, int x) {
  int n = 0;
  for (int y = 0; y < p.height; ++y) n += p.color[4 * (size_t(y) * size_t(p.width) + size_t(x))] != 0;
  return n;
}

// A red front and a green back, lit for each fragment; the polygon faces away.
void draw_lit_back(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat one[4] = {1, 1, 1, 1}, red[4] = {1, 0, 0, 1}, green[4] = {0, 1, 0, 1};
  gl.ShadeModel(0x80EA); // GL_PHONG_WIN
  gl.Enable(GL_LIGHTING);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, one);
  gl.Materialfv(GL_FRONT, GL_AMBIENT, red);
  gl.Materialfv(GL_BACK, GL_AMBIENT, green);
  gl.PolygonMode(GL_FRONT_AND_BACK, mode);
  gl.Begin(GL_TRIANGLES);
  gl.Vertex2f(-0.5f, -0.5f), gl.Vertex2f(0, 0.5f), gl.Vertex2f(0.5f, -0.5f);
  gl.End();
}

} // namespace

TEST_CASE("polygons are drawn by their edges and corners", "[spec][polygon_mode]") {
  // The outlines of whole polygons have no diagonal, those of strips all edges.
  const Picture polygon = squares(softgl_library(), GL_POLYGON, GL_LINE),
                strip = squares(softgl_library(), GL_TRIANGLE_STRIP, GL_LINE);
  const Picture quads = squares(softgl_library(), GL_QUAD_STRIP, GL_LINE);
  CHECK(drawn_pixels(polygon) < drawn_pixels(quads)); // the edge between them
  CHECK(drawn_pixels(quads) < drawn_pixels(strip));   // the diagonals
  CHECK(drawn_pixels(squares(softgl_library(), GL_POLYGON, GL_POINT)) == 6);
  CHECK(drawn_pixels(squares(softgl_library(), GL_QUADS, GL_POINT)) == 4);
  for (GLenum p : {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON})
    for (GLenum m : {GL_LINE, GL_POINT}) {
      const Difference d = compare(squares(softgl_library(), p, m), squares(osmesa_library(), p, m));
      INFO(p << " " << m << " " << d.text);
      CHECK_FALSE(d.any());
    }
}

TEST_CASE("edge flags leave out edges and corners whatever way they come", "[spec][polygon_mode]") {
  for (GLenum p : {GL_TRIANGLES, GL_QUADS, GL_POLYGON})
    for (GLenum m : {GL_LINE, GL_POINT}) {
      const std::vector<GLboolean> some = {1, 0, 0, 1, 0, 1};
      const Picture expected = squares(softgl_library(), p, m, some);
      CHECK(drawn_pixels(expected) < drawn_pixels(squares(softgl_library(), p, m)));
      CHECK(drawn_pixels(squares(softgl_library(), p, m, {0, 0, 0, 0, 0, 0})) == 0);
      CHECK_FALSE(compare(expected, squares(osmesa_library(), p, m, some)).any());
      for (Path with : {Path::List, Path::Arrays, Path::Elements}) {
        INFO(p << " " << m << " path " << int(with));
        CHECK_FALSE(compare(squares(softgl_library(), p, m, some, with), expected).any());
      }
    }
}

TEST_CASE("edge flags change nothing about strips and fans", "[spec][polygon_mode][deviation]") {
  for (GLenum p : {GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUAD_STRIP}) {
    const auto differs = [&](const Gl& gl) {
      return compare(squares(gl, p, GL_LINE, {0, 1, 0, 0, 0, 0}), squares(gl, p, GL_LINE)).any();
    };
    CHECK_FALSE(differs(softgl_library()));
    CHECK(differs(osmesa_library()));
  }
}

TEST_CASE("an attribute that comes late draws no edge inside a polygon", "[spec][polygon_mode][deviation]") {
  const auto differs = [](const Gl& gl) {
    late = false;
    const Picture without = draw(gl, {"late_normal", draw_late_normal}, 0);
    late = true;
    return compare(draw(gl, {"late_normal", draw_late_normal}, 0), without).any();
  };
  CHECK_FALSE(differs(softgl_library()));
  CHECK(differs(osmesa_library()));
}

TEST_CASE("each polygon is offset as its own mode says", "[spec][polygon_mode][deviation]") {
  constexpr uint32_t kOffset = 10388607; // 0.5 + 2000000 / (2^24 - 1), as a float, of 2^24 - 1
  for (bool first : {false, true}) {
    front_first = first;
    const Scene scene{"offset", draw_offset};
    const Picture ours = draw(softgl_library(), scene, 0);
    CHECK(farthest(ours, false) == 0x800000);
    CHECK(farthest(ours, true) == kOffset);
    const Picture theirs = draw(osmesa_library(), scene, 0);
    CHECK(farthest(theirs, false) == (first ? 0x800000u : kOffset));
    CHECK(farthest(theirs, true) == farthest(theirs, false));
  }
}

TEST_CASE("edges along clip planes are drawn, those along the view volume are not", "[spec][polygon_mode]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    along_view = true;
    const Picture view = draw(*gl, {"cut", draw_cut}, 0);
    along_view = false;
    const Picture plane = draw(*gl, {"cut", draw_cut}, 0);
    const int right = view.width / 2 - 1, at_plane = view.width * 3 / 8;
    CHECK(pixels_of_column(view, right) < 5);
    CHECK(std::max(pixels_of_column(plane, at_plane), pixels_of_column(plane, at_plane - 1)) > 20);
  }
}

TEST_CASE("lines and points of a polygon that faces away have the back material's light",
          "[spec][polygon_mode][phong]") {
  for (GLenum m : {GL_LINE, GL_POINT, GL_FILL}) {
    mode = m;
    const Picture p = draw(softgl_library(), {"lit_back", draw_lit_back}, 0);
    int red = 0, green = 0;
    for (size_t i = 0; i < p.color.size(); i += 4) red += p.color[i] != 0, green += p.color[i + 1] != 0;
    CHECK(red == 0);
    CHECK(green > 0);
  }
}

TEST_CASE("a list with too few vertices for a polygon draws none of it",
          "[spec][polygon_mode][lists][deviation]") {
  struct Needed {
    GLenum primitive;
    int vertices;
  };
  for (const Needed& needed : {Needed{GL_TRIANGLES, 3},
                               {GL_TRIANGLE_STRIP, 3},
                               {GL_TRIANGLE_FAN, 3},
                               {GL_QUADS, 4},
                               {GL_QUAD_STRIP, 4},
                               {GL_POLYGON, 3}})
    for (const GLenum polygons : {GL_FILL, GL_LINE, GL_POINT})
      for (int count = 1; count <= needed.vertices; ++count) {
        INFO("primitive " << needed.primitive << " mode " << polygons << " of " << count);
        const Scene scene{"too_few", [&](Stage& s) {
                            s.gl.PolygonMode(GL_FRONT_AND_BACK, polygons);
                            s.gl.NewList(1, GL_COMPILE);
                            s.gl.Begin(needed.primitive);
                            for (int i = 0; i < count; ++i)
                              s.gl.Vertex2f(i & 1 ? 0.5f : -0.5f, i & 2 ? 0.6f : -0.4f);
                            s.gl.End();
                            s.gl.EndList();
                            s.gl.CallList(1);
                          }};
        const Picture p = draw(softgl_library(), scene, 0);
        const bool empty = std::count(p.color.begin(), p.color.end(), 0) == std::ptrdiff_t(p.color.size());
        CHECK(empty == (count < needed.vertices));
      }
}

} // namespace softgl::test
