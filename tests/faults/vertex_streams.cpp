// Begin and End: many vertices, attributes that come and go, every kind of primitive.
#include "faults/streams.h"

#include <cmath>

namespace softgl::test {
namespace {

Float3 position(Player& p) {
  Float3 v;
  for (float& x : v) x = p.random.real(-1, 1);
  return v;
}
void random_color(Player& p) {
  const Float4 c = p.random.color();
  p.gl.Color4fv(c.data());
}
void random_vertex(Player& p) {
  const Float3 v = position(p);
  p.gl.Vertex3fv(v.data());
}

/// More vertices than a piece of memory holds, in every mode: the runs are split.
void many_vertices(Player& p) {
  for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
    p.gl.Begin(mode);
    for (int i = 0; i < 9000; ++i) {
      if (i % 100 == 0) random_color(p);
      const float a = float(i) * 0.01f, r = 0.3f + 0.5f * float(i) / 9000;
      p.gl.Vertex2f(r * std::cos(a), r * std::sin(a));
    }
    p.gl.End();
    p.check();
  }
  p.picture();
}

/// Attributes that are set for the first time late in a primitive: the vertices that wait are widened.
void late_attributes(Player& p) {
  for (GLenum mode : {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_LINE_LOOP, GL_QUADS}) {
    p.gl.Begin(mode);
    for (int i = 0; i < 3600; ++i) {
      if (i == 100) random_color(p);
      if (i == 900) p.gl.Normal3f(0, 0, 1);
      if (i == 1200) p.gl.TexCoord2f(0.5f, 0.5f);
      if (i == 1500) p.gl.SecondaryColor3f(0.1f, 0.2f, 0.3f);
      if (i == 1800) p.gl.FogCoordf(0.5f);
      if (i == 2400) p.gl.Materialf(GL_FRONT, GL_SHININESS, 20);
      if (i == 3000) p.gl.MultiTexCoord4f(GL_TEXTURE3, 1, 2, 3, 4);
      if (i % 7 == 0) random_color(p);
      random_vertex(p);
    }
    p.gl.End();
    p.check();
  }
  p.picture();
}

/// State that changes between small primitives: many runs, many draws.
void small_runs(Player& p) {
  const Gl& gl = p.gl;
  gl.Enable(GL_DEPTH_TEST);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (int i = 0; i < 60; ++i) {
    if (i % 3 == 0) gl.Translatef(0.01f, 0, 0);
    if (i % 5 == 0) gl.Enable(i % 10 ? GL_LIGHTING : GL_BLEND);
    if (i % 7 == 0) gl.ShadeModel(i % 14 ? GL_FLAT : GL_SMOOTH);
    if (i % 11 == 0) gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 45);
    random_color(p);
    gl.Begin(i % 2 ? GL_TRIANGLE_STRIP : GL_TRIANGLES);
    for (int k = 0; k < 9; ++k) {
      if (k % 2) gl.Normal3f(0, 0, 1);
      random_vertex(p);
    }
    gl.End();
    if (i % 4 == 0) gl.Rectf(-0.5f, -0.5f, 0.1f, 0.2f);
    if (i % 20 == 19) p.picture();
  }
  p.check();
  p.picture();
}

/// Antialiased points, lines and polygons.
void antialiased(Player& p) {
  const Gl& gl = p.gl;
  for (GLenum smooth : {GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH}) gl.Enable(smooth);
  for (GLenum primitive : {GL_POINTS, GL_LINES, GL_TRIANGLES}) {
    gl.Begin(primitive);
    for (int i = 0; i < 600; ++i) random_vertex(p);
    gl.End();
    gl.Finish();
    p.check();
  }
}

/// Clipped and culled polygons in line mode, stippled lines that may not be cut, user clip planes.
void clipped_and_stippled(Player& p) {
  const Gl& gl = p.gl;
  const GLdouble plane[4] = {1, 0.5, 0, 0.1};
  gl.ClipPlane(GL_CLIP_PLANE0, plane);
  gl.Enable(GL_CLIP_PLANE0);
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineStipple(3, 0x5a5a);
  gl.Begin(GL_LINE_STRIP);
  for (int i = 0; i < 6000; ++i) random_vertex(p);
  gl.End();
  p.check();
  for (GLenum mode : {GL_POINT, GL_LINE, GL_FILL}) {
    gl.PolygonMode(GL_FRONT_AND_BACK, mode);
    for (GLenum primitive : {GL_TRIANGLES, GL_POLYGON, GL_QUADS}) {
      gl.Begin(primitive);
      for (int i = 0; i < 24; ++i) {
        random_color(p);
        const Float3 v = position(p);
        gl.Vertex3f(2 * v[0], 2 * v[1], 2 * v[2]);
      }
      gl.End();
    }
  }
  p.check();
  p.picture();
}

/// Maps of all sizes, meshes larger than a piece of memory, and both in lists.
void evaluators(Player& p) {
  const Gl& gl = p.gl;
  std::vector<GLfloat> points(30 * 30 * 4);
  const auto maps = [&](GLint order) {
    for (GLfloat& v : points) v = p.random.real(0, 1);
    gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, order, points.data());
    gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 4 * order, order, 0, 1, 4, order, points.data());
    gl.Map2f(GL_MAP2_COLOR_4, 0, 1, 4 * order, order, 0, 1, 4, order, points.data());
    p.check();
  };
  for (const GLenum enabled : {GL_MAP1_VERTEX_3, GL_MAP2_VERTEX_3, GL_MAP2_COLOR_4, GL_AUTO_NORMAL})
    gl.Enable(enabled);
  gl.MapGrid1f(20, 0, 1);
  gl.MapGrid2f(60, 0, 1, 60, 0, 1);
  for (const GLint order : {1, 2, 4, 30}) {
    maps(order);
    gl.EvalMesh1(GL_LINE, 0, 20);
    gl.EvalMesh2(GL_LINE, 0, 12, 0, 12);
    p.check();
  }
  maps(4);
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE_AND_EXECUTE);
  maps(3);
  gl.Begin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 40; ++i) {
    gl.EvalPoint2(i, 40 - i);
    if (i % 8 == 0) random_vertex(p);
  }
  gl.End();
  gl.EvalMesh2(GL_FILL, 0, 60, 0, 60);
  gl.EndList();
  p.check();
  gl.CallList(list);
  p.check();
  p.picture();
  gl.DeleteLists(list, 1);
  maps(1); // of the next stream's initial state only the points of order 1 are left
}

} // namespace

const std::vector<Stream>& vertex_streams() {
  static const std::vector<Stream> streams = {
      {"vertices.many", many_vertices},           {"vertices.late_attributes", late_attributes},
      {"vertices.small_runs", small_runs},        {"vertices.antialiased", antialiased},
      {"vertices.clipped", clipped_and_stippled}, {"vertices.evaluators", evaluators}};
  return streams;
}

} // namespace softgl::test
