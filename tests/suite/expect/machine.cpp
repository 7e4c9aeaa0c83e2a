#include "expect/machine.h"

#include <numbers>
#include <stdexcept>
#include <utility>

namespace softgl::suite {
namespace {

Matrix4 operator*(const Matrix4& a, const Matrix4& b) {
  Matrix4 c;
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 4; j++) {
      c.m[4 * j + i] = 0;
      for (int k = 0; k < 4; k++) c.m[4 * j + i] += a(i, k) * b(k, j);
    }
  return c;
}

// A matrix comes from the subject's own arithmetic: some operations of 2.1.1's accuracy.
constexpr double kMatrixAccuracy = 4 * spec::kAccuracy;

Interval row_times(const Matrix4& m, int row, const Vec4& v) {
  const double terms[4] = {m(row, 0) * v.x, m(row, 1) * v.y, m(row, 2) * v.z, m(row, 3) * v.w};
  double sum = 0, size = 0;
  for (double t : terms) sum += t, size += std::abs(t);
  return spec::widened(sum, kMatrixAccuracy * size);
}

Vec3 eye_direction(const Matrix4& m, const Vec3& d) {
  const Vec4 v = m * Vec4{d.x, d.y, d.z, 0};
  return v.xyz();
}

Vec4 vec4(const std::vector<double>& v) { return {v[0], v[1], v[2], v.size() > 3 ? v[3] : 1}; }

class Machine {
public:
  Machine(Expectation& picture, const Precision& precision) : raster_(picture, precision) {
    state_.viewport[2] = picture.width, state_.viewport[3] = picture.height; // 2.11.1
    for (Interval& white : raster_position_.front.primary) white = 1;        // table 6.6
  }
  void play(const Call& call);

private:
  Matrix4& matrix();
  void multiply(const Matrix4& m) { matrix() = matrix() * m; }
  void enable(GLenum name, bool on);
  void light(const Call& call, const std::vector<double>& values);
  void light_model(GLenum name, const std::vector<double>& values);
  void material(GLenum face, GLenum name, const std::vector<double>& values);
  void set_material(int face, GLenum name, const std::vector<double>& values);
  void track_color();
  bool tracks(int face, GLenum name) const;
  void fog(GLenum name, const std::vector<double>& values);
  void color(double r, double g, double b, double a = 1);
  void push_attributes(GLbitfield mask) { state_.saved.push_back({mask, state_}); }
  void pop_attributes();
  LitVertex transform(const Vec4& object) const;
  ColorBounds lit_color(const spec::Vec3Interval& eye, const spec::Vec3Interval& normal, int face) const;
  void end();
  void raster_position(const Vec4& object) { raster_position_ = transform(object); }
  void bitmap(const Call& call);
  void texture(const Call& call);
  bool play_state(const Call& call);

