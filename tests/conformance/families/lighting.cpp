// Lighting: every parameter of lights, light model and material, in every normal mode.
#include "conformance/families/common.h"

namespace softgl::test {

static void random_material(Stage& s, GLenum face, bool shininess_may_be_zero) {
  const Gl& gl = s.gl;
  for (GLenum parameter : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) {
    Float4 c = s.random.color();
    if (parameter == GL_EMISSION)
      for (float& x : c) x *= 0.2f;
    if (s.random.chance(80)) gl.Materialfv(face, parameter, c.data());
  }
  const int kind = s.random.integer(0, 9);
  const float shininess = kind == 0 && shininess_may_be_zero ? 0.0f
                          : kind == 1                        ? 128.0f
                          : kind < 5                         ? float(s.random.integer(1, 128))
                                                             : s.random.real(0.5f, 128);
  gl.Materialf(face, GL_SHININESS, shininess);
}

// Returns true when the light is attenuated or a spot.
static bool random_light(Stage& s, GLenum light) {
  const Gl& gl = s.gl;
  gl.Enable(light);
  for (GLenum parameter : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) {
    Float4 c = s.random.color();
    const float f = parameter == GL_AMBIENT ? 0.3f : s.random.chance(10) ? 2.0f : 0.7f;
    for (float& x : c) x *= f;
    if (s.random.chance(85)) gl.Lightfv(light, parameter, c.data());
  }
  const Float3 d = s.random.direction();
  const bool positional = s.random.chance(50);
  const float distance = s.random.real(0.5f, 5);
  Float4 position{d[0] * distance, d[1] * distance, d[2] * distance,
                  positional ? s.random.chance(70) ? 1.0f : s.random.real(0.3f, 2) : 0.0f};
  if (s.random.chance(60) && position[2] < 0) position[2] = -position[2];
  const bool moved = s.random.chance(30);
  if (moved) {
    gl.PushMatrix();
    rigid_modelview(s);
  }
  gl.Lightfv(light, GL_POSITION, position.data());
  bool special = false;
  if (s.random.chance(35)) {
    const Float3 t = s.random.direction();
    const Float3 toward = s.random.chance(70) ? Float3{-position[0], -position[1], -position[2] - 1} : t;
    gl.Lightfv(light, GL_SPOT_DIRECTION, toward.data());
    gl.Lightf(light, GL_SPOT_CUTOFF, s.random.chance(15) ? 90.0f : s.random.real(5, 90));
    gl.Lightf(light, GL_SPOT_EXPONENT, s.random.chance(30) ? 0.0f : s.random.real(0, 128));
    special = true;
  }
  if (moved) gl.PopMatrix();
  if (s.random.chance(40)) {
    gl.Lightf(light, GL_CONSTANT_ATTENUATION, s.random.chance(50) ? 1.0f : s.random.real(0.1f, 1.5f));
    if (s.random.chance(60)) gl.Lightf(light, GL_LINEAR_ATTENUATION, s.random.real(0, 1));
    if (s.random.chance(60)) gl.Lightf(light, GL_QUADRATIC_ATTENUATION, s.random.real(0, 1));
    special = true;
  }
  return special;
}

struct LightingOptions {
  bool modelview_any = true, color_material = true, materials_inside = true, secondary = true;
  GLenum shade_model = GL_SMOOTH; // or flat
  bool illumination = false;      // GL_SOFTGL_phong_illumination
  bool texture = false;           // is on, and needs coordinates
};

static void lit_batch(Stage& s, const LightingOptions& o) {
  const Gl& gl = s.gl;
  random_projection(s);
  random_depth(s, 60);
  random_culling(s);
  gl.Enable(GL_LIGHTING);
  for (int i = 0; i < 8; i++) gl.Disable(GL_LIGHT0 + GLenum(i));
  bool special = false;
  for (int i = s.random.chance(70) ? s.random.integer(1, 2) : s.random.integer(0, 8); i > 0; i--)
    special |= random_light(s, GL_LIGHT0 + GLenum(s.random.integer(0, 7)));
  const Float4 ambient = s.random.color();
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient.data());
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, s.random.chance(40));
  const bool two_sided = s.random.chance(40);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, two_sided);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                 o.secondary && s.random.chance(35) ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
  if (s.random.chance(50)) {
    random_material(s, GL_FRONT_AND_BACK, !special);
  } else {
    random_material(s, GL_FRONT, !special);
    random_material(s, GL_BACK, !special);
  }
  const bool color_material = o.color_material && s.random.chance(35);
  if (color_material) {
    // A back material that varies under two-sided lighting: reference/DEVIATIONS.md.
    const GLenum face =
        two_sided ? GLenum(GL_FRONT) : GLenum(s.random.pick({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}));
    gl.ColorMaterial(face, GLenum(s.random.pick(
                               {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE})));
    gl.Enable(GL_COLOR_MATERIAL);
  } else {
    gl.Disable(GL_COLOR_MATERIAL);
  }
  if (o.modelview_any)
    random_modelview(s);
  else
    rigid_modelview(s);
  gl.Disable(GL_NORMALIZE);
  gl.Disable(GL_RESCALE_NORMAL);
  switch (s.random.integer(0, 3)) {
  case 0:
  case 1: gl.Enable(GL_NORMALIZE); break;
  case 2: gl.Enable(GL_RESCALE_NORMAL); break;
  default: break;
  }
  if (o.illumination) {
    gl.LightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL,
                   s.random.chance(50) ? GL_REFLECTION_VECTOR_SOFTGL : GL_HALF_VECTOR_SOFTGL);
    gl.LightModeli(GL_LIGHT_MODEL_TERMS_SOFTGL, s.random.chance(70)
                                                    ? GL_ALL_TERM_BITS_SOFTGL
                                                    : s.random.integer(0, GL_ALL_TERM_BITS_SOFTGL));
  }
  gl.ShadeModel(s.random.chance(75) ? o.shade_model : GL_FLAT);
  if (s.random.chance(40)) {
    if (color_material) {
      const Float4 c = s.random.color();
      gl.Color4fv(c.data());
    }
    const int slices = s.random.integer(5, 20), stacks = s.random.integer(3, 12);
    sphere(s, slices, stacks, s.random.real(0.5f, 1.1f), o.texture);
  } else {
    PrimitiveOptions options;
    options.mode = s.random.chance(10) ? GLenum(s.random.pick({GL_POINTS, GL_LINES, GL_LINE_STRIP}))
                                       : random_filled_mode(s);
    // Vertex by vertex, not in the pairs in which OSMesa cuts strips of quads, now so and now so, where they
    // are folded.
    if (o.texture && (options.mode == GL_QUADS || options.mode == GL_QUAD_STRIP))
      options.mode = GL_TRIANGLE_STRIP;
    options.normals = true;
    options.colors = color_material || s.random.chance(20);
    options.materials = o.materials_inside && s.random.chance(30);
    options.front_materials = two_sided;
    if (o.texture) options.texture_coordinates = s.random.integer(2, 4);
    options.spread = s.random.chance(70) ? Spread::View : Spread::Any;
    gl.PointSize(7);
    random_primitive(s, options);
  }
}

