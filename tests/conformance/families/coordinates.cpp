// What becomes of texture coordinates and point sizes at the vertex: generation, texture matrix, distance
// attenuation.
#include "conformance/families/common.h"

namespace softgl::test {
namespace {

void some_texture(Stage& s) {
  std::vector<uint8_t> texels(64 * 64 * 4);
  for (uint8_t& t : texels) t = uint8_t(s.random.bits() >> 40);
  s.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  const GLint filter = s.random.pick({GL_NEAREST, GL_LINEAR});
  s.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  s.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  s.gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, s.random.pick({GL_REPLACE, GL_MODULATE}));
  s.gl.Enable(GL_TEXTURE_2D);
}

Float4 random_plane(Stage& s) {
  return {s.random.real(-1, 1), s.random.real(-1, 1), s.random.real(-1, 1), s.random.real(-0.5f, 0.5f)};
}

void random_generation(Stage& s) {
  static constexpr GLenum kCoordinate[4] = {GL_S, GL_T, GL_R, GL_Q};
  static constexpr GLenum kEnable[4] = {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R,
                                        GL_TEXTURE_GEN_Q};
  const GLint common =
      s.random.pick({GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_REFLECTION_MAP, GL_NORMAL_MAP});
  const bool mixed = s.random.chance(30);
  for (int i = 0; i < 4; i++) {
    GLint mode = mixed ? s.random.pick({GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_REFLECTION_MAP,
                                        GL_NORMAL_MAP})
                       : common;
    if (mode == GL_SPHERE_MAP && i >= 2) mode = GL_OBJECT_LINEAR;
    if (i == 3 && (mode == GL_REFLECTION_MAP || mode == GL_NORMAL_MAP)) mode = GL_EYE_LINEAR;
    s.gl.TexGeni(kCoordinate[i], GL_TEXTURE_GEN_MODE, mode);
    const Float4 object = random_plane(s), eye = random_plane(s);
    s.gl.TexGenfv(kCoordinate[i], GL_OBJECT_PLANE, object.data());
    s.gl.TexGenfv(kCoordinate[i], GL_EYE_PLANE, eye.data());
    if (s.random.chance(i < 2 ? 80 : 20))
      s.gl.Enable(kEnable[i]);
    else
      s.gl.Disable(kEnable[i]);
  }
}

void random_texture_matrix(Stage& s) {
  s.gl.MatrixMode(GL_TEXTURE);
  s.gl.LoadIdentity();
  if (s.random.chance(50)) {
    const float x = s.random.real(-1, 1), y = s.random.real(-1, 1);
    s.gl.Translatef(x, y, 0);
    s.gl.Rotatef(s.random.real(-180, 180), 0.2f, 0.3f, 1);
    const Float2 scale = {s.random.real(0.5f, 3), s.random.real(0.5f, 3)};
    s.gl.Scalef(scale[1], scale[0], 1);
  }
  s.gl.MatrixMode(GL_MODELVIEW);
}

void perhaps_lit(Stage& s) {
  if (s.random.chance(30)) {
    s.gl.Enable(GL_LIGHTING);
    s.gl.Enable(GL_LIGHT0);
  } else {
    s.gl.Disable(GL_LIGHTING);
  }
}

void draw_coordinates(Stage& s) {
  random_canvas(s);
  some_texture(s);
  for (int batch = s.random.integer(1, 2); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_generation(s);
    random_texture_matrix(s);
    if (s.random.chance(50))
      s.gl.Enable(GL_NORMALIZE);
    else
      s.gl.Disable(GL_NORMALIZE);
    perhaps_lit(s);
    if (s.random.chance(30)) random_fog(s);
    if (s.random.chance(40)) {
      const float radius = s.random.real(0.5f, 1);
      const int stacks = s.random.integer(3, 10), slices = s.random.integer(5, 16);
      sphere(s, slices, stacks, radius, true);
      continue;
    }
    PrimitiveOptions options;
    options.mode = random_filled_mode(s);
    if (options.mode == GL_QUADS)
      options.mode = GL_POLYGON; // a diagonal of OSMesa's own, see random_primitive
    options.normals = true;
    options.texture_coordinates = s.random.integer(1, 4);
    options.spread = Spread::View;
    random_primitive(s, options);
  }
}

void draw_attenuated(Stage& s) {
  random_canvas(s);
  s.gl.Viewport(0, 0, s.width, s.height); // OSMesa cuts such points at the viewport: reference/DEVIATIONS.md
  random_projection(s);
  random_modelview(s);
  random_depth(s, 50);
  s.gl.PointSize(s.random.real(0.5f, 40));
  // OSMesa does not let points shrink: reference/DEVIATIONS.md.
  const GLfloat k[3] = {s.random.real(0.01f, 0.3f), s.random.real(0, 0.04f), s.random.real(0, 0.008f)};
  s.gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, k);
  s.gl.PointParameterf(GL_POINT_SIZE_MAX, s.random.chance(50) ? s.random.real(5, 20) : 255);
  if (s.random.chance(30)) random_fog(s);
  PrimitiveOptions options;
  options.mode = GL_POINTS;
  options.primitives = s.random.integer(5, 60);
  random_primitive(s, options);
}

