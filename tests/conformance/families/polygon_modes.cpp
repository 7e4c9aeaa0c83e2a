// Polygons that are changed before they are rasterized: drawn as lines and points, with all that is different
// then (culling, colors of two sides, offset, edge flags, stipple, clipping), and filled ones.
#include "conformance/families/common.h"

namespace softgl::test {

static void random_modes(Stage& s) {
  const GLenum front = s.random.pick({GL_LINE, GL_LINE, GL_POINT, GL_FILL}),
               back = s.random.pick({GL_LINE, GL_POINT, GL_FILL});
  s.gl.PolygonMode(GL_FRONT, front);
  s.gl.PolygonMode(GL_BACK, s.random.chance(50) ? front : back);
  s.gl.LineWidth(s.random.chance(60) ? 1.0f : s.random.real(0.1f, 6));
  s.gl.PointSize(s.random.chance(30) ? 1.0f : s.random.real(0.1f, 8));
}

// All enabled or none: where the faces have modes of their own OSMesa asks for the first polygon's.
static void random_offset(Stage& s) {
  for (GLenum mode : {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT})
    s.gl.Disable(mode);
  if (!s.random.chance(40)) return;
  for (GLenum mode : {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT})
    s.gl.Enable(mode);
  const float units = s.random.pick({0.0f, 1.0f, -1.0f, 100.0f, -5000.0f, 1e6f});
  s.gl.PolygonOffset(s.random.real(-3, 3), units);
}

static void random_two_sided_light(Stage& s) {
  const Gl& gl = s.gl;
  gl.Disable(GL_LIGHTING);
  if (!s.random.chance(30)) return;
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, s.random.chance(70));
  for (GLenum face : {GL_FRONT, GL_BACK}) {
    const Float4 diffuse = s.random.color();
    gl.Materialfv(face, GL_DIFFUSE, diffuse.data());
  }
}

// A polygon whose vertices all have the same attributes: where one comes later OSMesa cuts the polygon in two
// and draws the edge between the parts (reference/DEVIATIONS.md).
static void polygon(Stage& s) {
  const int count = s.random.integer(3, 12);
  const std::vector<Float4> p = random_positions(s, GL_POLYGON, count, Spread::Any, false);
  s.gl.Begin(GL_POLYGON);
  for (int i = 0; i < count; i++) {
    const Float4 color = s.random.color();
    const Float3 normal = s.random.direction();
    s.gl.Color4fv(color.data());
    s.gl.Normal3fv(normal.data());
    s.gl.Vertex4fv(p[size_t(i)].data());
  }
  s.gl.End();
}

static void draw_polygon_modes(Stage& s) {
  random_canvas(s);
  for (int batch = s.random.integer(1, 4); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_culling(s);
    random_depth(s, 50);
    random_modes(s);
    random_offset(s);
    random_two_sided_light(s);
    s.gl.ShadeModel(s.random.chance(60) ? GL_SMOOTH : GL_FLAT);
    PrimitiveOptions options;
    options.mode = s.random.pick({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,
                                  GL_QUAD_STRIP, GL_POLYGON});
    options.normals = true;
    options.secondary_colors = s.random.chance(20);
    if (options.secondary_colors) s.gl.Enable(GL_COLOR_SUM);
    if (s.random.chance(20)) random_fog(s);
    if (options.mode == GL_POLYGON)
      polygon(s);
    else
      random_primitive(s, options);
    s.gl.Disable(GL_COLOR_SUM);
    s.gl.Disable(GL_FOG);
  }
}

// Polygons whose edges are partly marked as inner ones, whole and cut by planes, their lines stippled or not.
static void draw_edge_flags(Stage& s) {
  const Gl& gl = s.gl;
  random_canvas(s);
  for (int batch = s.random.integer(1, 4); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_depth(s, 30);
    gl.PolygonMode(GL_FRONT_AND_BACK, s.random.pick({GL_LINE, GL_LINE, GL_POINT}));
    gl.LineWidth(s.random.chance(60) ? 1.0f : 3.0f);
    gl.PointSize(4);
    gl.Disable(GL_LINE_STIPPLE);
    if (s.random.chance(40)) {
      gl.Enable(GL_LINE_STIPPLE);
      const auto pattern = GLushort(s.random.bits());
      gl.LineStipple(s.random.integer(1, 4), pattern);
    }
    gl.Disable(GL_CLIP_PLANE0);
    if (s.random.chance(40)) {
      const Float3 d = s.random.direction();
      const GLdouble plane[4] = {d[0], d[1], d[2], s.random.real(-0.1f, 0.5f)};
      gl.ClipPlane(GL_CLIP_PLANE0, plane);
      gl.Enable(GL_CLIP_PLANE0);
    }
    gl.ShadeModel(s.random.chance(60) ? GL_SMOOTH : GL_FLAT);
    const GLenum mode = s.random.pick({GL_TRIANGLES, GL_QUADS, GL_POLYGON});
    const int count = vertices_of(mode, s.random.integer(1, 8));
    const std::vector<Float4> p =
        random_positions(s, mode, count, s.random.pick({Spread::View, Spread::Any}), false);
    gl.Begin(mode);
    for (int i = 0; i < count; i++) {
      const Float4 color = s.random.color();
      gl.Color4fv(color.data());
      gl.EdgeFlag(s.random.chance(60));
      gl.Vertex4fv(p[size_t(i)].data());
    }
    gl.End();
  }
}

// Filled polygons, which OSMesa colors and offsets at their vertices wherever it could have smooth or
// stippled points or lines. Where it could have smooth ones the state is set once: OSMesa draws with the old
// one after that (DEVIATIONS.md).
static void draw_staged_polygons(Stage& s) {
  const Gl& gl = s.gl;
  random_canvas(s);
  const bool smooth = s.random.chance(50);
  if (smooth) {
    gl.Enable(s.random.pick({GL_LINE_SMOOTH, GL_POINT_SMOOTH}));
    if (s.random.chance(30)) gl.Enable(GL_POINT_SPRITE);
  }
  for (int batch = smooth ? 1 : s.random.integer(1, 4); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_culling(s);
    random_depth(s, 80);
    random_offset(s);
    random_two_sided_light(s);
    for (GLenum what : {GL_LINE_STIPPLE, GL_POLYGON_STIPPLE})
      s.random.chance(50) ? gl.Enable(what) : gl.Disable(what);
    gl.LineStipple(1, s.random.chance(50) ? 0xffff : 0x0f0f);
    gl.ShadeModel(s.random.chance(60) ? GL_SMOOTH : GL_FLAT);
    PrimitiveOptions options;
    options.normals = true;
    options.secondary_colors = s.random.chance(20);
    if (options.secondary_colors) gl.Enable(GL_COLOR_SUM);
    if (s.random.chance(20)) random_fog(s);
    options.mode = s.random.pick({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,
                                  GL_QUAD_STRIP, GL_POLYGON});
    random_primitive(s, options);
    gl.Disable(GL_COLOR_SUM);
    gl.Disable(GL_FOG);
  }
}

static SceneRegistration staged{{"staged_polygons", draw_staged_polygons, true}};
static SceneRegistration modes{{"polygon_modes", draw_polygon_modes, true}},
    flags{{"edge_flags", draw_edge_flags, true}};

} // namespace softgl::test
