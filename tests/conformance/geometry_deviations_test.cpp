// Where OSMesa's vertices, quadrilaterals and lines leave the specification or depend on history
// (reference/DEVIATIONS.md): softgl's answer, and that OSMesa's is another.
#include <catch2/catch.hpp>

#include <algorithm>

#include "support/runner.h"

namespace softgl::test {
namespace {

enum class Path { Immediate, List, Arrays, Elements };
constexpr Path kPaths[] = {Path::Immediate, Path::List, Path::Arrays, Path::Elements};
Path path; // these are read by the scenes
bool flat, clipped, lit;

// A quadrilateral whose corners 0 and 2 are near and whose corners 1 and 3 are far; another one beside it, or
// beyond.
void draw_bent_quads(Stage& s) {
  const GLfloat right = clipped ? 1.5f : 0.9f;
  const GLfloat v[8][3] = {{-0.5f, -0.5f, -0.5f}, {0.5f, -0.5f, 0.5f}, {0.5f, 0.5f, -0.5f},
                           {-0.5f, 0.5f, 0.5f},   {0.6f, -0.5f, 0},    {right, -0.5f, 0},
                           {right, 0.5f, 0},      {0.6f, 0.5f, 0}};
  const GLubyte index[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  const Gl& gl = s.gl;
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.ShadeModel(flat ? GL_FLAT : GL_SMOOTH);
  gl.VertexPointer(3, GL_FLOAT, 0, v);
  if (path == Path::Arrays || path == Path::Elements) {
    gl.EnableClientState(GL_VERTEX_ARRAY);
    if (path == Path::Arrays)
      gl.DrawArrays(GL_QUADS, 0, 8);
    else
      gl.DrawElements(GL_QUADS, 8, GL_UNSIGNED_BYTE, index);
  } else {
    if (path == Path::List) gl.NewList(1, GL_COMPILE);
    gl.Begin(GL_QUADS);
    for (const auto& vertex : v) gl.Vertex3fv(vertex);
    gl.End();
    if (path == Path::List) gl.EndList(), gl.CallList(1);
  }
  gl.Finish();
}

/// The corner from which the bent quadrilateral is cut: its middle is as near, or as far, as the diagonal.
int diagonal(const Gl& gl) {
  const Picture p = draw(gl, {"bent_quads", draw_bent_quads}, 0);
  return p.depth[size_t(p.height / 2) * p.width + p.width / 2] < 0x800000 ? 0 : 1;
}

// A folded strip, clipped on the left only, whose first color is white; the color of the last two vertices
// comes late.
bool early;
void draw_strip_colored_late(Stage& s) {
  const Gl& gl = s.gl;
  gl.Color4f(1, 1, 1, 1);
  gl.Begin(GL_QUAD_STRIP);
  if (early) gl.Color4f(1, 1, 1, 1); // changes nothing
  gl.Vertex3f(-0.3625f, 0.1823f, -0.6684f), gl.Vertex3f(-1.0044f, -0.4689f, 0.2237f);
  gl.Vertex3f(-0.5895f, -0.7537f, -0.7480f), gl.Vertex3f(0.7669f, 0.0804f, 0.4659f);
  gl.Color4f(0, 0.18f, 0, 0.5f);
  gl.Vertex3f(0.3240f, -0.0947f, -0.0621f), gl.Vertex3f(-0.7276f, -0.2518f, -0.6555f);
  gl.End();
}

// Triangles as thin as a line, and one beside them that is clipped or not.
void draw_thin_triangles(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.Enable(GL_CULL_FACE);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 1300; ++i) {
    const float x = r.real(-0.9f, 0.3f), y = r.real(-0.9f, 0.7f), dx = r.real(0, 0.2f),
                dy = r.real(-0.1f, 0.1f);
    gl.Vertex2f(x, y), gl.Vertex2f(x + dx / 2, y + dy / 2), gl.Vertex2f(x + dx, y + dy);
  }
  gl.Vertex2f(0.9f, 0.9f), gl.Vertex2f(clipped ? 1.5f : 0.95f, 0.9f), gl.Vertex2f(0.9f, 0.95f);
  gl.End();
}

// A point sprite of which the scissor box cuts the lower half off.
constexpr int kScissorBottom = 65;
void draw_sprite_in_scissor(Stage& s) {
  const Gl& gl = s.gl;
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Ortho(0, 160, 0, 160, -1, 1);
  gl.Enable(GL_POINT_SPRITE);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(44, kScissorBottom, 46, 68);
  gl.PointSize(35.79603890445445f);
  gl.Begin(GL_POINTS);
  gl.Vertex2f(50.107274748924084f, 75.54197112445789f);
  gl.End();
}

// A triangle that faces away, each corner with another color: unlit, or lit by ambient light alone, which
// gives the same.
void draw_back_face(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat one[4] = {1, 1, 1, 1}, none[4] = {0, 0, 0, 0};
  if (lit) {
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Lightfv(GL_LIGHT0, GL_AMBIENT, one);
    gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, none);
    gl.Lightfv(GL_LIGHT0, GL_SPECULAR, none);
    gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, none);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    gl.ColorMaterial(GL_BACK, GL_AMBIENT);
    gl.Enable(GL_COLOR_MATERIAL);
  }
  gl.ColorMask(1, 1, 1, 0); // alpha is that of the diffuse color
  gl.Begin(GL_TRIANGLES);
  gl.Color3f(0.2f, 0.9f, 0.3f);
  gl.Vertex2f(-0.8f, -0.8f);
  gl.Color3f(0.7f, 0.4f, 0.8f);
  gl.Vertex2f(0, 0.8f);
  gl.Color3f(0.1f, 0.6f, 1);
  gl.Vertex2f(0.8f, -0.8f);
  gl.End();
}

