#include "conformance/families/common.h"

#include <cmath>
#include <cstring>

namespace softgl::test {

void random_canvas(Stage& s) {
  const Float4 c = s.random.color();
  s.gl.ClearColor(c[0], c[1], c[2], c[3]);
  s.gl.ClearDepth(s.random.chance(50) ? 1.0 : double(s.random.real(0, 1)));
  s.gl.ClearStencil(s.random.integer(0, 255));
  s.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  if (s.random.chance(15)) {
    const int x = s.random.integer(-20, 40), y = s.random.integer(-20, 40);
    const int w = s.random.integer(1, s.width * 2), h = s.random.integer(1, s.height * 2);
    s.gl.Viewport(x, y, w, h);
  } else if (s.random.chance(3)) {
    s.gl.Viewport(-700, -500, 2000, 1500);
  }
}

bool random_projection(Stage& s) {
  const Gl& gl = s.gl;
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  bool perspective = false;
  switch (s.random.integer(0, 5)) {
  case 0: break;
  case 1: {
    const float l = s.random.real(-1.5f, -0.5f), r = s.random.real(0.5f, 1.5f),
                b = s.random.real(-1.5f, -0.5f), t = s.random.real(0.5f, 1.5f);
    gl.Ortho(l, r, b, t, -4, 4);
    break;
  }
  case 2:
  case 3: {
    const float n = s.random.pick({0.5f, 1.0f, 2.0f}), w = s.random.real(0.3f, 0.8f) * n,
                h = s.random.real(0.3f, 0.8f) * n;
    gl.Frustum(-w, w, -h, h, n, s.random.pick({6.0f, 10.0f, 100.0f}));
    perspective = true;
    break;
  }
  case 4: {
    const float n = s.random.real(0.1f, 1.0f), l = s.random.real(-0.8f, -0.1f) * n,
                r = s.random.real(0.2f, 0.8f) * n;
    const float b = s.random.real(-0.8f, -0.1f) * n, t = s.random.real(0.2f, 0.8f) * n;
    gl.Frustum(l, r, b, t, n, 20);
    perspective = true;
    break;
  }
  default:
    gl.Ortho(0, s.width, 0, s.height, -100, 100);
    gl.Scalef(s.width * 0.4f, s.height * 0.4f, 1);
    gl.Translatef(1.25f, 1.25f, 0);
    break;
  }
  if (perspective) gl.Translatef(0, 0, s.random.real(-4, -2));
  gl.MatrixMode(GL_MODELVIEW);
  return perspective;
}

void rigid_modelview(Stage& s) {
  const Gl& gl = s.gl;
  gl.LoadIdentity();
  if (s.random.chance(40)) {
    const Float3 t{s.random.real(-0.4f, 0.4f), s.random.real(-0.4f, 0.4f), s.random.real(-0.4f, 0.4f)};
    gl.Translatef(t[0], t[1], t[2]);
  }
  for (int i = s.random.integer(0, 2); i > 0; i--) {
    const Float3 axis =
        s.random.chance(50) ? Float3{s.random.pick({0.0f, 1.0f}), 0, 1} : s.random.direction();
    gl.Rotatef(s.random.real(-180, 180), axis[0], axis[1], axis[2]);
  }
}

void random_modelview(Stage& s) {
  const Gl& gl = s.gl;
  rigid_modelview(s);
  switch (s.random.integer(0, 7)) {
  case 0: {
    const float f = s.random.real(0.4f, 1.6f);
    gl.Scalef(f, f, f);
    break;
  }
  case 1: {
    const Float3 f{s.random.real(0.5f, 1.5f), s.random.real(-1.5f, -0.5f), s.random.real(0.5f, 1.5f)};
    gl.Scalef(f[0], f[1], f[2]);
    break;
  }
  case 2: {
    GLfloat m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    for (int i : {1, 2, 4, 6, 8, 9}) m[i] = s.random.real(-0.5f, 0.5f);
    gl.MultMatrixf(m);
    break;
  }
  case 3: {
    const Float3 f{s.random.real(0.5f, 1.5f), s.random.real(0.5f, 1.5f), s.random.real(0.5f, 1.5f)};
    gl.Scaled(f[0], f[1], f[2]);
    const double angle = s.random.integer(-8, 8) * 45.0;
    gl.Rotated(angle, 0, s.random.integer(0, 1), 1);
    break;
  }
  default: break;
  }
}

void random_culling(Stage& s) {
  const Gl& gl = s.gl;
  if (!s.random.chance(25)) return gl.Disable(GL_CULL_FACE);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(s.random.chance(45) ? GL_BACK : s.random.chance(80) ? GL_FRONT : GL_FRONT_AND_BACK);
  gl.FrontFace(s.random.chance(50) ? GL_CCW : GL_CW);
}

GLenum random_compare(Stage& s) { return GLenum(GL_NEVER + s.random.integer(0, 7)); }

void random_depth(Stage& s, int percent) {
  const Gl& gl = s.gl;
  if (!s.random.chance(percent)) return gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(s.random.chance(50) ? GLenum(GL_LEQUAL) : random_compare(s));
  gl.DepthMask(s.random.chance(80));
  if (s.random.chance(25)) {
    const double n = s.random.real(-0.2f, 1.2f), f = s.random.real(-0.2f, 1.2f);
    gl.DepthRange(n, f);
  }
}

void random_scissor(Stage& s, int percent) {
  if (!s.random.chance(percent)) return s.gl.Disable(GL_SCISSOR_TEST);
  s.gl.Enable(GL_SCISSOR_TEST);
  const int x = s.random.integer(-10, s.width), y = s.random.integer(-10, s.height);
  const int w = s.random.integer(0, s.width), h = s.random.integer(0, s.height);
  s.gl.Scissor(x, y, w, h);
}

void random_blending(Stage& s) {
  const Gl& gl = s.gl;
  auto factor = [&](bool source) {
    return source ? s.random.pick({GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_DST_COLOR,
                                   GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA,
                                   GL_ONE_MINUS_DST_ALPHA, GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR,
                                   GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, GL_SRC_ALPHA_SATURATE})
                  : s.random.pick({GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_DST_COLOR,
                                   GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA,
                                   GL_ONE_MINUS_DST_ALPHA, GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR,
                                   GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA});
  };
  if (s.random.chance(12)) {
    gl.Enable(GL_COLOR_LOGIC_OP);
    gl.LogicOp(GLenum(GL_CLEAR + s.random.integer(0, 15)));
  } else {
    gl.Disable(GL_COLOR_LOGIC_OP);
  }
  if (s.random.chance(85)) {
    gl.Enable(GL_BLEND);
    const GLenum source = factor(true), destination = factor(false);
    if (s.random.chance(50)) {
      gl.BlendFunc(source, destination);
    } else {
      const GLenum source_alpha = factor(true), destination_alpha = factor(false);
      gl.BlendFuncSeparate(source, destination, source_alpha, destination_alpha);
    }
    gl.BlendEquation(s.random.chance(50) ? GLenum(GL_FUNC_ADD)
                                         : GLenum(s.random.pick({GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT,
                                                                 GL_MIN, GL_MAX})));
    const Float4 c = s.random.color();
    gl.BlendColor(c[0], c[1], c[2], c[3]);
  } else {
    gl.Disable(GL_BLEND);
  }
  if (s.random.chance(20)) {
    const bool r = s.random.chance(60), g = s.random.chance(60), b = s.random.chance(60),
               a = s.random.chance(60);
    gl.ColorMask(r, g, b, a);
  }
}

void random_alpha_test(Stage& s) {
  s.gl.Enable(GL_ALPHA_TEST);
  const GLenum function = random_compare(s);
  s.gl.AlphaFunc(function, s.random.chance(70) ? s.random.real(0, 1) : s.random.integer(0, 255) / 255.0f);
}

void random_fog(Stage& s) {
  const Gl& gl = s.gl;
  gl.Enable(GL_FOG);
  gl.Fogi(GL_FOG_MODE, s.random.pick({GL_LINEAR, GL_EXP, GL_EXP2}));
  const Float4 c = s.random.color();
  gl.Fogfv(GL_FOG_COLOR, c.data());
  gl.Fogf(GL_FOG_DENSITY, s.random.real(0, 1.5f));
  const float start = s.random.real(-1, 3);
  gl.Fogf(GL_FOG_START, start);
  gl.Fogf(GL_FOG_END, s.random.chance(8) ? start : s.random.real(-1, 6));
}

void random_unpacking(Stage& s) {
  const bool other = s.random.chance(30);
  s.gl.PixelStorei(GL_UNPACK_ALIGNMENT, s.random.pick({1, 2, 4, 8}));
  s.gl.PixelStorei(GL_UNPACK_ROW_LENGTH, other ? s.random.pick({0, 40, 45}) : 0);
  s.gl.PixelStorei(GL_UNPACK_SKIP_ROWS, other ? s.random.integer(0, 3) : 0);
  s.gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, other ? s.random.integer(0, 9) : 0);
  s.gl.PixelStorei(GL_UNPACK_LSB_FIRST, other && s.random.chance(50));
}

