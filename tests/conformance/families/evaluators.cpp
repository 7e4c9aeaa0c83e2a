// Evaluators: curves and surfaces of all orders, from every kind of map, as meshes, grid points and
// coordinates.
#include "conformance/families/common.h"

namespace softgl::test {

namespace {

constexpr int kColor4 = 0, kIndex = 1, kNormal = 2, kTexCoord1 = 3, kVertex3 = 7, kVertex4 = 8, kTargets = 9;
constexpr int kComponents[kTargets] = {4, 1, 3, 1, 2, 3, 4, 3, 4};

struct Domain {
  float first, last;
};
Domain random_domain(Random& r) {
  if (r.chance(50)) return {0, 1};
  const float first = r.real(-2, 2);
  return {first, first + r.real(0.2f, 3)};
}

int random_order(Random& r, int least) { return r.chance(80) ? r.integer(least, 6) : r.integer(least, 30); }

float control_value(Random& r, int target, int component) {
  switch (target) {
  case kColor4: return r.real(-0.1f, 1.1f);
  case kIndex: return r.real(0, 255);
  case kVertex3: return r.real(-0.4f, 0.4f);
  case kVertex4: return component == 3 ? r.real(0.6f, 1.4f) : r.real(-0.4f, 0.4f);
  default: return r.real(-1, 2);
  }
}

struct Maps {
  int dimensions;
  Domain u, v; // of the vertices
  int least_order;
  bool backwards; // both domains
};

void random_map(Stage& s, const Maps& m, int target) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  const bool vertices = target == kVertex3 || target == kVertex4;
  const int components = kComponents[target];
  int u_order = random_order(r, vertices ? m.least_order : 1),
      v_order = m.dimensions == 2 ? random_order(r, vertices ? m.least_order : 1) : 1;
  if (r.chance(15) && m.dimensions == 2) v_order = u_order;
  const int v_stride = components + (r.chance(20) ? r.integer(1, 3) : 0);
  const int u_stride =
      m.dimensions == 2 ? v_stride * v_order + (r.chance(20) ? r.integer(1, 5) : 0) : v_stride;
  std::vector<float> points(size_t(u_stride) * size_t(u_order));
  for (int i = 0; i < u_order; i++)
    for (int j = 0; j < v_order; j++) {
      float* p = &points[size_t(i * u_stride + j * v_stride)];
      for (int k = 0; k < components; k++) p[k] = control_value(r, target, k);
      if (!vertices) continue; // a sheet that covers a good part of the picture
      if (u_order > 1) p[0] += 1.6f * float(i) / float(u_order - 1) - 0.8f;
      if (v_order > 1) p[1] += 1.6f * float(j) / float(v_order - 1) - 0.8f;
    }
  Domain u = m.u, v = m.v;
  if (!vertices && r.chance(40)) u = random_domain(r);
  if (m.backwards) std::swap(u.first, u.last), std::swap(v.first, v.last);
  const GLenum name = GLenum((m.dimensions == 1 ? GL_MAP1_COLOR_4 : GL_MAP2_COLOR_4) + target);
  if (r.chance(70)) {
    if (m.dimensions == 1)
      gl.Map1f(name, u.first, u.last, u_stride, u_order, points.data());
    else
      gl.Map2f(name, u.first, u.last, u_stride, u_order, v.first, v.last, v_stride, v_order, points.data());
  } else {
    const std::vector<double> doubles(points.begin(), points.end());
    if (m.dimensions == 1)
      gl.Map1d(name, u.first, u.last, u_stride, u_order, doubles.data());
    else
      gl.Map2d(name, u.first, u.last, u_stride, u_order, v.first, v.last, v_stride, v_order, doubles.data());
  }
}

struct Enabled {
  bool normal, texture;
};

void random_maps(Stage& s, const Maps& m, const Enabled& use) {
  Random& r = s.random;
  const auto enable = [&](int target) {
    random_map(s, m, target);
    s.gl.Enable(GLenum((m.dimensions == 1 ? GL_MAP1_COLOR_4 : GL_MAP2_COLOR_4) + target));
  };
  if (r.chance(70)) enable(kColor4);
  if (r.chance(5)) enable(kIndex);
  if (use.normal && r.chance(70)) enable(kNormal);
  if (use.texture)
    for (int i = r.integer(1, 2); i > 0; i--) enable(r.integer(kTexCoord1, kTexCoord1 + 3));
  const int vertex = r.chance(60) ? kVertex3 : kVertex4;
  enable(vertex);
  if (r.chance(5)) enable(kVertex3 + kVertex4 - vertex);
}

// Which points of a grid are used: the same values in both libraries. OSMesa adds steps up, and may miss the
// ends of the grid (reference/DEVIATIONS.md).
struct Range {
  int first, last;
};
bool exact_ends(int n, const Domain& d, const Range& range) {
  const float step = (d.last - d.first) / float(n);
  float sum = d.first + float(range.first) * step;
  for (int i = range.first; i <= range.last; i++, sum += step)
    if ((i == 0 && sum != d.first) || (i == n && sum != d.last)) return false;
  return true;
}
Range random_range(Random& r, int n, const Domain& d) {
  Range range{0, n};
  if (r.chance(30)) {
    range.first = r.integer(-1, n);
    range.last = r.integer(range.first - 1, n + 1);
  }
  if (exact_ends(n, d, range)) return range;
  return {0, n - 1};
}

struct Grid {
  int nu, nv;
  Domain u, v;
};

// Gives all that may have been evaluated: OSMesa forgets what was current (reference/DEVIATIONS.md).
void plain_vertex(Stage& s, bool texture) {
  const Float4 color = s.random.color();
  const Float3 normal = s.random.direction();
  s.gl.Color4fv(color.data());
  s.gl.Normal3fv(normal.data());
  if (texture) {
    const float t = s.random.real(-1, 2);
    s.gl.TexCoord2f(s.random.real(-1, 2), t);
  }
  const Float3 at{s.random.real(-0.9f, 0.9f), s.random.real(-0.9f, 0.9f), s.random.real(-0.9f, 0.9f)};
  s.gl.Vertex3fv(at.data());
}

// Coordinates, grid points and plain vertices between one Begin and End.
void evaluated_primitive(Stage& s, const Maps& m, const Grid& g, bool texture, bool listed) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  const GLenum mode =
      GLenum(r.pick({GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN}));
  // What is set between Begin and End of a list comes late, see reference/DEVIATIONS.md.
  const bool plain = !listed && r.chance(30);
  const int count = vertices_of(mode, r.integer(1, 12));
  gl.Begin(mode);
  for (int i = 0; i < count; i++) {
    const float u = r.real(m.u.first, m.u.last), v = r.real(m.v.first, m.v.last);
    const int p = r.integer(1, g.nu), q = r.integer(1, g.nv);
    const bool grid_point = r.chance(30) && p < g.nu && q < g.nv;
    if (plain && r.chance(30))
      plain_vertex(s, texture);
    else if (m.dimensions == 1 && grid_point)
      gl.EvalPoint1(p);
    else if (m.dimensions == 1)
      gl.EvalCoord1f(u);
    else if (grid_point)
      gl.EvalPoint2(p, q);
    else if (r.chance(70))
      gl.EvalCoord2f(u, v);
    else
      gl.EvalCoord2d(u, v);
  }
  gl.End();
}

