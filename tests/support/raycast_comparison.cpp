#include "support/raycast_comparison.h"
#include "support/runner.h"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

#include "raycast/scene.h"

namespace softgl::test {
namespace {

using raycast::Hit;
using spec::Vec3;
constexpr int kSize = 160;

// Set-ups
// ---------------------------------------------------------------------------------------------------------------

struct Setup {
  std::string name;
  raycast::Camera camera;
  raycast::Illumination illumination;
  raycast::Material material;
};

// Lights of every kind around a shape at (0, 0, -4), alone and together; sharp and blunt highlights; both
// viewers.
Setup make_setup(int number, bool reflection) {
  static const char* const kKinds[] = {"directional",          "point",       "attenuated point", "spotlight",
                                       "attenuated spotlight", "three lights"};
  static const double kExponents[] = {1, 5, 12, 30, 64, 128};
  const int kind = number % 6;
  Random random(uint64_t(number) + 77);
  const auto real = [&](float low, float high) { return double(random.real(low, high)); };
  const auto color = [&](float low) {
    const double r = real(low, 1), g = real(low, 1);
    return Vec3{r, g, real(low, 1)};
  };
  Setup s;
  s.camera = {kSize, kSize, number % 4 < 2, 40, 1.4};
  s.illumination.equation = raycast::Equation::OpenGL;
  spec::LightModel& model = s.illumination.model;
  model.ambient = {0.15, 0.15, 0.2};
  model.local_viewer = s.camera.perspective;
  model.highlight = reflection ? spec::Highlight::ReflectionVector : spec::Highlight::HalfVector;
  s.material.kAmbient = color(0.1f), s.material.kDiffuse = color(0.2f), s.material.kSpecular = color(0.3f);
  s.material.phongExponent = kExponents[(number / 2 + number / 6) % 6];
  for (int i = 0; i < (kind == 5 ? 3 : 1); i++) {
    spec::Light light;
    light.ambient = 0.1 * color(0), light.diffuse = (kind == 5 ? 0.5 : 0.8) * color(0.4f),
    light.specular = color(0.3f);
    const double x = real(-3, 3), y = real(0.5f, 3), towards_us = real(1, 3);
    const bool positional = kind != 0 && !(kind == 5 && i == 0),
               spot = kind == 3 || kind == 4 || (kind == 5 && i == 2);
    light.position = {x, y, towards_us - (positional ? 4 : 0), positional ? 1.0 : 0.0};
    if (kind == 2 || kind == 4)
      light.constant_attenuation = 0.4, light.linear_attenuation = 0.1, light.quadratic_attenuation = 0.03;
    if (spot) {
      light.spot_direction = Vec3{-x, -y, -towards_us};
      light.spot_cutoff = real(15, 35), light.spot_exponent = real(0, 20);
    }
    s.illumination.lights.push_back(light);
  }
  s.name = std::string(kKinds[kind]) + (s.camera.perspective ? ", perspective" : ", orthographic") +
           ", exponent " + std::to_string(int(s.material.phongExponent));
  return s;
}

// Shapes, exact and tessellated
// -------------------------------------------------------------------------------------------

struct Tessellation {
  std::vector<float> vertices; // normal, position
  std::vector<uint32_t> indices;
  void add(Vec3 position, Vec3 normal) {
    for (double x : {normal.x, normal.y, normal.z, position.x, position.y, position.z})
      vertices.push_back(float(x));
  }
  // The quads between rows of `columns` + 1 vertices.
  void connect(int first, int columns, int rows) {
    for (int j = 0; j < rows; j++)
      for (int i = 0; i < columns; i++) {
        const uint32_t a = uint32_t(first + j * (columns + 1) + i), b = a + uint32_t(columns) + 1;
        for (uint32_t k : {a, a + 1, b + 1, a, b + 1, b}) indices.push_back(k);
      }
  }
};

constexpr Vec3 kCenter{0, 0, -4};
constexpr double kRadius = 1.2;
const Vec3 kPlanePoint{0, -0.5, -4}, kPlaneNormal = spec::unit({0.1, 1, 0.6});
// Three half edges at right angles: rows of a rotation.
const Vec3 kBoxEdges[3] = {0.75 * Vec3{0.8, 0, -0.6}, 0.75 * Vec3{0.36, 0.8, 0.48},
                           0.75 * Vec3{0.48, -0.6, 0.64}};

std::unique_ptr<raycast::Shape> exact(const std::string& shape, const raycast::Material& material) {
  if (shape == "sphere") return std::make_unique<raycast::Sphere>(material, kCenter, kRadius);
  if (shape == "plane") return std::make_unique<raycast::Plane>(material, kPlanePoint, kPlaneNormal);
  if (shape == "box")
    return std::make_unique<raycast::Box>(material, kCenter, kBoxEdges[0], kBoxEdges[1], kBoxEdges[2]);
  throw std::runtime_error("no shape is called " + shape);
}

// n x n quads between center - u - v and center + u + v; counter-clockwise seen against u x v.
void patch(Tessellation& t, Vec3 center, Vec3 u, Vec3 v, int n) {
  const int first = int(t.vertices.size() / 6);
  const Vec3 normal = spec::unit(cross(u, v));
  for (int j = 0; j <= n; j++)
    for (int i = 0; i <= n; i++) t.add(center + (2.0 * i / n - 1) * u + (2.0 * j / n - 1) * v, normal);
  t.connect(first, n, n);
}

Tessellation tessellate(const std::string& shape, int n) {
  Tessellation t;
  if (shape == "sphere") {
    const int stacks = n / 2;
    for (int j = 0; j <= stacks; j++)
      for (int i = 0; i <= n; i++) {
        const double u = 2 * std::numbers::pi * (i % n) / n,
                     v = std::numbers::pi * j / stacks - std::numbers::pi / 2;
        const Vec3 normal{std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)};
        t.add(kCenter + kRadius * normal, normal);
      }
    t.connect(0, n, stacks);
  } else if (shape == "plane") {
    const Vec3 u = spec::unit(cross({0, 0, -1}, kPlaneNormal));
    patch(t, kPlanePoint, -3.0 * u, 3.0 * cross(u, kPlaneNormal), n);
  } else {
    for (int axis = 0; axis < 3; axis++)
      for (double side : {1.0, -1.0}) {
        const Vec3 u = side * kBoxEdges[(axis + 1) % 3], v = kBoxEdges[(axis + 2) % 3];
        patch(t, kCenter + spec::length(kBoxEdges[axis]) * spec::unit(cross(u, v)), u, v, n);
      }
  }
  return t;
}

// Drawing
// -----------------------------------------------------------------------------------------------------------------

struct Drawing {
  const Setup* setup;
  const Tessellation* tessellation;
  GLenum shading;
  bool reflection;
} drawing;

void set_light(const Gl& gl, GLenum name, const spec::Light& light) {
  const auto set = [&](GLenum parameter, Vec3 v, double w = 1) {
    const GLfloat values[4] = {float(v.x), float(v.y), float(v.z), float(w)};
    gl.Lightfv(name, parameter, values);
  };
  gl.Enable(name);
  set(GL_AMBIENT, light.ambient), set(GL_DIFFUSE, light.diffuse), set(GL_SPECULAR, light.specular);
  set(GL_POSITION, light.position.xyz(), light.position.w);
  set(GL_SPOT_DIRECTION, light.spot_direction);
  gl.Lightf(name, GL_SPOT_EXPONENT, float(light.spot_exponent));
  gl.Lightf(name, GL_SPOT_CUTOFF, float(light.spot_cutoff));
  gl.Lightf(name, GL_CONSTANT_ATTENUATION, float(light.constant_attenuation));
  gl.Lightf(name, GL_LINEAR_ATTENUATION, float(light.linear_attenuation));
  gl.Lightf(name, GL_QUADRATIC_ATTENUATION, float(light.quadratic_attenuation));
}

void draw_shape(Stage& stage) {
  const Gl& gl = stage.gl;
  const Setup& s = *drawing.setup;
  gl.ClearColor(0, 0, 0, 0); // no alpha: not covered
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.MatrixMode(GL_PROJECTION);
  const double half = s.camera.perspective ? std::tan(s.camera.field_of_view / 2 * std::numbers::pi / 180)
                                           : s.camera.half_height;
  if (s.camera.perspective)
    gl.Frustum(-half, half, -half, half, 1, 20);
  else
    gl.Ortho(-half, half, -half, half, 1, 20);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Enable(GL_LIGHTING);
  const spec::LightModel& model = s.illumination.model;
  const GLfloat ambient[4] = {float(model.ambient.x), float(model.ambient.y), float(model.ambient.z), 1};
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, model.local_viewer);
  if (drawing.reflection) gl.LightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL, GL_REFLECTION_VECTOR_SOFTGL);
  for (size_t i = 0; i < s.illumination.lights.size(); i++)
    set_light(gl, GL_LIGHT0 + GLenum(i), s.illumination.lights[i]);
  const auto set = [&](GLenum parameter, Vec3 c) {
    const GLfloat values[4] = {float(c.x), float(c.y), float(c.z), 1};
    gl.Materialfv(GL_FRONT_AND_BACK, parameter, values);
  };
  set(GL_AMBIENT, s.material.kAmbient), set(GL_DIFFUSE, s.material.kDiffuse),
      set(GL_SPECULAR, s.material.kSpecular);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, float(s.material.phongExponent));
  gl.ShadeModel(drawing.shading);
  const Tessellation& t = *drawing.tessellation;
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);
  gl.NormalPointer(GL_FLOAT, 24, t.vertices.data());
  gl.VertexPointer(3, GL_FLOAT, 24, t.vertices.data() + 3);
  gl.DrawElements(GL_TRIANGLES, GLsizei(t.indices.size()), GL_UNSIGNED_INT, t.indices.data());
}

