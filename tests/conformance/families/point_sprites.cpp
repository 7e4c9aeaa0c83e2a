// Point sprites (GL_ARB_point_sprite): squares with coordinates of their own.
#include "conformance/families/common.h"

namespace softgl::test {

static void sprite_texture(Stage& s) {
  GLuint name = 0;
  s.gl.GenTextures(1, &name);
  s.gl.BindTexture(GL_TEXTURE_2D, name);
  const int size = 1 << s.random.integer(1, 5);
  std::vector<uint8_t> texels(size_t(size * size) * 4);
  for (uint8_t& t : texels) t = uint8_t(s.random.bits() >> 40);
  s.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  const GLint filter = s.random.pick({GL_NEAREST, GL_LINEAR});
  s.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  s.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  s.gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, s.random.pick({GL_REPLACE, GL_MODULATE, GL_ADD}));
  s.gl.Enable(GL_TEXTURE_2D);
}

static void draw_point_sprites(Stage& s) {
  random_canvas(s);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) {
    const int units = s.random.integer(1, 2);
    for (int u = 0; u < 2; u++) {
      s.gl.ActiveTexture(GLenum(GL_TEXTURE0 + u));
      sprite_texture(s);
      if (u >= units) s.gl.Disable(GL_TEXTURE_2D);
      s.gl.TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, s.random.chance(70) ? GL_TRUE : GL_FALSE);
    }
    s.gl.ActiveTexture(GL_TEXTURE0);
    random_projection(s);
    random_modelview(s);
    random_depth(s, 30);
    random_scissor(s, 10);
    s.gl.Disable(GL_SCISSOR_TEST); // OSMesa draws a row below the box (reference/DEVIATIONS.md)
    if (s.random.chance(30)) random_blending(s);
    if (s.random.chance(80))
      s.gl.Enable(GL_POINT_SPRITE);
    else
      s.gl.Disable(GL_POINT_SPRITE);
    s.gl.PointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, s.random.chance(50) ? GL_LOWER_LEFT : GL_UPPER_LEFT);
    const int kind = s.random.integer(0, 2);
    const float usual = s.random.real(0.2f, 12), large = s.random.real(1, 100);
    s.gl.PointSize(kind == 0 ? float(s.random.integer(1, 16)) : kind == 1 ? usual : large);
    if (s.random.chance(20)) random_fog(s);
    PrimitiveOptions options;
    options.mode = GL_POINTS;
    options.primitives = s.random.integer(3, 40);
    options.texture_coordinates = s.random.integer(1, 4);
    random_primitive(s, options);
  }
}

static SceneRegistration point_sprites{{"point_sprites", draw_point_sprites, true}};

} // namespace softgl::test