  State state_;
  Rasterizer raster_;
  bool open_ = false; // between Begin and End
  GLenum mode_ = 0;
  std::vector<LitVertex> vertices_;
  LitVertex raster_position_;
  GLuint list_ = 0; // that is compiled
  bool list_executes_ = false;
};

Matrix4& Machine::matrix() {
  switch (state_.transform.matrix_mode) {
  case GL_PROJECTION: return state_.projection.back();
  case GL_TEXTURE: return state_.texture_matrix.back();
  }
  return state_.modelview.back();
}

void Machine::enable(GLenum name, bool on) {
  State& s = state_;
  if (name >= GL_LIGHT0 && name <= GL_LIGHT7) {
    s.lighting.enabled[name - GL_LIGHT0] = on;
    return;
  }
  switch (name) {
  case GL_LIGHTING: s.lighting.lighting = on; break;
  case GL_COLOR_MATERIAL: s.lighting.color_material = on, track_color(); break;
  case GL_NORMALIZE: s.transform.normalize = on; break;
  case GL_RESCALE_NORMAL: s.transform.rescale_normal = on; break;
  case GL_CULL_FACE: s.polygon.cull = on; break;
  case GL_DEPTH_TEST: s.depth.test = on; break;
  case GL_ALPHA_TEST: s.color_buffer.alpha_test = on; break;
  case GL_BLEND: s.color_buffer.blend = on; break;
  case GL_FOG: s.fog.on = on; break;
  case GL_TEXTURE_2D: s.texture.on = on; break;
  case GL_DITHER: break;
  default: throw std::logic_error("glEnable of what the machine does not know");
  }
}

void Machine::light(const Call& call, const std::vector<double>& v) {
  spec::LightBounds& l = state_.lighting.light[call.e(0) - GL_LIGHT0];
  spec::Light& p = l.parameters;
  const Matrix4& m = state_.modelview.back();
  switch (call.e(1)) {
  case GL_AMBIENT: p.ambient = {v[0], v[1], v[2]}; break;
  case GL_DIFFUSE: p.diffuse = {v[0], v[1], v[2]}; break;
  case GL_SPECULAR: p.specular = {v[0], v[1], v[2]}; break;
  case GL_POSITION: {
    const Vec4 object = vec4(v);
    p.position = m * object;
    const Interval eye[3] = {row_times(m, 0, object), row_times(m, 1, object), row_times(m, 2, object)};
    const Interval by = p.position.w == 0 ? Interval(1) : Interval(1 / p.position.w);
    l.position = {eye[0] * by, eye[1] * by, eye[2] * by};
    break;
  }
  case GL_SPOT_DIRECTION: {
    // Transformed by the upper leftmost 3x3 of the modelview (2.14.2).
    p.spot_direction = eye_direction(m, {v[0], v[1], v[2]});
    const Vec4 d{v[0], v[1], v[2], 0};
    l.spot_direction = {row_times(m, 0, d), row_times(m, 1, d), row_times(m, 2, d)};
    break;
  }
  case GL_SPOT_EXPONENT: p.spot_exponent = v[0]; break;
  case GL_SPOT_CUTOFF: p.spot_cutoff = v[0]; break;
  case GL_CONSTANT_ATTENUATION: p.constant_attenuation = v[0]; break;
  case GL_LINEAR_ATTENUATION: p.linear_attenuation = v[0]; break;
  case GL_QUADRATIC_ATTENUATION: p.quadratic_attenuation = v[0]; break;
  default: throw std::logic_error("glLight of what the machine does not know");
  }
}

void Machine::light_model(GLenum name, const std::vector<double>& v) {
  spec::LightModel& m = state_.lighting.model;
  switch (name) {
  case GL_LIGHT_MODEL_AMBIENT: m.ambient = {v[0], v[1], v[2]}; break;
  case GL_LIGHT_MODEL_LOCAL_VIEWER: m.local_viewer = v[0] != 0; break;
  case GL_LIGHT_MODEL_TWO_SIDE: m.two_sided = v[0] != 0; break;
  case GL_LIGHT_MODEL_COLOR_CONTROL: m.separate_specular = v[0] == GL_SEPARATE_SPECULAR_COLOR; break;
  default: throw std::logic_error("glLightModel of what the machine does not know");
  }
}

bool Machine::tracks(int face, GLenum name) const {
  const LightingState& l = state_.lighting;
  if (!l.color_material) return false;
  if (l.tracked_face != GL_FRONT_AND_BACK && l.tracked_face != GLenum(face ? GL_BACK : GL_FRONT))
    return false;
  return l.tracked == name ||
         (l.tracked == GL_AMBIENT_AND_DIFFUSE && (name == GL_AMBIENT || name == GL_DIFFUSE));
}

void Machine::set_material(int face, GLenum name, const std::vector<double>& v) {
  spec::Material& m = state_.lighting.material[face];
  switch (name) {
  case GL_AMBIENT: m.ambient = vec4(v); break;
  case GL_DIFFUSE: m.diffuse = vec4(v); break;
  case GL_SPECULAR: m.specular = vec4(v); break;
  case GL_EMISSION: m.emission = vec4(v); break;
  case GL_SHININESS: m.shininess = v[0]; break;
  default: throw std::logic_error("glMaterial of what the machine does not know");
  }
}

void Machine::material(GLenum face, GLenum name, const std::vector<double>& v) {
  if (name == GL_AMBIENT_AND_DIFFUSE) {
    material(face, GL_AMBIENT, v), material(face, GL_DIFFUSE, v);
    return;
  }
  for (int i = 0; i < 2; i++)
    if (face == GL_FRONT_AND_BACK || face == GLenum(i ? GL_BACK : GL_FRONT))
      if (!tracks(i, name)) set_material(i, name, v);
}

void Machine::track_color() {
  const Vec4& c = state_.current.color;
  for (int face = 0; face < 2; face++)
    for (GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION})
      if (tracks(face, name)) set_material(face, name, {c.x, c.y, c.z, c.w});
}