// Comparing
// ---------------------------------------------------------------------------------------------------------------

struct Exact {
  std::vector<int> part; // what the ray through each pixel hits: -1 nothing, 0 .. 5 the face of a box
  std::vector<uint8_t> rgb;
};

Exact cast(const Setup& s, const std::string& shape) {
  raycast::Scene scene;
  scene.camera = s.camera, scene.illumination = s.illumination;
  scene.shapes.push_back(exact(shape, s.material));
  Exact e;
  for (int y = 0; y < kSize; y++)
    for (int x = 0; x < kSize; x++) {
      const raycast::Ray ray = s.camera.ray(x + 0.5, y + 0.5);
      const std::optional<Hit> hit = scene.nearest(ray);
      const Vec3 color = hit ? hit->material->shade(*hit, ray, scene.illumination) : Vec3{};
      e.part.push_back(hit ? hit->part : -1);
      for (double c : {color.x, color.y, color.z}) e.rgb.push_back(spec::to_fixed_point(c));
    }
  return e;
}

void compare_pictures(const Exact& e, const Picture& p, int& pixels, double& equal, double& mean) {
  pixels = 0;
  size_t close = 0, sum = 0;
  for (int y = 1; y < kSize - 1; y++)
    for (int x = 1; x < kSize - 1; x++) {
      const auto at = [&](int dx, int dy) { return size_t((y + dy) * kSize + x + dx); };
      const size_t i = at(0, 0);
      bool inside = e.part[i] >= 0;
      for (int dy = -1; dy <= 1; dy++)
        for (int dx = -1; dx <= 1; dx++)
          inside &= e.part[at(dx, dy)] == e.part[i] && p.color[4 * at(dx, dy) + 3] == 255;
      if (!inside) continue;
      int largest = 0;
      for (size_t c = 0; c < 3; c++) {
        const int difference = std::abs(p.color[4 * i + c] - e.rgb[3 * i + c]);
        largest = std::max(largest, difference), sum += size_t(difference);
      }
      pixels++, close += largest <= 1;
    }
  equal = pixels ? double(close) / pixels : 0, mean = pixels ? double(sum) / (3.0 * pixels) : 0;
}

} // namespace

int raycast_setups() { return 24; }

std::vector<ConvergencePoint> compare_with_raycast(const std::string& shape, bool reflection,
                                                   const std::vector<int>& slices) {
  std::vector<ConvergencePoint> points;
  std::vector<Tessellation> tessellations;
  for (int n : slices) tessellations.push_back(tessellate(shape, n));
  const Scene scene{.name = "shape", .draw = draw_shape, .width = kSize, .height = kSize};
  for (int number = 0; number < raycast_setups(); number++) {
    const Setup setup = make_setup(number, reflection);
    const Exact e = cast(setup, shape);
    for (size_t i = 0; i < slices.size(); i++) {
      ConvergencePoint point{shape, setup.name, reflection, slices[i]};
      drawing = {&setup, &tessellations[i], GL_PHONG_WIN, reflection};
      compare_pictures(e, draw(softgl_library(), scene, 0), point.pixels, point.phong_equal,
                       point.phong_mean);
      drawing.shading = GL_SMOOTH;
      compare_pictures(e, draw(softgl_library(), scene, 0), point.pixels, point.gouraud_equal,
                       point.gouraud_mean);
      points.push_back(point);
    }
  }
  return points;
}

} // namespace softgl::test
