#include "support/spec_picture.h"

#include <cmath>
#include <type_traits>

#include "raycast/shape.h"
#include "spec/lighting.h"

namespace softgl::test {
namespace {

using raycast::TriangleMesh;
using spec::Matrix4;
using spec::Vec3;
using spec::Vec4;

struct Vertex {
  Vec4 position; // object coordinates
  Vec3 normal;
  Vec4 color;
};

// One draw: its triangles in eye coordinates, and all state that lights them.
struct Draw {
  int viewport[4];
  Matrix4 unproject;
  std::vector<Vertex> vertices; // three a triangle; position in eye coordinates, not divided by w
  TriangleMesh mesh{{}, {}, {}};
  bool defined = true; // no vertex with w <= 0
  spec::LightModel model;
  std::vector<spec::Light> lights;
  spec::Material material[2];
  bool tracks[2] = {};
  spec::TrackedColor tracked = spec::TrackedColor::Ambient;
  bool clockwise = false;
};

struct Recorder {
  Gl real;
  GLenum mode = 0;
  Vertex current;
  std::vector<Vertex> primitive;
  std::vector<Draw> draws;
  const float *normals = nullptr, *positions = nullptr; // of arrays; the strides in floats
  int normal_stride = 0, position_stride = 0;
} recorder;

// Gauss and Jordan; rows are exchanged to divide by the largest number.
Matrix4 inverse(const Matrix4& a) {
  double rows[4][8];
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 8; j++) rows[i][j] = j < 4 ? a(i, j) : i == j - 4;
  for (int k = 0; k < 4; k++) {
    int best = k;
    for (int i = k + 1; i < 4; i++)
      if (std::abs(rows[i][k]) > std::abs(rows[best][k])) best = i;
    std::swap(rows[k], rows[best]);
    const double pivot = rows[k][k];
    for (double& x : rows[k]) x /= pivot;
    for (int i = 0; i < 4; i++) {
      const double factor = i == k ? 0 : rows[i][k];
      for (int j = 0; j < 8; j++) rows[i][j] -= factor * rows[k][j];
    }
  }
  Matrix4 result;
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 4; j++) result.m[4 * j + i] = rows[i][4 + j];
  return result;
}

Matrix4 matrix(GLenum name) {
  GLfloat m[16];
  recorder.real.GetFloatv(name, m);
  Matrix4 result;
  for (int i = 0; i < 16; i++) result.m[i] = double(m[i]);
  return result;
}
GLint integer(GLenum name) {
  GLint value = 0;
  recorder.real.GetIntegerv(name, &value);
  return value;
}
Vec4 vec4(const GLfloat* v) { return {double(v[0]), double(v[1]), double(v[2]), double(v[3])}; }

spec::Light read_light(GLenum light) {
  const auto get = [&](GLenum name) {
    GLfloat v[4] = {};
    recorder.real.GetLightfv(light, name, v);
    return vec4(v);
  };
  return {get(GL_AMBIENT).xyz(),        get(GL_DIFFUSE).xyz(),
          get(GL_SPECULAR).xyz(),       get(GL_POSITION),
          get(GL_SPOT_DIRECTION).xyz(), get(GL_SPOT_EXPONENT).x,
          get(GL_SPOT_CUTOFF).x,        get(GL_CONSTANT_ATTENUATION).x,
          get(GL_LINEAR_ATTENUATION).x, get(GL_QUADRATIC_ATTENUATION).x};
}

spec::Material read_material(GLenum face) {
  const auto get = [&](GLenum name) {
    GLfloat v[4] = {};
    recorder.real.GetMaterialfv(face, name, v);
    return vec4(v);
  };
  return {get(GL_AMBIENT), get(GL_DIFFUSE), get(GL_SPECULAR), get(GL_EMISSION), get(GL_SHININESS).x};
}