void Machine::fog(GLenum name, const std::vector<double>& v) {
  FogState& f = state_.fog;
  switch (name) {
  case GL_FOG_MODE: f.mode = GLenum(v[0]); break;
  case GL_FOG_DENSITY: f.density = v[0]; break;
  case GL_FOG_START: f.start = v[0]; break;
  case GL_FOG_END: f.end = v[0]; break;
  case GL_FOG_COLOR: f.color = vec4(v); break;
  default: throw std::logic_error("glFog of what the machine does not know");
  }
}

void Machine::color(double r, double g, double b, double a) {
  state_.current.color = {r, g, b, a};
  track_color();
}

void Machine::pop_attributes() {
  if (state_.saved.empty()) throw std::logic_error("glPopAttrib without glPushAttrib");
  restore(state_, state_.saved.back());
  state_.saved.pop_back();
  track_color();
}

ColorBounds Machine::lit_color(const spec::Vec3Interval& eye, const spec::Vec3Interval& normal,
                               int face) const {
  const LightingState& l = state_.lighting;
  ColorBounds color;
  const Vec4& c = state_.current.color;
  const double plain[4] = {c.x, c.y, c.z, c.w};
  std::copy(plain, plain + 4, color.primary);
  if (l.lighting) {
    std::vector<spec::LightBounds> lights;
    for (int i = 0; i < 8; i++)
      if (l.enabled[i]) lights.push_back(l.light[i]);
    const spec::LitBounds lit =
        light_vertex_bounds(l.model, lights, l.material[face], eye, face ? -normal : normal);
    std::copy(lit.primary, lit.primary + 4, color.primary);
    std::copy(lit.secondary, lit.secondary + 3, color.secondary);
  }
  for (Interval& i : color.primary) i = spec::clamped(i, 0, 1); // 2.14.6
  for (Interval& i : color.secondary) i = spec::clamped(i, 0, 1);
  return color;
}

LitVertex Machine::transform(const Vec4& object) const {
  const Matrix4& m = state_.modelview.back();
  const Vec4 eye4 = m * object;
  const Vec4 clip = state_.projection.back() * eye4;
  if (clip.w <= 0 || std::abs(clip.z) > clip.w) throw std::logic_error("a vertex outside of the view");
  const Interval by_w = 1 / eye4.w;
  const spec::Vec3Interval eye{row_times(m, 0, object) * by_w, row_times(m, 1, object) * by_w,
                               row_times(m, 2, object) * by_w};
  LitVertex v;
  const int* p = state_.viewport;
  v.window = {p[0] + (clip.x / clip.w + 1) * p[2] / 2, p[1] + (clip.y / clip.w + 1) * p[3] / 2,
              (clip.z / clip.w + 1) / 2};
  v.w = clip.w;
  v.fog_distance = spec::hull(spec::widened(std::abs(eye4.z), 1e-4), spec::length(eye)); // 3.10: either
  const bool normalize = state_.transform.normalize;
  const Vec3 n = spec::transform_normal(m, state_.current.normal, state_.transform.rescale_normal, false);
  const double accuracy = 4 * kMatrixAccuracy * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
  spec::Vec3Interval normal{spec::widened(n.x, accuracy), spec::widened(n.y, accuracy),
                            spec::widened(n.z, accuracy)};
  if (normalize) normal = spec::unit(normal);
  v.front = lit_color(eye, normal, 0);
  v.back = state_.lighting.lighting && state_.lighting.model.two_sided ? lit_color(eye, normal, 1) : v.front;
  return v;
}