int vertices_of(GLenum mode, int n) {
  switch (mode) {
  case GL_POINTS: return n;
  case GL_LINES: return 2 * n;
  case GL_LINE_STRIP: return n + 1;
  case GL_LINE_LOOP: return n + 1;
  case GL_TRIANGLES: return 3 * n;
  case GL_TRIANGLE_STRIP:
  case GL_TRIANGLE_FAN:
  case GL_POLYGON: return n + 2;
  case GL_QUADS: return 4 * n;
  case GL_QUAD_STRIP: return 2 * n + 2;
  default: return 0;
  }
}

void clamp_at_minus_one(std::vector<uint8_t>& pixels, GLenum type) {
  if (type == GL_FLOAT)
    for (size_t i = 0; i + 4 <= pixels.size(); i += 4) {
      float v;
      std::memcpy(&v, &pixels[i], 4);
      if (v < -1) v = -1;
      std::memcpy(&pixels[i], &v, 4);
    }
  if (type == GL_HALF_FLOAT)
    for (size_t i = 0; i + 2 <= pixels.size(); i += 2) {
      uint16_t v;
      std::memcpy(&v, &pixels[i], 2);
      if (v > 0xbc00) v = 0xbc00;
      std::memcpy(&pixels[i], &v, 2);
    }
}