// Reads the state before a draw.
Draw begin_draw() {
  const Gl& gl = recorder.real;
  Draw d;
  gl.GetIntegerv(GL_VIEWPORT, d.viewport);
  d.unproject = inverse(matrix(GL_PROJECTION_MATRIX));
  GLfloat ambient[4];
  gl.GetFloatv(GL_LIGHT_MODEL_AMBIENT, ambient);
  d.model.ambient = vec4(ambient).xyz();
  d.model.local_viewer = integer(GL_LIGHT_MODEL_LOCAL_VIEWER);
  d.model.two_sided = integer(GL_LIGHT_MODEL_TWO_SIDE);
  d.model.separate_specular = integer(GL_LIGHT_MODEL_COLOR_CONTROL) == GL_SEPARATE_SPECULAR_COLOR;
  if (integer(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL) == GL_REFLECTION_VECTOR_SOFTGL)
    d.model.highlight = spec::Highlight::ReflectionVector;
  const GLint terms = integer(GL_LIGHT_MODEL_TERMS_SOFTGL);
  d.model.terms = {(terms & GL_EMISSION_TERM_BIT_SOFTGL) != 0, (terms & GL_AMBIENT_TERM_BIT_SOFTGL) != 0,
                   (terms & GL_DIFFUSE_TERM_BIT_SOFTGL) != 0, (terms & GL_SPECULAR_TERM_BIT_SOFTGL) != 0};
  for (GLenum i = 0; i < 8; i++)
    if (gl.IsEnabled(GL_LIGHT0 + i)) d.lights.push_back(read_light(GL_LIGHT0 + i));
  d.material[0] = read_material(GL_FRONT), d.material[1] = read_material(GL_BACK);
  if (gl.IsEnabled(GL_COLOR_MATERIAL)) {
    const GLint face = integer(GL_COLOR_MATERIAL_FACE);
    d.tracks[0] = face != GL_BACK, d.tracks[1] = face != GL_FRONT;
    switch (integer(GL_COLOR_MATERIAL_PARAMETER)) {
    case GL_EMISSION: d.tracked = spec::TrackedColor::Emission; break;
    case GL_DIFFUSE: d.tracked = spec::TrackedColor::Diffuse; break;
    case GL_SPECULAR: d.tracked = spec::TrackedColor::Specular; break;
    case GL_AMBIENT_AND_DIFFUSE: d.tracked = spec::TrackedColor::AmbientAndDiffuse; break;
    default: break;
    }
  }
  d.clockwise = integer(GL_FRONT_FACE) == GL_CW;
  return d;
}

// Takes the triangles, in object coordinates.
void end_draw(Draw d, const std::vector<Vertex>& triangles) {
  const Matrix4 modelview = matrix(GL_MODELVIEW_MATRIX);
  const bool rescale = recorder.real.IsEnabled(GL_RESCALE_NORMAL);
  // Reflection vectors need normals of unit length: reference/extensions/SOFTGL_phong_illumination.txt.
  const bool normalize =
      recorder.real.IsEnabled(GL_NORMALIZE) || d.model.highlight == spec::Highlight::ReflectionVector;
  std::vector<TriangleMesh::Vertex> mesh;
  std::vector<int> indices;
  for (const Vertex& v : triangles) {
    const Vec4 eye = modelview * v.position;
    d.defined &= eye.w > 0;
    d.vertices.push_back({eye, spec::transform_normal(modelview, v.normal, rescale, normalize), v.color});
    indices.push_back(int(mesh.size()));
    mesh.push_back({eye.divided(), {0, 0, 1}});
  }
  d.mesh = TriangleMesh({}, mesh, indices);
  recorder.draws.push_back(std::move(d));
}

std::vector<Vertex> triangles_of(GLenum mode, const std::vector<Vertex>& v) {
  std::vector<Vertex> t;
  for (size_t i = 2; i < v.size(); i++) {
    if (mode == GL_TRIANGLES && i % 3 == 2) t.insert(t.end(), {v[i - 2], v[i - 1], v[i]});
    if (mode == GL_TRIANGLE_STRIP) t.insert(t.end(), {v[i - 2 + i % 2], v[i - 1 - i % 2], v[i]});
    if (mode == GL_TRIANGLE_FAN) t.insert(t.end(), {v[0], v[i - 1], v[i]});
  }
  return t;
}

// The hooks
// ------------------------------------------------------------------------------------------------------------