/// Coordinates that no vertex sets, often on the edge of a texel: the last bit decides which one it is.
void draw_constant_coordinates(Stage& s) {
  random_canvas(s);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) {
    const int units = s.random.integer(1, 2);
    for (int u = 0; u < units; u++) {
      s.gl.ActiveTexture(GLenum(GL_TEXTURE0 + u));
      some_texture(s);
      for (GLenum g : {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q})
        s.gl.Disable(g);
      s.gl.MatrixMode(GL_TEXTURE);
      s.gl.LoadIdentity();
      s.gl.MatrixMode(GL_MODELVIEW);
      if (s.random.chance(20)) random_generation(s);
      if (s.random.chance(20)) random_texture_matrix(s);
      const auto coordinate = [&] {
        return s.random.chance(50) ? float(s.random.integer(-128, 128)) / 128 : s.random.real(-2, 2);
      };
      const Float4 c = {coordinate(), coordinate(), coordinate(),
                        s.random.chance(50) ? 1 : s.random.real(0.2f, 3)};
      s.gl.MultiTexCoord4fv(GLenum(GL_TEXTURE0 + u), c.data());
    }
    s.gl.ActiveTexture(GL_TEXTURE0);
    random_projection(s);
    random_modelview(s);
    perhaps_lit(s);
    if (s.random.chance(20)) random_fog(s);
    s.gl.PointSize(s.random.real(1, 20));
    s.gl.LineWidth(s.random.real(1, 5));
    if (s.random.chance(20))
      s.gl.Enable(GL_POINT_SPRITE);
    else
      s.gl.Disable(GL_POINT_SPRITE);
    PrimitiveOptions options;
    options.mode = s.random.chance(30) ? GLenum(s.random.pick({GL_POINTS, GL_LINES})) : random_filled_mode(s);
    if (options.mode == GL_QUADS)
      options.mode = GL_POLYGON; // a diagonal of OSMesa's own, see random_primitive
    options.normals = true;
    options.spread = s.random.chance(70) ? Spread::View : Spread::Any;
    options.texture_coordinates = units == 2 && s.random.chance(30) ? 2 : 0; // of unit 0 alone
    random_primitive(s, options);
  }
}

/// Generated coordinates of several units, so large that their last bits choose the texel: what OSMesa's
/// compiler makes of them depends on what else is generated.
void draw_generated_coordinates(Stage& s) {
  random_canvas(s);
  for (int batch = s.random.integer(1, 2); batch > 0; batch--) {
    const int units = s.random.integer(1, 3);
    for (int u = 0; u < 3; u++) {
      s.gl.ActiveTexture(GLenum(GL_TEXTURE0 + u));
      GLuint name = 0;
      s.gl.GenTextures(1, &name);
      s.gl.BindTexture(GL_TEXTURE_2D, name);
      some_texture(s);
      s.gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, u ? GL_ADD : GL_REPLACE);
      if (u >= units) s.gl.Disable(GL_TEXTURE_2D);
      random_generation(s);
      s.gl.MatrixMode(GL_TEXTURE);
      s.gl.LoadIdentity();
      if (const int bits = s.random.integer(0, 14); bits > 4)
        s.gl.Scalef(float(1 << bits), float(1 << bits), 1);
      s.gl.MatrixMode(GL_MODELVIEW);
    }
    s.gl.ActiveTexture(GL_TEXTURE0);
    random_projection(s);
    random_modelview(s);
    s.random.chance(50) ? s.gl.Enable(GL_NORMALIZE) : s.gl.Disable(GL_NORMALIZE);
    perhaps_lit(s);
    if (s.random.chance(20)) random_fog(s);
    PrimitiveOptions options;
    options.mode = GL_TRIANGLES;
    options.primitives = s.random.integer(5, 30);
    options.normals = true;
    options.texture_coordinates = s.random.integer(1, 4);
    options.spread = Spread::View;
    random_primitive(s, options);
  }
}

SceneRegistration coordinates{{"coordinates", draw_coordinates, true}},
    attenuated{{"attenuated", draw_attenuated, true}};
SceneRegistration constant_coordinates{{"constant_coordinates", draw_constant_coordinates, true}};
SceneRegistration generated_coordinates{{"generated_coordinates", draw_generated_coordinates, true}};

} // namespace
} // namespace softgl::test