float distance; // of the point from the eye

// A point of 20 pixels at distance 1, in the middle of the left half; the viewport ends 2 pixels to its
// right.
void draw_distant_point(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat quadratic[3] = {0, 0, 1};
  gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, quadratic);
  gl.PointSize(20);
  gl.Viewport(0, 0, 42, 120);
  gl.MatrixMode(GL_PROJECTION);
  gl.Ortho(0, 42, 0, 120, 0, 100);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Translatef(40, 60, -distance);
  gl.Begin(GL_POINTS);
  gl.Vertex2f(0, 0);
  gl.End();
}

/// How many pixels it covers.
int point_area(const Gl& gl, float at_distance) {
  distance = at_distance;
  const Picture p = draw(gl, {"distant_point", draw_distant_point}, 0);
  return int(std::count(p.color.begin(), p.color.end(), 255)) / 4;
}

bool unused; // there is a vertex out of view that no index names

// A folded quadrilateral of a strip, whose two triangles overlap: the later one is seen.
void draw_folded_strip(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat v[5][2] = {
      {-0.8f, -0.8f}, {unused ? 9.0f : 0.0f, 0}, {-0.8f, 0.8f}, {0.8f, 0.8f}, {0.6f, -0.3f}};
  const GLubyte color[5][3] = {{255, 0, 0}, {0, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}};
  const GLubyte index[6] = {0, 2, 3,
                            4, 3, 4}; // another one without area, for OSMesa to shade all five vertices
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(2, GL_FLOAT, 0, v);
  gl.ColorPointer(3, GL_UNSIGNED_BYTE, 0, color);
  gl.DrawRangeElements(GL_QUAD_STRIP, 0, 4, 6, GL_UNSIGNED_BYTE, index);
  gl.Finish();
}

bool smooth_lines_before; // a flat triangle was drawn while lines were smooth

// A smooth triangle, in front of what was drawn before it, with an offset that is seen in its depths.
void draw_after_smooth_lines(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat v[3][2] = {{-1, -1}, {3, -1}, {-1, 3}};
  gl.Enable(GL_DEPTH_TEST);
  const auto triangle = [&](GLfloat z) {
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) gl.Color3f(i == 0, i == 1, i == 2), gl.Vertex3f(v[i][0], v[i][1], z);
    gl.End();
  };
  if (smooth_lines_before) {
    gl.ShadeModel(GL_FLAT);
    gl.Enable(GL_LINE_SMOOTH);
    triangle(0.5f);
    gl.Disable(GL_LINE_SMOOTH);
    gl.ShadeModel(GL_SMOOTH);
  }
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(0, 1000);
  triangle(0);
}

GLenum type; // of the colors
GLint value;
bool in_array; // or by a command

// Covers the picture with a color of four equal integers.
void draw_integer_color(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat v[3][2] = {{-1, -1}, {3, -1}, {-1, 3}};
  GLbyte bytes[12];
  GLshort shorts[12];
  for (int i = 0; i < 12; i++) bytes[i] = GLbyte(value), shorts[i] = GLshort(value);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(2, GL_FLOAT, 0, v);
  if (in_array) {
    gl.EnableClientState(GL_COLOR_ARRAY);
    if (type == GL_BYTE)
      gl.ColorPointer(4, GL_BYTE, 0, bytes);
    else
      gl.ColorPointer(4, GL_SHORT, 0, shorts);
  } else if (type == GL_BYTE) {
    gl.Color4bv(bytes);
  } else {
    gl.Color4sv(shorts);
  }
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.Finish();
}

int drawn_color(const Gl& gl, GLenum with_type, GLint with_value, bool array) {
  type = with_type, value = with_value, in_array = array;
  return draw(gl, {"integer_color", draw_integer_color}, 0).color[0];
}

} // namespace

TEST_CASE("the state of a draw is seen by it, whatever was smooth before", "[conformance][deviation]") {
  const Scene scene{"after_smooth_lines", draw_after_smooth_lines};
  smooth_lines_before = false;
  const Picture expected = draw(softgl_library(), scene, 0);
  smooth_lines_before = true;
  const Difference d = compare(draw(softgl_library(), scene, 0), expected);
  INFO(d.text);
  CHECK_FALSE(d.any());
}