void add_vertex(double x, double y, double z, double w) {
  recorder.current.position = {x, y, z, w};
  recorder.primitive.push_back(recorder.current);
}
void begin(GLenum mode) {
  GLfloat color[4];
  recorder.real.GetFloatv(GL_CURRENT_COLOR, color);
  recorder.current.color = vec4(color);
  recorder.draws.push_back(begin_draw());
  recorder.primitive.clear(), recorder.mode = mode;
  recorder.real.Begin(mode);
}
void end() {
  recorder.real.End();
  Draw d = std::move(recorder.draws.back());
  recorder.draws.pop_back();
  end_draw(std::move(d), triangles_of(recorder.mode, recorder.primitive));
}
void vertex2fv(const GLfloat* v) { add_vertex(double(v[0]), double(v[1]), 0, 1), recorder.real.Vertex2fv(v); }
void vertex3fv(const GLfloat* v) {
  add_vertex(double(v[0]), double(v[1]), double(v[2]), 1), recorder.real.Vertex3fv(v);
}
void vertex3f(GLfloat x, GLfloat y, GLfloat z) {
  add_vertex(double(x), double(y), double(z), 1), recorder.real.Vertex3f(x, y, z);
}
void vertex4fv(const GLfloat* v) {
  add_vertex(double(v[0]), double(v[1]), double(v[2]), double(v[3])), recorder.real.Vertex4fv(v);
}
void normal3fv(const GLfloat* v) {
  recorder.current.normal = {double(v[0]), double(v[1]), double(v[2])}, recorder.real.Normal3fv(v);
}

// GL 1.5, 2.14, table 2.9.
template <class T> double component(T c) {
  if constexpr (std::is_floating_point_v<T>)
    return double(c);
  else if constexpr (std::is_unsigned_v<T>)
    return double(c) / double(std::make_unsigned_t<T>(-1));
  else
    return (2 * double(c) + 1) / double(std::make_unsigned_t<T>(-1));
}
template <auto Member> struct Color;
template <class T, void (*Gl::*Member)(T, T, T)> struct Color<Member> {
  static void call(T r, T g, T b) {
    recorder.current.color = {component(r), component(g), component(b), 1}, (recorder.real.*Member)(r, g, b);
  }
};
template <class T, void (*Gl::*Member)(T, T, T, T)> struct Color<Member> {
  static void call(T r, T g, T b, T a) {
    recorder.current.color = {component(r), component(g), component(b), component(a)};
    (recorder.real.*Member)(r, g, b, a);
  }
};
void color3fv(const GLfloat* c) {
  recorder.current.color = {double(c[0]), double(c[1]), double(c[2]), 1}, recorder.real.Color3fv(c);
}
void color4fv(const GLfloat* c) { recorder.current.color = vec4(c), recorder.real.Color4fv(c); }

void normal_pointer(GLenum type, GLsizei stride, const void* pointer) {
  recorder.normals = static_cast<const float*>(pointer), recorder.normal_stride = stride / 4;
  recorder.real.NormalPointer(type, stride, pointer);
}
void vertex_pointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
  recorder.positions = static_cast<const float*>(pointer), recorder.position_stride = stride / 4;
  recorder.real.VertexPointer(size, type, stride, pointer);
}
void draw_elements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
  GLfloat color[4];
  recorder.real.GetFloatv(GL_CURRENT_COLOR, color);
  std::vector<Vertex> triangles;
  for (int i = 0; i < count; i++) {
    const int k = static_cast<const uint16_t*>(indices)[i];
    const float *n = recorder.normals + k * recorder.normal_stride,
                *p = recorder.positions + k * recorder.position_stride;
    triangles.push_back({{double(p[0]), double(p[1]), double(p[2]), 1},
                         {double(n[0]), double(n[1]), double(n[2])},
                         vec4(color)});
  }
  end_draw(begin_draw(), triangles);
  recorder.real.DrawElements(mode, count, type, indices);
}

// Shading
// --------------------------------------------------------------------------------------------------------------

struct Point {
  bool covered = false;
  double distance = 0;
  Vec4 color;
};

