// GL_EXT_provoking_vertex: which vertex gives a flat primitive its color (table 2.12), however the vertices
// come and whatever becomes of the primitive.
#include <catch2/catch.hpp>

#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

struct Place {
  float x, y;
};

/// Vertices, and of each primitive a place inside and the vertex (from 0) of either convention.
struct Expectation {
  GLenum mode;
  std::vector<Place> vertex;
  struct {
    Place inside;
    int first, last;
  } primitive[2];
};

// Primitive 0 is on the left, 1 on the right; coordinates from -1 to 1.
const Expectation kTable[] = {
    {GL_LINES, {{-0.9f, 0}, {-0.1f, 0}, {0.1f, 0}, {0.9f, 0}}, {{{-0.5f, 0}, 0, 1}, {{0.5f, 0}, 2, 3}}},
    {GL_LINE_STRIP, {{-0.9f, 0}, {0, 0}, {0.9f, 0}}, {{{-0.5f, 0}, 0, 1}, {{0.5f, 0}, 1, 2}}},
    // The closing line goes from the last vertex to the first one.
    {GL_LINE_LOOP,
     {{-0.9f, 0}, {0, 0}, {0, -0.9f}, {-0.9f, -0.9f}},
     {{{-0.5f, 0}, 0, 1}, {{-0.9f, -0.5f}, 3, 0}}},
    {GL_TRIANGLES,
     {{-0.9f, -0.9f}, {-0.1f, -0.9f}, {-0.5f, 0.9f}, {0.1f, -0.9f}, {0.9f, -0.9f}, {0.5f, 0.9f}},
     {{{-0.5f, -0.3f}, 0, 2}, {{0.5f, -0.3f}, 3, 5}}},
    {GL_TRIANGLE_STRIP,
     {{-0.9f, -0.9f}, {-0.9f, 0.9f}, {0, -0.9f}, {0.9f, 0.9f}},
     {{{-0.7f, -0.4f}, 0, 2}, {{0.1f, 0.4f}, 1, 3}}},
    {GL_TRIANGLE_FAN,
     {{0, -0.9f}, {-0.9f, 0.5f}, {0, 0.9f}, {0.9f, 0.5f}},
     {{{-0.4f, 0.3f}, 1, 2}, {{0.4f, 0.3f}, 2, 3}}},
    {GL_QUADS,
     {{-0.9f, -0.9f},
      {-0.1f, -0.9f},
      {-0.1f, 0.9f},
      {-0.9f, 0.9f},
      {0.1f, -0.9f},
      {0.9f, -0.9f},
      {0.9f, 0.9f},
      {0.1f, 0.9f}},
     {{{-0.3f, -0.5f}, 3, 3}, {{0.7f, 0.5f}, 7, 7}}},
    {GL_QUAD_STRIP,
     {{-0.9f, -0.9f}, {-0.9f, 0.9f}, {0, -0.9f}, {0, 0.9f}, {0.9f, -0.9f}, {0.9f, 0.9f}},
     {{{-0.7f, 0.5f}, 3, 3}, {{0.7f, -0.5f}, 5, 5}}},
    {GL_POLYGON,
     {{-0.9f, -0.9f}, {0.9f, -0.9f}, {0.9f, 0.9f}, {-0.9f, 0.9f}},
     {{{-0.5f, 0.5f}, 0, 0}, {{0.5f, -0.5f}, 0, 0}}},
};

enum class Way { Immediate, List, Arrays, Elements };

// Vertex i is red 20 * (i + 1).
int red_of(int vertex) { return 20 * (vertex + 1); }

void draw(const Gl& gl, const Expectation& e, Way way) {
  std::vector<GLubyte> color, index;
  for (size_t i = 0; i < e.vertex.size(); ++i) {
    for (int component : {red_of(int(i)), 0, 0, 255}) color.push_back(GLubyte(component));
    index.push_back(GLubyte(i));
  }
  if (way == Way::Immediate || way == Way::List) {
    if (way == Way::List) gl.NewList(1, GL_COMPILE);
    gl.Begin(e.mode);
    for (size_t i = 0; i < e.vertex.size(); ++i) {
      gl.Color4ubv(&color[4 * i]);
      gl.Vertex2f(e.vertex[i].x, e.vertex[i].y);
    }
    gl.End();
    if (way == Way::List) gl.EndList(), gl.CallList(1);
    return;
  }
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(2, GL_FLOAT, 0, e.vertex.data());
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, color.data());
  if (way == Way::Arrays)
    gl.DrawArrays(e.mode, 0, GLsizei(e.vertex.size()));
  else
    gl.DrawElements(e.mode, GLsizei(index.size()), GL_UNSIGNED_BYTE, index.data());
  gl.DisableClientState(GL_VERTEX_ARRAY);
  gl.DisableClientState(GL_COLOR_ARRAY);
}

