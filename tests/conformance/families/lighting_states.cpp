// Ten lighting states a scene, each in a cell of its own: every parameter of lights, light model, materials,
// color material and normal transformation, out to its limits. The states of one scene share what makes
// OSMesa compile a program (which lights there are, and of what kind) and differ in all numbers, so that ten
// thousand are soon drawn.
#include "conformance/families/lighting_states.h"
#include "conformance/families/common.h"

#include <algorithm>
#include <cmath>

namespace softgl::test {
namespace {

constexpr int kColumns = 5, kRows = 2;

// Materials: some parameters keep their defaults; zero exponents are a program of their own.
void set_material(Stage& s, Random& shape, GLenum face, bool exponent_zero) {
  const Gl& gl = s.gl;
  for (GLenum parameter : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) {
    Float4 c = s.random.color();
    if (parameter == GL_EMISSION)
      for (float& x : c) x *= s.random.pick({0.0f, 0.1f, 0.3f});
    if (shape.chance(90)) gl.Materialfv(face, parameter, c.data());
  }
  const float shininess = s.random.pick(
      {1.0f, 128.0f, float(s.random.integer(1, 127)), s.random.real(0.01f, 2), s.random.real(1, 128)});
  gl.Materialf(face, GL_SHININESS, exponent_zero && shape.chance(15) ? 0.0f : shininess);
}

void set_light(Stage& s, Random& shape, GLenum light, const LightingStateOptions& options) {
  const Gl& gl = s.gl;
  gl.Enable(light);
  for (GLenum parameter : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) {
    Float4 c = s.random.color();
    const float f = parameter == GL_AMBIENT ? 0.3f : s.random.pick({0.7f, 0.7f, 1.0f, 3.0f, -0.3f});
    for (float& x : c) x *= f;
    gl.Lightfv(light, parameter, c.data());
  }
  const Float3 d = s.random.direction();
  const float distance = s.random.pick({0.3f, 1.0f, s.random.real(0.5f, 5), 100.0f});
  const float w = s.random.pick({1.0f, 1.0f, s.random.real(0.2f, 3), -1.0f});
  const float towards_us = s.random.chance(70) ? std::fabs(d[2]) : d[2];
  const bool positional = shape.chance(50), moved = shape.chance(30);
  const float scale = distance * (positional ? w : 1.0f);
  const Float4 position{d[0] * scale, d[1] * scale, towards_us * scale, positional ? w : 0.0f};
  if (moved) {
    gl.PushMatrix();
    random_modelview(s);
  }
  gl.Lightfv(light, GL_POSITION, position.data());
  const Float3 anywhere = s.random.direction();
  const Float3 inwards{-d[0], -d[1], -towards_us};
  const bool spot = shape.chance(40);
  gl.Lightfv(light, GL_SPOT_DIRECTION, s.random.chance(70) ? inwards.data() : anywhere.data());
  float cutoff = s.random.pick(
      {90.0f, 0.0f, 89.99f, 0.5f, s.random.real(1, 90), s.random.real(20, 90), s.random.real(20, 90)});
  if (options.well_conditioned) cutoff = std::max(cutoff, 5.0f);
  gl.Lightf(light, GL_SPOT_CUTOFF, spot ? cutoff : 180.0f);
  gl.Lightf(light, GL_SPOT_EXPONENT,
            s.random.pick({0.0f, 1.0f, 128.0f, s.random.real(0, 2), s.random.real(0, 128)}));
  if (moved) gl.PopMatrix();
  const bool attenuated = shape.chance(45);
  float constant = s.random.pick({1.0f, 0.25f, 0.0f, s.random.real(0.1f, 2)});
  const float linear = s.random.pick({0.0f, s.random.real(0, 1)}),
              quadratic = s.random.pick({0.0f, s.random.real(0, 1), 0.01f});
  if (options.well_conditioned && linear == 0 && quadratic == 0) constant = 1; // not infinitely bright
  gl.Lightf(light, GL_CONSTANT_ATTENUATION, attenuated ? constant : 1.0f);
  gl.Lightf(light, GL_LINEAR_ATTENUATION, attenuated ? linear : 0.0f);
  gl.Lightf(light, GL_QUADRATIC_ATTENUATION, attenuated ? quadratic : 0.0f);
}

// A hilly sheet: triangles that share their vertices, with normals of any length.
void sheet(Stage& s, int n) {
  std::vector<float> vertices;
  std::vector<uint16_t> indices;
  const float a = s.random.real(1, 4), b = s.random.real(1, 4), height = s.random.real(0.1f, 0.5f);
  for (int j = 0; j <= n; j++)
    for (int i = 0; i <= n; i++) {
      const float x = 2 * float(i) / float(n) - 1, y = 2 * float(j) / float(n) - 1;
      vertices.insert(vertices.end(), {-a * height * std::cos(a * x), -b * height * std::cos(b * y), 1, x, y,
                                       height * (std::sin(a * x) + std::sin(b * y))});
    }
  for (int j = 0; j < n; j++)
    for (int i = 0; i < n; i++) {
      const int k = j * (n + 1) + i;
      for (int index : {k, k + 1, k + n + 2, k, k + n + 2, k + n + 1}) indices.push_back(uint16_t(index));
    }
  s.gl.EnableClientState(GL_VERTEX_ARRAY);
  s.gl.EnableClientState(GL_NORMAL_ARRAY);
  s.gl.NormalPointer(GL_FLOAT, 24, vertices.data());
  s.gl.VertexPointer(3, GL_FLOAT, 24, vertices.data() + 3);
  s.gl.DrawElements(GL_TRIANGLES, GLsizei(indices.size()), GL_UNSIGNED_SHORT, indices.data());
  s.gl.DisableClientState(GL_VERTEX_ARRAY);
  s.gl.DisableClientState(GL_NORMAL_ARRAY);
}

void draw_surface(Stage& s, Random& shape, bool color_material) {
  const Gl& gl = s.gl;
  if (color_material) {
    const Float4 c = s.random.color();
    gl.Color4fv(c.data());
  }
  switch (shape.integer(0, 2)) {
  case 0: {
    const int slices = s.random.integer(6, 16), stacks = s.random.integer(4, 10);
    return sphere(s, slices, stacks, s.random.real(0.5f, 1.1f), false);
  }
  case 1: return sheet(s, s.random.integer(2, 8));
  default: {
    PrimitiveOptions options;
    options.mode = GLenum(shape.pick({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN}));
    options.primitives = s.random.integer(2, 6);
    options.spread = Spread::View;
    options.normals = true;
    options.colors = color_material;
    random_primitive(s, options);
  }
  }
}

// Moves the eye three units back; the picture stays the same.
void step_back(const Gl& gl) {
  GLfloat modelview[16];
  gl.GetFloatv(GL_MODELVIEW_MATRIX, modelview);
  gl.LoadIdentity();
  gl.Translatef(0, 0, -3);
  gl.MultMatrixf(modelview);
}

void draw_state(Stage& s, Random shape, const LightingStateOptions& options) {
  const Gl& gl = s.gl;
  random_projection(s);
  if (options.well_conditioned) {
    gl.LoadIdentity();
    gl.MatrixMode(GL_PROJECTION);
    gl.Translatef(0, 0, 3);
    gl.MatrixMode(GL_MODELVIEW);
    step_back(gl);
  }
  gl.Enable(GL_LIGHTING);
  for (int i = 0; i < 8; i++) gl.Disable(GL_LIGHT0 + GLenum(i));
  for (int i = shape.chance(80) ? shape.integer(1, 2) : shape.integer(0, 8); i > 0; i--) {
    const GLenum light = GL_LIGHT0 + GLenum(shape.integer(0, 7));
    set_light(s, shape, light, options);
  }
  Float4 ambient = s.random.color();
  for (float& x : ambient) x *= 0.4f;
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient.data());
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, shape.chance(50));
  const bool two_sided = shape.chance(50);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, two_sided);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                 shape.chance(40) ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
  gl.FrontFace(s.random.chance(50) ? GL_CCW : GL_CW);
  gl.Disable(GL_COLOR_MATERIAL);
  set_material(s, shape, GL_FRONT, options.exponent_zero);
  set_material(s, shape, GL_BACK, options.exponent_zero);
  const bool color_material = shape.chance(40);
  if (color_material) {
    // A back material that varies under two-sided lighting: reference/DEVIATIONS.md.
    const GLenum face = two_sided && !options.back_colors
                            ? GLenum(GL_FRONT)
                            : GLenum(shape.pick({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}));
    gl.ColorMaterial(
        face, GLenum(shape.pick({GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE})));
    gl.Enable(GL_COLOR_MATERIAL);
  }
  random_modelview(s);
  if (options.well_conditioned) step_back(gl);
  gl.Disable(GL_NORMALIZE);
  gl.Disable(GL_RESCALE_NORMAL);
  switch (shape.integer(0, 4)) {
  case 0:
  case 1: gl.Enable(GL_NORMALIZE); break;
  case 2: gl.Enable(GL_RESCALE_NORMAL); break;
  case 3: gl.Enable(GL_RESCALE_NORMAL), gl.Enable(GL_NORMALIZE); break;
  default: break;
  }
  const GLenum shading = shape.chance(85) ? GL_SMOOTH : GL_FLAT;
  gl.ShadeModel(options.phong ? GLenum(GL_PHONG_WIN) : shading);
  if (options.illumination) {
    gl.LightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL,
                   shape.chance(50) ? GL_REFLECTION_VECTOR_SOFTGL : GL_HALF_VECTOR_SOFTGL);
    gl.LightModeli(GL_LIGHT_MODEL_TERMS_SOFTGL,
                   shape.chance(67) ? GL_ALL_TERM_BITS_SOFTGL : s.random.integer(0, GL_ALL_TERM_BITS_SOFTGL));
  }
  draw_surface(s, shape, color_material);
}