// What a draw shows at a point of the window.
Point look(const Draw& d, double x, double y) {
  const double ndc_x = 2 * (x - d.viewport[0]) / d.viewport[2] - 1,
               ndc_y = 2 * (y - d.viewport[1]) / d.viewport[3] - 1;
  if (std::abs(ndc_x) > 1 || std::abs(ndc_y) > 1) return {};
  const Vec3 near = (d.unproject * Vec4{ndc_x, ndc_y, -1, 1}).divided(),
             far = (d.unproject * Vec4{ndc_x, ndc_y, 1, 1}).divided();
  const raycast::Ray ray{near, spec::unit(far - near)};
  const std::optional<raycast::Hit> hit = d.mesh.intersect(ray);
  if (!hit || hit->distance > length(far - near)) return {};
  const Vertex* v = &d.vertices[size_t(3 * hit->part)];
  // From the weights of the divided positions to those of the homogeneous ones.
  double weight[3] = {hit->weights.x / v[0].position.w, hit->weights.y / v[1].position.w,
                      hit->weights.z / v[2].position.w};
  const double sum = weight[0] + weight[1] + weight[2];
  Vec3 eye, normal, rgb;
  double alpha = 0;
  for (int i = 0; i < 3; i++) {
    const double w = weight[i] / sum;
    eye = eye + w * v[i].position.xyz(), normal = normal + w * v[i].normal, rgb = rgb + w * v[i].color.xyz(),
    alpha += w * v[i].color.w;
  }
  // Some projections, such as the identity, look along +z: the window then shows a mirror image of what the
  // ray sees.
  const bool mirrored = ray.direction.z > 0;
  const bool back = d.model.two_sided && (hit->from_behind != mirrored) != d.clockwise;
  spec::Material material = d.material[back];
  if (d.tracks[back]) material = spec::track_color(material, d.tracked, {rgb.x, rgb.y, rgb.z, alpha});
  const Vec3 n = spec::unit(normal);
  const spec::LitColor lit =
      spec::light_vertex(d.model, d.lights, material, {eye.x, eye.y, eye.z, 1}, back ? -n : n);
  return {true, hit->distance, spec::color_sum(spec::clamped(lit))};
}

Point look(double x, double y, const Vec4& background) {
  Point nearest{false, 0, background};
  for (const Draw& d : recorder.draws) {
    const Point p = look(d, x, y);
    if (p.covered && (!nearest.covered || p.distance < nearest.distance)) nearest = p;
  }
  return nearest;
}

double largest_step(const Vec4& a, const Vec4& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z), std::abs(a.w - b.w)});
}

// The scene with the hooks in; the background is what it clears with.
std::function<void(Stage&)> draw_scene;
Vec4 background;
void draw_recorded(Stage& s) {
  recorder = {};
  recorder.real = s.gl;
  Gl gl = s.gl;
  gl.Begin = begin, gl.End = end;
  gl.Vertex2fv = vertex2fv, gl.Vertex3fv = vertex3fv, gl.Vertex3f = vertex3f, gl.Vertex4fv = vertex4fv,
  gl.Normal3fv = normal3fv;
  gl.Color3fv = color3fv, gl.Color4fv = color4fv;
// clang-format off
#define COLOR(name) gl.name = Color<&Gl::name>::call;
  COLOR(Color3d) COLOR(Color3us) COLOR(Color3i) COLOR(Color3ub) COLOR(Color4d) COLOR(Color4ub) COLOR(Color4f) COLOR(Color4b)
#undef COLOR
      // clang-format on
      gl.NormalPointer = normal_pointer,
      gl.VertexPointer = vertex_pointer, gl.DrawElements = draw_elements;
  Stage hooked{gl, s.random, s.width, s.height};
  draw_scene(hooked);
  GLfloat clear[4];
  s.gl.GetFloatv(GL_COLOR_CLEAR_VALUE, clear);
  background = vec4(clear);
}

} // namespace

SpecPicture draw_with_spec(const Scene& scene, uint64_t seed) {
  draw_scene = scene.draw;
  Scene recorded = scene; // with its name, which decides the random numbers
  recorded.draw = draw_recorded;
  SpecPicture result;
  result.drawn = draw(softgl_library(), recorded, seed);
  const int width = result.drawn.width, height = result.drawn.height;
  for (int y = 0; y < height; y++)
    for (int x = 0; x < width; x++) {
      const Point center = look(x + 0.5, y + 0.5, background);
      bool certain = true;
      for (const Draw& d : recorder.draws)
        certain &= d.defined || x < d.viewport[0] || x >= d.viewport[0] + d.viewport[2] ||
                   y < d.viewport[1] || y >= d.viewport[1] + d.viewport[3];
      for (int corner = 0; corner < 4 && certain; corner++) {
        const Point beside = look(x + 0.5 + (corner & 1 ? 1 : -1) / 128.0,
                                  y + 0.5 + (corner & 2 ? 1 : -1) / 128.0, background);
        certain = beside.covered == center.covered && largest_step(beside.color, center.color) <= 1.0 / 255;
      }
      result.certain.push_back(certain);
      result.covered.push_back(center.covered);
      for (double c : {center.color.x, center.color.y, center.color.z, center.color.w})
        result.color.push_back(spec::to_fixed_point(c));
    }
  return result;
}

} // namespace softgl::test