void evaluate(Stage& s, const Maps& m, bool smooth, bool texture, bool listed) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  Grid g{r.integer(1, 12), r.integer(1, 12), m.u, m.v};
  if (r.chance(30)) g.u = random_domain(r);
  gl.MapGrid1f(g.nu, g.u.first, g.u.last);
  if (r.chance(50))
    gl.MapGrid2f(g.nu, g.u.first, g.u.last, g.nv, g.v.first, g.v.last);
  else
    gl.MapGrid2d(g.nu, g.u.first, g.u.last, g.nv, g.v.first, g.v.last);
  if (r.chance(30)) return evaluated_primitive(s, m, g, texture, listed);
  const Range in_u = random_range(r, g.nu, g.u), in_v = random_range(r, g.nv, g.v);
  if (m.dimensions == 1) return gl.EvalMesh1(r.chance(60) ? GL_LINE : GL_POINT, in_u.first, in_u.last);
  // Flat strips are quadrilaterals here, and triangles in OSMesa: reference/DEVIATIONS.md.
  const GLenum mode =
      GLenum(smooth ? r.pick({GL_FILL, GL_FILL, GL_FILL, GL_LINE, GL_POINT}) : r.pick({GL_LINE, GL_POINT}));
  gl.EvalMesh2(mode, in_u.first, in_u.last, in_v.first, in_v.last);
}