void Machine::end() {
  const std::vector<LitVertex>& v = vertices_;
  const int n = int(v.size());
  const auto polygon = [&](std::vector<int> corners, int provoking) {
    std::vector<LitVertex> p;
    for (int i : corners) p.push_back(v[size_t(i)]);
    raster_.polygon(state_, p, provoking);
  };
  const auto line = [&](int a, int b) { raster_.line(state_, v[size_t(a)], v[size_t(b)], 1); };
  switch (mode_) { // table 2.12 says which vertex gives a flat polygon its color
  case GL_POINTS:
    for (const LitVertex& p : v) raster_.point(state_, p);
    break;
  case GL_LINES:
    for (int i = 0; i + 1 < n; i += 2) line(i, i + 1);
    break;
  case GL_LINE_STRIP:
  case GL_LINE_LOOP:
    for (int i = 0; i + 1 < n; i++) line(i, i + 1);
    if (mode_ == GL_LINE_LOOP && n > 2) line(n - 1, 0);
    break;
  case GL_TRIANGLES:
    for (int i = 0; i + 2 < n; i += 3) polygon({i, i + 1, i + 2}, 2);
    break;
  case GL_TRIANGLE_STRIP:
    for (int i = 0; i + 2 < n; i++)
      polygon(i % 2 ? std::vector{i + 1, i, i + 2} : std::vector{i, i + 1, i + 2}, 2);
    break;
  case GL_TRIANGLE_FAN:
    for (int i = 1; i + 1 < n; i++) polygon({0, i, i + 1}, 2);
    break;
  case GL_QUADS:
    for (int i = 0; i + 3 < n; i += 4) polygon({i, i + 1, i + 2, i + 3}, 3);
    break;
  case GL_QUAD_STRIP:
    for (int i = 0; i + 3 < n; i += 2) polygon({i, i + 1, i + 3, i + 2}, 2);
    break;
  case GL_POLYGON: {
    std::vector<int> all;
    for (int i = 0; i < n; i++) all.push_back(i);
    if (n > 2) polygon(all, 0);
    break;
  }
  }
  vertices_.clear();
}

void Machine::bitmap(const Call& call) {
  for (double byte : call.v(6))
    if (byte != 255) throw std::logic_error("a bitmap that is not all ones");
  const int x = int(std::floor(raster_position_.window.x - call.n(2)));
  const int y = int(std::floor(raster_position_.window.y - call.n(3)));
  raster_.rectangle(state_, x, y, int(call.n(0)), int(call.n(1)), raster_position_.front,
                    raster_position_.window.z);
  raster_position_.window.x += call.n(4), raster_position_.window.y += call.n(5);
}

void Machine::texture(const Call& call) {
  const std::vector<double>& texels = call.v(8);
  const size_t components = call.e(6) == GL_RGB ? 3 : 4;
  for (size_t i = 0; i < texels.size(); i++)
    if (texels[i] != texels[i % components]) throw std::logic_error("a texture of more than one color");
  state_.texture.color = {texels[0] / 255, texels[1] / 255, texels[2] / 255,
                          components == 4 ? texels[3] / 255 : 1};
}