GLenum random_filled_mode(Stage& s) {
  return GLenum(s.random.pick({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN,
                               GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}));
}

std::vector<Float4> random_positions(Stage& s, GLenum mode, int count, Spread spread, bool planar) {
  Random& r = s.random;
  std::vector<Float4> p(static_cast<size_t>(count));
  if (spread == Spread::Any)
    spread = r.pick({Spread::View, Spread::View, Spread::View, Spread::Tiny, Spread::Sliver, Spread::Grid,
                     Spread::Beyond, Spread::Beyond, Spread::Huge});
  const bool homogeneous = !planar && r.chance(15);
  Float3 center{r.real(-0.8f, 0.8f), r.real(-0.8f, 0.8f), r.real(-0.5f, 0.5f)}, along = r.direction();
  const int group = mode == GL_TRIANGLES ? 3
                    : mode == GL_QUADS   ? 4
                    : mode == GL_LINES   ? 2
                    : mode == GL_POINTS  ? 1
                                         : count;
  // Convex polygons: points of an ellipse in order. Everything else may fold.
  const float rx = r.real(0.2f, 1.1f), ry = r.real(0.2f, 1.1f), turn = r.real(0, 6.3f),
              tilt = r.real(-0.6f, 0.6f);
  for (int i = 0; i < count; i++) {
    Float4& v = p[size_t(i)];
    if (i % group == 0 && spread != Spread::View)
      center = {r.real(-1, 1), r.real(-1, 1), r.real(-0.7f, 0.7f)};
    switch (spread) {
    case Spread::Tiny:
      v = {center[0] + r.real(-0.03f, 0.03f), center[1] + r.real(-0.03f, 0.03f),
           center[2] + r.real(-0.03f, 0.03f), 1};
      break;
    case Spread::Sliver: {
      const float t = r.real(-1.2f, 1.2f);
      v = {center[0] + t * along[0] + r.real(-0.004f, 0.004f),
           center[1] + t * along[1] + r.real(-0.004f, 0.004f), center[2] + t * along[2], 1};
      break;
    }
    case Spread::Grid: // Half pixels and pixels: ties
      v = {float(r.integer(-s.width, s.width)) / float(s.width),
           float(r.integer(-s.height, s.height)) / float(s.height), float(r.integer(-4, 4)) * 0.125f, 1};
      break;
    case Spread::Beyond: v = {r.real(-2.5f, 2.5f), r.real(-2.5f, 2.5f), r.real(-2.5f, 2.5f), 1}; break;
    case Spread::Huge: {
      const float f = r.pick({10.0f, 1000.0f, 100000.0f});
      v = {r.real(-f, f), r.real(-f, f), r.real(-1, 1) * (r.chance(20) ? f : 1), 1};
      break;
    }
    default: v = {r.real(-1.1f, 1.1f), r.real(-1.1f, 1.1f), r.real(-1.1f, 1.1f), 1}; break;
    }
    const int of = mode == GL_POLYGON || mode == GL_QUADS ? (mode == GL_QUADS ? 4 : count) : 0;
    if (of && spread != Spread::Sliver && spread != Spread::Grid) {
      float size = spread == Spread::Tiny     ? 0.05f
                   : spread == Spread::Huge   ? 50.0f
                   : spread == Spread::Beyond ? 2.0f
                                              : 1.0f;
      if (mode == GL_QUADS) size *= 0.7f;
      const float a = turn + 6.2831853f * float(i % of) / float(of) + r.real(-0.2f, 0.2f) / float(of);
      v = {center[0] + size * rx * std::cos(a), center[1] + size * ry * std::sin(a),
           center[2] + size * tilt * std::cos(a), 1};
    }
    if (planar) v[2] = 0;
    if (homogeneous) {
      const float w = r.chance(10) ? r.real(-1, 1) : r.real(0.5f, 3);
      v = {v[0] * w, v[1] * w, v[2] * w, w};
    }
  }
  return p;
}