SceneRegistration lighting{
    {.name = "lighting", .draw = [](Stage& s) { draw_lighting_states(s, {}); }, .random = true}};
SceneRegistration gouraud{
    {.name = "gouraud_twin",
     .draw =
         [](Stage& s) {
           draw_lighting_states(s, {.exponent_zero = false, .illumination = true, .well_conditioned = true});
         },
     .random = true,
     .extension = true}};
SceneRegistration phong{
    {.name = "phong_twin",
     .draw =
         [](Stage& s) {
           draw_lighting_states(
               s, {.phong = true, .illumination = true, .well_conditioned = true, .back_colors = true});
         },
     .random = true,
     .extension = true}};

} // namespace

void draw_lighting_states(Stage& s, const LightingStateOptions& options) {
  const Float4 c = s.random.color();
  s.gl.ClearColor(c[0], c[1], c[2], c[3]);
  s.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  s.gl.Enable(GL_DEPTH_TEST);
  const Random shape(s.random.bits());
  for (int i = 0; i < kColumns * kRows; i++) {
    s.gl.Viewport(s.width * (i % kColumns) / kColumns, s.height * (i / kColumns) / kRows, s.width / kColumns,
                  s.height / kRows);
    draw_state(s, shape, options);
  }
}

} // namespace softgl::test