static void draw_lit(Stage& s) {
  random_canvas(s);
  LightingOptions o;
  o.modelview_any = o.color_material = o.materials_inside = o.secondary = false;
  for (int batch = s.random.integer(1, 2); batch > 0; batch--) lit_batch(s, o);
}

static void draw_materials(Stage& s) {
  random_canvas(s);
  LightingOptions o;
  o.modelview_any = false;
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) lit_batch(s, o);
}

static void draw_normals(Stage& s) {
  random_canvas(s);
  lit_batch(s, {});
  if (s.random.chance(40)) {
    if (s.random.chance(40)) random_fog(s);
    lit_batch(s, {});
  }
}

static void draw_illumination(Stage& s) {
  random_canvas(s);
  LightingOptions o;
  o.illumination = true;
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) lit_batch(s, o);
}

// Unit 0 modulates. Filtered, that no texel ends where a rounding error could be seen.
static void random_texture(Stage& s) {
  const Gl& gl = s.gl;
  uint8_t texels[8 * 8 * 4];
  for (uint8_t& t : texels) t = uint8_t(s.random.integer(0, 255));
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
}

static void draw_phong(Stage& s) {
  random_canvas(s);
  LightingOptions o;
  o.shade_model = GL_PHONG_WIN;
  o.illumination = s.random.chance(50);
  o.texture = s.random.chance(30);
  if (o.texture) random_texture(s);
  if (s.random.chance(30)) {
    random_fog(s);
    const Float2 range{s.random.real(-1, 2),
                       s.random.real(2.5f, 6)}; // never empty: what that means is not specified
    s.gl.Fogf(GL_FOG_START, range[0]);
    s.gl.Fogf(GL_FOG_END, range[1]);
  }
  if (s.random.chance(20)) random_alpha_test(s);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) lit_batch(s, o);
}

static SceneRegistration lit{{"lit", draw_lit, true}}, materials{{"materials", draw_materials, true}},
    normals{{"normals", draw_normals, true}};
static SceneRegistration illumination{
    {.name = "illumination", .draw = draw_illumination, .random = true, .extension = true}};
static SceneRegistration phong{{.name = "phong", .draw = draw_phong, .random = true, .extension = true}};

} // namespace softgl::test