// Whether it is seen that OSMesa cuts a primitive in two (reference/DEVIATIONS.md): strips of quadrilaterals
// are ordered anew, a stipple begins anew, a polygon gets an edge, and a fan of which three vertices are left
// has the color of its first one.
static bool cut_is_seen(const Gl& gl, GLenum mode) {
  GLint list = 0;
  gl.GetIntegerv(GL_LIST_INDEX, &list);
  if (list) return true; // where it loses vertices
  switch (mode) {
  case GL_QUAD_STRIP: return true;
  case GL_LINE_STRIP:
  case GL_LINE_LOOP: return gl.IsEnabled(GL_LINE_STIPPLE);
  case GL_POLYGON: {
    GLint modes[2];
    gl.GetIntegerv(GL_POLYGON_MODE, modes);
    return modes[0] != GL_FILL || modes[1] != GL_FILL;
  }
  case GL_TRIANGLE_FAN: {
    GLint convention = GL_LAST_VERTEX_CONVENTION;
    gl.GetIntegerv(GL_PROVOKING_VERTEX, &convention);
    return convention == GL_FIRST_VERTEX_CONVENTION;
  }
  default: return false;
  }
}

// All colors of a primitive have three components, or all have four: reference/DEVIATIONS.md. To OSMesa
// glColor3d and the integers of glColor3 have four, and a primitive is cut in two where they come behind
// others.
static void emit_color(Stage& s, bool alpha, bool uncut) {
  const Gl& gl = s.gl;
  const Float4 c = s.random.color();
  int form = s.random.integer(0, 9);
  if (!alpha && uncut && form <= 3) form = 4;
  if (alpha) {
    switch (form) {
    case 0: gl.Color4d(c[0], c[1], c[2], c[3]); break;
    case 1:
      gl.Color4ub(GLubyte(c[0] * 255), GLubyte(c[1] * 255), GLubyte(c[2] * 255), GLubyte(c[3] * 255));
      break;
    case 2: gl.Color4f(c[0] * 2 - 0.5f, c[1] * 2 - 0.5f, c[2] * 2 - 0.5f, c[3]); break;
    case 3:
      gl.Color4b(GLbyte(c[0] * 255 - 128), GLbyte(c[1] * 255 - 128), GLbyte(c[2] * 255 - 128),
                 GLbyte(c[3] * 127));
      break;
    default: gl.Color4fv(c.data()); break;
    }
  } else {
    switch (form) {
    case 0: gl.Color3d(c[0], c[1], c[2]); break;
    case 1: gl.Color3us(GLushort(c[0] * 65535), GLushort(c[1] * 65535), GLushort(c[2] * 65535)); break;
    case 2:
      gl.Color3i(GLint(c[0] * 2147483000.0), GLint(c[1] * -2147483000.0), GLint(c[2] * 2147483000.0));
      break;
    case 3: gl.Color3ub(GLubyte(c[0] * 255), GLubyte(c[1] * 255), GLubyte(c[2] * 255)); break;
    default: gl.Color3fv(c.data()); break;
    }
  }
}