int red_at(const Gl& gl, Place p) {
  GLubyte rgba[4];
  gl.ReadPixels(GLint((p.x + 1) * 32), GLint((p.y + 1) * 32), 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  return rgba[0];
}

} // namespace

TEST_CASE("the first or the last vertex gives a flat primitive its color", "[spec][provoking_vertex]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.LineWidth(3);
  gl.ShadeModel(GL_FLAT);
  for (const Expectation& e : kTable)
    for (Way way : {Way::Immediate, Way::List, Way::Arrays, Way::Elements})
      for (bool first : {true, false}) {
        INFO("mode " << e.mode << " way " << int(way) << " first " << first);
        gl.ProvokingVertex(first ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        draw(gl, e, way);
        for (const auto& p : e.primitive) CHECK(red_at(gl, p.inside) == red_of(first ? p.first : p.last));
      }
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("the first vertex colors what is clipped, cut by a stipple, seen from behind, or drawn as lines",
          "[spec][provoking_vertex]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.ShadeModel(GL_FLAT);
  gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
  // A plane that cuts the first vertex off.
  const GLdouble upper[4] = {0, 1, 0, 0};
  gl.ClipPlane(GL_CLIP_PLANE0, upper);
  gl.Enable(GL_CLIP_PLANE0);
  const Expectation triangle{GL_TRIANGLES, {{-0.9f, -0.9f}, {0.9f, -0.9f}, {0, 0.9f}}, {}},
      line{GL_LINES, {{0.02f, -0.9f}, {0.02f, 0.9f}}, {}};
  for (const Expectation& e : {triangle, line}) {
    gl.Clear(GL_COLOR_BUFFER_BIT);
    draw(gl, e, Way::Immediate);
    CHECK(red_at(gl, {0, 0.3f}) == red_of(0));
    CHECK(red_at(gl, {0, -0.3f}) == 0);
  }
  gl.Disable(GL_CLIP_PLANE0);
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineStipple(4, 0x5555);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  draw(gl, line, Way::Immediate);
  int seen = 0;
  for (float y = -0.85f; y < 0.9f; y += 0.03125f) {
    const int red = red_at(gl, {0, y});
    CHECK((red == 0 || red == red_of(0)));
    seen += red != 0;
  }
  CHECK(seen > 10);
  gl.Disable(GL_LINE_STIPPLE);
  for (GLenum mode : {GL_LINE, GL_POINT}) {
    gl.PolygonMode(GL_FRONT_AND_BACK, mode);
    gl.PointSize(7);
    gl.LineWidth(3);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    draw(gl, triangle, Way::Immediate);
    CHECK(red_at(gl, mode == GL_LINE ? Place{0.45f, 0} : Place{0, 0.88f}) == red_of(0));
  }
}

TEST_CASE("feedback of flat primitives has the color of the first vertex", "[spec][provoking_vertex]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLfloat buffer[64] = {};
  gl.ShadeModel(GL_FLAT);
  gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
  gl.FeedbackBuffer(64, GL_3D_COLOR, buffer);
  gl.RenderMode(GL_FEEDBACK);
  draw(gl, {GL_LINES, {{-0.5f, 0}, {0.5f, 0}}, {}}, Way::Immediate);
  REQUIRE(gl.RenderMode(GL_RENDER) == 15);
  CHECK(buffer[4] == Approx(red_of(0) / 255.0));
  CHECK(buffer[11] == Approx(red_of(0) / 255.0));
}

TEST_CASE("the convention is kept in lists and with the lighting attributes", "[spec][provoking_vertex]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLint value = 0;
  const auto get = [&] {
    gl.GetIntegerv(GL_PROVOKING_VERTEX, &value);
    return GLenum(value);
  };
  CHECK(get() == GL_LAST_VERTEX_CONVENTION);
  gl.NewList(1, GL_COMPILE);
  gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
  gl.EndList();
  CHECK(get() == GL_LAST_VERTEX_CONVENTION);
  gl.PushAttrib(GL_LIGHTING_BIT);
  gl.CallList(1);
  CHECK(get() == GL_FIRST_VERTEX_CONVENTION);
  gl.ProvokingVertex(GL_FLAT);
  CHECK(gl.GetError() == GL_INVALID_ENUM);
  CHECK(get() == GL_FIRST_VERTEX_CONVENTION);
  gl.PopAttrib();
  CHECK(get() == GL_LAST_VERTEX_CONVENTION);
  GLboolean follow = GL_TRUE;
  gl.GetBooleanv(GL_QUADS_FOLLOW_PROVOKING_VERTEX_CONVENTION, &follow);
  CHECK(follow == GL_FALSE);
}