bool Machine::play_state(const Call& call) {
  State& s = state_;
  const auto numbers = [&](size_t first) {
    std::vector<double> v;
    for (size_t i = first; i < call.arguments.size(); i++) v.push_back(call.n(i));
    return v;
  };
  switch (call.command) {
  case Command::Enable: enable(call.e(0), true); return true;
  case Command::Disable: enable(call.e(0), false); return true;
  case Command::Lightf:
  case Command::Lighti: light(call, numbers(2)); return true;
  case Command::Lightfv: light(call, call.v(2)); return true;
  case Command::Lightiv: {
    // Colors map the whole range of integers to [-1, 1] (table 2.9); other values are taken as they are.
    std::vector<double> v = call.v(2);
    if (call.e(1) == GL_AMBIENT || call.e(1) == GL_DIFFUSE || call.e(1) == GL_SPECULAR)
      for (double& x : v) x = (2 * x + 1) / 4294967295.0;
    light(call, v);
    return true;
  }
  case Command::LightModelf:
  case Command::LightModeli: light_model(call.e(0), numbers(1)); return true;
  case Command::LightModelfv: light_model(call.e(0), call.v(1)); return true;
  case Command::LightModeliv: {
    std::vector<double> v = call.v(1);
    if (call.e(0) == GL_LIGHT_MODEL_AMBIENT)
      for (double& x : v) x = (2 * x + 1) / 4294967295.0;
    light_model(call.e(0), v);
    return true;
  }
  case Command::Materialf:
  case Command::Materiali: material(call.e(0), call.e(1), numbers(2)); return true;
  case Command::Materialfv: material(call.e(0), call.e(1), call.v(2)); return true;
  case Command::Materialiv: {
    std::vector<double> v = call.v(2);
    if (call.e(1) != GL_SHININESS)
      for (double& x : v) x = (2 * x + 1) / 4294967295.0;
    material(call.e(0), call.e(1), v);
    return true;
  }
  case Command::ColorMaterial:
    s.lighting.tracked_face = call.e(0), s.lighting.tracked = call.e(1), track_color();
    return true;
  case Command::ShadeModel: s.lighting.shade_model = call.e(0); return true;
  case Command::FrontFace: s.polygon.front_face = call.e(0); return true;
  case Command::CullFace: s.polygon.cull_face = call.e(0); return true;
  case Command::Fogf:
  case Command::Fogi: fog(call.e(0), numbers(1)); return true;
  case Command::Fogfv: fog(call.e(0), call.v(1)); return true;
  case Command::AlphaFunc:
    s.color_buffer.alpha_function = call.e(0), s.color_buffer.alpha_reference = call.n(1);
    return true;
  case Command::BlendFunc:
    s.color_buffer.source = call.e(0), s.color_buffer.destination = call.e(1);
    return true;
  case Command::DepthFunc: s.depth.function = call.e(0); return true;
  case Command::DepthMask: s.depth.mask = call.n(0) != 0; return true;
  case Command::ClearDepth: s.depth.clear = call.n(0); return true;
  case Command::ClearColor:
    s.color_buffer.clear_color = {call.n(0), call.n(1), call.n(2), call.n(3)};
    return true;
  case Command::PointSize: s.width.point = call.n(0); return true;
  case Command::LineWidth: s.width.line = call.n(0); return true;
  case Command::TexImage2D: texture(call); return true;
  case Command::TexEnvi: s.texture.environment = call.e(2); return true;
  case Command::TexParameteri:
  case Command::TexCoord2f:
  case Command::PixelStorei:
  case Command::Hint:
  case Command::Flush:
  case Command::Finish: return true;
  case Command::PushAttrib: push_attributes(GLbitfield(call.n(0))); return true;
  case Command::PopAttrib: pop_attributes(); return true;
  case Command::Viewport:
    for (size_t i = 0; i < 4; i++) s.viewport[i] = int(call.n(i));
    return true;
  default: return false;
  }
}

// ---------------------------------------------------------------------------------------------------------------