static void emit_texture_coordinates(Stage& s, const PrimitiveOptions& o) {
  const float f = o.texture_scale;
  Float4 t{s.random.real(-f, f), s.random.real(-f, f), s.random.real(-f, f), s.random.real(0.5f, 2)};
  switch (o.texture_coordinates) {
  case 1: s.gl.TexCoord1f(t[0]); break;
  case 2: s.gl.TexCoord2fv(t.data()); break;
  case 3: s.gl.TexCoord3fv(t.data()); break;
  default: s.gl.TexCoord4fv(t.data()); break;
  }
}

static void emit_material(Stage& s, bool front_only) {
  const GLenum face =
      front_only ? GLenum(GL_FRONT) : GLenum(s.random.pick({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}));
  const Float4 c = s.random.color();
  switch (s.random.integer(0, 5)) {
  case 0: s.gl.Materialfv(face, GL_AMBIENT, c.data()); break;
  case 1: s.gl.Materialfv(face, GL_DIFFUSE, c.data()); break;
  case 2: s.gl.Materialfv(face, GL_SPECULAR, c.data()); break;
  case 3: s.gl.Materialfv(face, GL_EMISSION, c.data()); break;
  case 4: s.gl.Materialf(face, GL_SHININESS, s.random.real(1, 128)); break;
  default: s.gl.Materialfv(face, GL_AMBIENT_AND_DIFFUSE, c.data()); break;
  }
}