TEST_CASE("a strip of quadrilaterals may get a color late", "[conformance]") {
  const Scene strip{"strip_colored_late", draw_strip_colored_late};
  auto drawn = [&](const Gl& gl, bool set_early) { return early = set_early, draw(gl, strip, 0); };
  const Picture ours = drawn(softgl_library(), true), late = drawn(softgl_library(), false);
  CHECK_FALSE(compare(ours, drawn(osmesa_library(), true)).any());
  CHECK_FALSE(compare(late, drawn(osmesa_library(), false)).any());
  CHECK(compare(ours, late).any());
}

TEST_CASE("the diagonal of a quadrilateral depends on the shade model only", "[conformance][deviation]") {
  bool osmesa_is_another = false;
  for (Path p : kPaths)
    for (bool f : {false, true})
      for (bool c : {false, true}) {
        path = p, flat = f, clipped = c;
        INFO("path " << int(p) << (f ? " flat" : " smooth") << (c ? " clipped" : ""));
        CHECK(diagonal(softgl_library()) == (f ? 1 : 0));
        if (diagonal(osmesa_library()) != (f ? 1 : 0)) osmesa_is_another = true;
        if (p == Path::Immediate && !f && !c)
          CHECK(diagonal(osmesa_library()) == 0); // where most quadrilaterals are
      }
  CHECK(osmesa_is_another);
}

TEST_CASE("a back material that varies has all its components", "[conformance][deviation]") {
  const Scene scene{"back_face", draw_back_face};
  lit = false;
  const Picture expected = draw(softgl_library(), scene, 0);
  lit = true;
  const Difference ours = compare(draw(softgl_library(), scene, 0), expected);
  INFO(ours.text);
  CHECK_FALSE(ours.any());
  CHECK(compare(draw(osmesa_library(), scene, 0), expected).any());
}

TEST_CASE("the viewport does not cut points that shrink with distance", "[conformance][deviation]") {
  // The distance may be that along the viewing axis (3.3).
  CHECK(point_area(softgl_library(), 1) == 20 * 20);
  CHECK(point_area(softgl_library(), 2) == 10 * 10);
  CHECK(point_area(softgl_library(), 20) == 1);
  CHECK(point_area(osmesa_library(), 1) < 20 * 20);
}

TEST_CASE("a vertex that no index names does not change the order of a strip's triangles",
          "[conformance][deviation]") {
  const Scene scene{"folded_strip", draw_folded_strip};
  const auto difference = [&](const Gl& gl) {
    unused = false;
    const Picture without = draw(gl, scene, 0);
    unused = true;
    return compare(draw(gl, scene, 0), without).any();
  };
  CHECK_FALSE(difference(softgl_library()));
  CHECK(difference(osmesa_library()));
}

TEST_CASE("arrays of signed integers become colors as the arguments of commands do",
          "[conformance][deviation]") {
  for (GLint v : {-128, -1, 0, 1, 2, 31, 64, 127}) {
    INFO("value " << v);
    CHECK(drawn_color(softgl_library(), GL_BYTE, v, true) == std::max(2 * v + 1, 0));
    CHECK(drawn_color(softgl_library(), GL_BYTE, v, false) == std::max(2 * v + 1, 0));
    CHECK(drawn_color(softgl_library(), GL_SHORT, 256 * v + 64, true) ==
          drawn_color(softgl_library(), GL_SHORT, 256 * v + 64, false));
  }
  // (2c + 1) / (2^b - 1) and c / (2^(b-1) - 1) differ where c is small.
  CHECK(drawn_color(softgl_library(), GL_SHORT, 64, true) == 1);
  CHECK(drawn_color(osmesa_library(), GL_SHORT, 64, true) == 0);
  CHECK(drawn_color(osmesa_library(), GL_BYTE, 0, true) == 0);
  CHECK(drawn_color(osmesa_library(), GL_BYTE, 0, false) == 1);
}

TEST_CASE("a triangle is culled by its own vertices only", "[conformance][deviation]") {
  const auto drawn = [](const Gl& gl, bool clip) { // without the column of the triangle beside them
    clipped = clip;
    const Picture p = draw(gl, {"thin_triangles", draw_thin_triangles, false, 512, 512}, 1);
    int count = 0;
    for (size_t i = 0; i < 512 * 512; ++i) count += i % 512 < 480 && p.color[4 * i] != 0;
    return count;
  };
  const int pixels = drawn(softgl_library(), false);
  CHECK(pixels > 0);
  CHECK(drawn(softgl_library(), true) == pixels);
  CHECK(drawn(osmesa_library(), false) == pixels);
  CHECK(drawn(osmesa_library(), true) < pixels);
}

TEST_CASE("The scissor box cuts point sprites", "[conformance][deviation]") {
  const auto drawn_below = [](const Gl& gl) {
    const Picture p = draw(gl, {"sprite_in_scissor", draw_sprite_in_scissor, false, 160, 160}, 0);
    int count = 0;
    for (int x = 0; x < 160; ++x) count += p.color[(size_t(kScissorBottom - 1) * 160 + size_t(x)) * 4] != 0;
    return count;
  };
  CHECK(drawn_below(softgl_library()) == 0);
  CHECK(drawn_below(osmesa_library()) > 0);
}

} // namespace softgl::test