void Machine::play(const Call& call) {
  const auto n = [&](size_t i) { return call.n(i); };
  if (list_ && facts_of(call.command).in_lists) {
    state_.lists[list_].push_back(call);
    if (!list_executes_) return;
  }
  if (play_state(call)) return;
  const auto stack = [&]() -> std::vector<Matrix4>& {
    return state_.transform.matrix_mode == GL_PROJECTION ? state_.projection : state_.modelview;
  };
  Matrix4 m;
  switch (call.command) {
  case Command::NewList:
    list_ = GLuint(n(0)), list_executes_ = call.e(1) == GL_COMPILE_AND_EXECUTE, state_.lists[list_].clear();
    break;
  case Command::EndList: list_ = 0; break;
  case Command::CallList: {
    const std::vector<Call> calls = state_.lists[GLuint(n(0))];
    const GLuint compiled = std::exchange(list_, 0); // what is executed is not compiled again
    for (const Call& c : calls) play(c);
    list_ = compiled;
    break;
  }
  case Command::MatrixMode: state_.transform.matrix_mode = call.e(0); break;
  case Command::LoadIdentity: matrix() = {}; break;
  case Command::LoadMatrixf: matrix() = {}, std::copy(call.v(0).begin(), call.v(0).end(), matrix().m); break;
  case Command::MultMatrixf: std::copy(call.v(0).begin(), call.v(0).end(), m.m), multiply(m); break;
  case Command::Translatef: m.m[12] = n(0), m.m[13] = n(1), m.m[14] = n(2), multiply(m); break;
  case Command::Scalef: m.m[0] = n(0), m.m[5] = n(1), m.m[10] = n(2), multiply(m); break;
  case Command::Rotatef: {
    const Vec3 u = spec::unit(Vec3{n(1), n(2), n(3)});
    const double a = n(0) * std::numbers::pi / 180, c = std::cos(a), s = std::sin(a);
    const double r[9] = {
        u.x * u.x * (1 - c) + c,       u.x * u.y * (1 - c) - u.z * s, u.x * u.z * (1 - c) + u.y * s,
        u.y * u.x * (1 - c) + u.z * s, u.y * u.y * (1 - c) + c,       u.y * u.z * (1 - c) - u.x * s,
        u.z * u.x * (1 - c) - u.y * s, u.z * u.y * (1 - c) + u.x * s, u.z * u.z * (1 - c) + c};
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++) m.m[4 * j + i] = r[3 * i + j];
    multiply(m);
    break;
  }
  case Command::Ortho:
    m.m[0] = 2 / (n(1) - n(0)), m.m[5] = 2 / (n(3) - n(2)), m.m[10] = -2 / (n(5) - n(4));
    m.m[12] = -(n(1) + n(0)) / (n(1) - n(0)), m.m[13] = -(n(3) + n(2)) / (n(3) - n(2));
    m.m[14] = -(n(5) + n(4)) / (n(5) - n(4)), multiply(m);
    break;
  case Command::Frustum:
    m.m[0] = 2 * n(4) / (n(1) - n(0)), m.m[5] = 2 * n(4) / (n(3) - n(2));
    m.m[8] = (n(1) + n(0)) / (n(1) - n(0)), m.m[9] = (n(3) + n(2)) / (n(3) - n(2));
    m.m[10] = -(n(5) + n(4)) / (n(5) - n(4)), m.m[11] = -1, m.m[14] = -2 * n(5) * n(4) / (n(5) - n(4));
    m.m[15] = 0, multiply(m);
    break;
  case Command::PushMatrix: stack().push_back(Matrix4(stack().back())); break;
  case Command::PopMatrix: stack().pop_back(); break;
  case Command::Begin: open_ = true, mode_ = call.e(0); break;
  case Command::End: open_ = false, end(); break;
  case Command::Vertex2f: vertices_.push_back(transform({n(0), n(1), 0, 1})); break;
  case Command::Vertex3d:
  case Command::Vertex3f: vertices_.push_back(transform({n(0), n(1), n(2), 1})); break;
  case Command::Vertex3fv:
    vertices_.push_back(transform({call.v(0)[0], call.v(0)[1], call.v(0)[2], 1}));
    break;
  case Command::Vertex4f: vertices_.push_back(transform({n(0), n(1), n(2), n(3)})); break;
  case Command::Normal3d:
  case Command::Normal3f: state_.current.normal = {n(0), n(1), n(2)}; break;
  case Command::Normal3fv: state_.current.normal = {call.v(0)[0], call.v(0)[1], call.v(0)[2]}; break;
  case Command::Normal3b:
    state_.current.normal = {(2 * n(0) + 1) / 255, (2 * n(1) + 1) / 255, (2 * n(2) + 1) / 255};
    break;
  case Command::Normal3s:
    state_.current.normal = {(2 * n(0) + 1) / 65535, (2 * n(1) + 1) / 65535, (2 * n(2) + 1) / 65535};
    break;
  case Command::Normal3i:
    state_.current.normal = {(2 * n(0) + 1) / 4294967295.0, (2 * n(1) + 1) / 4294967295.0,
                             (2 * n(2) + 1) / 4294967295.0};
    break;
  case Command::Color3d:
  case Command::Color3f: color(n(0), n(1), n(2)); break;
  case Command::Color4f: color(n(0), n(1), n(2), n(3)); break;
  case Command::Color4fv: color(call.v(0)[0], call.v(0)[1], call.v(0)[2], call.v(0)[3]); break;
  case Command::Color3ub: color(n(0) / 255, n(1) / 255, n(2) / 255); break;
  case Command::Color4ub: color(n(0) / 255, n(1) / 255, n(2) / 255, n(3) / 255); break;
  case Command::Clear: raster_.clear(state_, GLbitfield(n(0))); break;
  case Command::RasterPos3f: raster_position({n(0), n(1), n(2), 1}); break;
  case Command::Bitmap: bitmap(call); break;
  default: throw std::logic_error(std::string("the machine does not know gl") + facts_of(call.command).name);
  }
}

} // namespace

Expectation expected_picture(const Script& script, int width, int height, const Precision& precision) {
  Expectation picture;
  picture.width = width, picture.height = height;
  picture.pixels.assign(size_t(width * height), std::vector<Answer>(1));
  Machine machine(picture, precision);
  for (const Call& call : script.calls) machine.play(call);
  return picture;
}

} // namespace softgl::suite