void random_primitive(Stage& s, const PrimitiveOptions& o) {
  const Gl& gl = s.gl;
  // Smooth quads have a family of their own: where OSMesa cuts them depends on clipping, lists and indices.
  // OSMesa cuts flat ones like them where a texture replaces the color (reference/DEVIATIONS.md): textured
  // quads become strips.
  const GLenum mode = o.mode == GL_QUADS && o.texture_coordinates ? GL_QUAD_STRIP : o.mode;
  GLint shade_model = GL_FLAT;
  if (mode == GL_QUADS) {
    gl.GetIntegerv(GL_SHADE_MODEL, &shade_model);
    gl.ShadeModel(GL_FLAT);
  }
  const int primitives = o.primitives          ? o.primitives
                         : s.random.chance(70) ? s.random.integer(1, 6)
                                               : s.random.integer(7, 60);
  const int count = vertices_of(mode, primitives) + (s.random.chance(10) ? s.random.integer(0, 2) : 0);
  const std::vector<Float4> p = random_positions(s, mode, count, o.spread, o.planar);
  const int color_every = s.random.pick({1, 1, 1, 3});
  const bool alpha = s.random.chance(70), uncut = o.colors && cut_is_seen(gl, mode);
  gl.Begin(mode);
  for (int i = 0; i < count; i++) {
    const Float4& v = p[size_t(i)];
    if (o.colors && i % color_every == 0) emit_color(s, alpha, uncut);
    if (o.normals) {
      const Float3 n = s.random.direction();
      gl.Normal3fv(n.data());
    }
    // A strip of quadrilaterals takes no parameter late: reference/DEVIATIONS.md.
    if (o.materials && (i == 0 || mode != GL_QUAD_STRIP) && s.random.chance(40))
      emit_material(s, o.front_materials);
    if (o.secondary_colors) {
      const Float4 c = s.random.color();
      gl.SecondaryColor3fv(c.data());
    }
    if (o.fog_coordinates) gl.FogCoordf(s.random.real(-1, 4));
    if (o.texture_coordinates) emit_texture_coordinates(s, o);
    if (v[3] != 1)
      gl.Vertex4fv(v.data());
    else if (o.planar)
      gl.Vertex2fv(v.data());
    else
      gl.Vertex3fv(v.data());
  }
  gl.End();
  if (shade_model != GL_FLAT) gl.ShadeModel(GLenum(shade_model));
}

void backdrop(Stage& s) {
  const Gl& gl = s.gl;
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Begin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 4; i++) {
    const Float4 c = s.random.color();
    gl.Color4fv(c.data());
    gl.Vertex3f(i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, 0.9f);
  }
  gl.End();
}

void sphere(Stage& s, int slices, int stacks, float radius, bool texture_coordinates) {
  constexpr float kPi = 3.14159265f;
  for (int j = 0; j < stacks; j++) {
    s.gl.Begin(GL_TRIANGLE_STRIP);
    for (int i = 0; i <= slices; i++)
      for (int k = 1; k >= 0; k--) {
        const float v = kPi * float(j + k) / float(stacks), u = 2 * kPi * float(i % slices) / float(slices);
        const Float3 n{std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), std::cos(v)};
        if (texture_coordinates)
          s.gl.TexCoord2f(float(i) / float(slices) * 3, float(j + k) / float(stacks) * 2);
        s.gl.Normal3fv(n.data());
        s.gl.Vertex3f(n[0] * radius, n[1] * radius, n[2] * radius);
      }
    s.gl.End();
  }
}

void reset_state(Stage& s) {
  const Gl& gl = s.gl;
  for (GLenum capability : {GL_BLEND, GL_COLOR_LOGIC_OP, GL_ALPHA_TEST, GL_FOG, GL_CULL_FACE, GL_DEPTH_TEST,
                            GL_LIGHTING, GL_TEXTURE_2D, GL_SCISSOR_TEST, GL_COLOR_MATERIAL, GL_NORMALIZE,
                            GL_RESCALE_NORMAL, GL_POLYGON_OFFSET_FILL, GL_COLOR_SUM})
    gl.Disable(capability);
  for (int i = 0; i < 6; i++) gl.Disable(GL_CLIP_PLANE0 + GLenum(i));
  gl.ColorMask(1, 1, 1, 1);
  gl.DepthMask(1);
  gl.DepthRange(0, 1);
  gl.PointSize(1);
  gl.LineWidth(1);
}

} // namespace softgl::test