void random_image(Stage& s) {
  const Gl& gl = s.gl;
  GLubyte texels[16 * 16 * 4];
  for (GLubyte& t : texels) t = GLubyte(s.random.bits() >> 40);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, s.random.chance(50) ? GL_NEAREST : GL_LINEAR);
}

void random_light(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  const Float3 d = r.direction();
  const Float4 position{d[0], d[1], d[2], r.chance(50) ? 1.0f : 0.0f};
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position.data());
  for (GLenum parameter : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) {
    const Float4 color = r.color();
    gl.Materialfv(GL_FRONT_AND_BACK, parameter, color.data());
  }
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, float(r.integer(1, 60)));
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, r.chance(30));
  if (r.chance(60)) gl.Enable(GL_NORMALIZE);
  if (r.chance(40)) {
    gl.ColorMaterial(GL_FRONT, r.chance(50) ? GL_DIFFUSE : GL_AMBIENT_AND_DIFFUSE);
    gl.Enable(GL_COLOR_MATERIAL);
    const Float4 color = r.color(); // OSMesa waits for the next color
    gl.Color4fv(color.data());
  }
}

void draw_evaluators(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  random_canvas(s);
  for (int part = r.integer(1, 3); part > 0; part--) {
    reset_state(s);
    for (int i = 0; i < kTargets; i++) {
      gl.Disable(GLenum(GL_MAP1_COLOR_4 + i));
      gl.Disable(GLenum(GL_MAP2_COLOR_4 + i));
    }
    random_projection(s);
    if (r.chance(50))
      random_modelview(s);
    else
      rigid_modelview(s);
    random_culling(s);
    random_depth(s, 60);
    gl.PointSize(r.chance(50) ? 1.0f : r.real(1, 6));
    gl.LineWidth(r.chance(60) ? 1.0f : r.real(1, 4));
    const bool lit = r.chance(50), texture = r.chance(30), automatic = r.chance(50), smooth = r.chance(85);
    if (lit) random_light(s);
    if (texture) {
      random_image(s);
      gl.Enable(GL_TEXTURE_2D);
    }
    gl.ShadeModel(smooth ? GL_SMOOTH : GL_FLAT);
    (automatic ? gl.Enable : gl.Disable)(GL_AUTO_NORMAL);
    const Domain u = random_domain(r), v = random_domain(r);
    const Maps maps{r.chance(30) ? 1 : 2, u, v, automatic ? 2 : 1, r.chance(10)};
    const Float4 color = r.color();
    const Float3 normal = r.direction();
    gl.Color4fv(color.data());
    gl.Normal3fv(normal.data());
    const bool listed = r.chance(30), maps_listed = r.chance(50);
    const auto list_begins = [&] {
      gl.Finish(); // a color that waits at glNewList does not reach color material: reference/DEVIATIONS.md
      gl.NewList(1, GL_COMPILE);
    };
    if (listed && maps_listed) list_begins();
    random_maps(s, maps, {lit, texture});
    if (listed && !maps_listed) list_begins();
    for (int i = r.integer(1, 3); i > 0; i--) evaluate(s, maps, smooth, texture, listed);
    if (listed) {
      gl.EndList();
      gl.PushMatrix();
      gl.Rotatef(r.real(-90, 90), 0, 0, 1);
      gl.CallList(1);
      gl.PopMatrix();
    }
  }
}

const SceneRegistration registration{{"evaluators", draw_evaluators, true}};

} // namespace
} // namespace softgl::test
