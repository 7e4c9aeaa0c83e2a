// One unit of 2-D textures: formats, filters, wraps, environments, mipmaps.
#include <cstring>

#include "conformance/families/common.h"

namespace softgl::test {

struct TextureOptions {
  bool mipmaps = true, odd_sizes = true, any_wrap = true, any_format = true;
  GLenum target = GL_TEXTURE_2D; // or GL_TEXTURE_RECTANGLE
};

static void upload(Stage& s, GLenum target, GLint internal_format, int level, int w, int h) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  static constexpr GLenum kFormats[] = {
      GL_RGBA, GL_RGBA, GL_RGBA, GL_RGB, GL_BGRA, GL_BGR, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_ALPHA, GL_RED};
  const GLenum format = kFormats[r.integer(0, 9)];
  static constexpr GLenum kTypes[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT,
                                      GL_FLOAT,         GL_UNSIGNED_INT,  GL_BYTE,          GL_SHORT};
  const GLenum type = kTypes[r.integer(0, 7)];
  const int bytes = type == GL_UNSIGNED_BYTE || type == GL_BYTE     ? 1
                    : type == GL_UNSIGNED_SHORT || type == GL_SHORT ? 2
                                                                    : 4;
  const int alignment = r.pick({1, 2, 4, 8}), extra = r.chance(20) ? r.integer(0, 5) : 0;
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, alignment);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, extra ? w + extra : 0);
  std::vector<uint8_t> pixels((size_t(w + extra) * 4 * size_t(bytes) + 8) * size_t(h) + 64);
  const bool blocks = r.chance(50);
  Float4 corner[4];
  for (Float4& c : corner) c = r.color();
  if (type == GL_FLOAT) {
    std::vector<float> values(pixels.size() / 4);
    for (float& v : values) v = r.real(-0.2f, 1.2f);
    std::memcpy(pixels.data(), values.data(), values.size() * 4);
  } else {
    for (size_t i = 0; i < pixels.size(); i++)
      pixels[i] = blocks ? uint8_t(corner[(i / 7) & 3][i & 3] * 255) : uint8_t(r.bits() >> 32);
  }
  gl.TexImage2D(target, level, internal_format, w, h, 0, format, type, pixels.data());
  if (r.chance(20) && w > 2 && h > 2) {
    const int x = r.integer(0, w - 2), y = r.integer(0, h - 2), sw = r.integer(1, w - x),
              sh = r.integer(1, h - y);
    gl.TexSubImage2D(target, level, x, y, sw, sh, format, type, pixels.data());
  }
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

static GLint random_internal_format(Stage& s) {
  return s.random.pick({GL_RGBA8,
                        GL_RGBA,
                        GL_RGB,
                        GL_RGB8,
                        GL_LUMINANCE,
                        GL_LUMINANCE8,
                        GL_LUMINANCE_ALPHA,
                        GL_LUMINANCE8_ALPHA8,
                        GL_ALPHA,
                        GL_ALPHA8,
                        GL_INTENSITY,
                        GL_INTENSITY8,
                        GL_RGB5,
                        GL_RGB4,
                        GL_R3_G3_B2,
                        GL_RGBA4,
                        GL_RGB5_A1,
                        GL_RGBA2,
                        GL_LUMINANCE4,
                        GL_ALPHA4,
                        GL_INTENSITY4,
                        GL_LUMINANCE4_ALPHA4,
                        GL_LUMINANCE6_ALPHA2,
                        GL_RGB10,
                        GL_RGB12,
                        GL_RGB16,
                        GL_RGBA12,
                        GL_RGBA16,
                        GL_RGB10_A2,
                        GL_LUMINANCE12,
                        GL_LUMINANCE16,
                        GL_ALPHA12,
                        GL_ALPHA16,
                        GL_INTENSITY12,
                        GL_INTENSITY16,
                        GL_LUMINANCE12_ALPHA12,
                        GL_LUMINANCE16_ALPHA16,
                        GL_LUMINANCE12_ALPHA4,
                        1,
                        2,
                        3,
                        4});
}

static void random_texture(Stage& s, const TextureOptions& o) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(o.target, name);
  const bool odd = o.odd_sizes && r.chance(30);
  int w = odd ? r.integer(1, 70) : 1 << r.integer(0, 6), h = odd ? r.integer(1, 70) : 1 << r.integer(0, 6);
  const GLint format = o.any_format ? random_internal_format(s) : r.pick({GL_RGBA8, GL_RGB8});
  GLint minify = r.pick({GL_NEAREST, GL_LINEAR}), magnify = r.pick({GL_NEAREST, GL_LINEAR});
  const bool mipmaps = o.mipmaps && r.chance(60);
  if (mipmaps)
    minify = r.pick({GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR,
                     GL_LINEAR_MIPMAP_LINEAR});
  const bool rectangle = o.target == GL_TEXTURE_RECTANGLE;
  if (rectangle) minify = magnify; // how large it is drawn: reference/DEVIATIONS.md
  // GL_CLAMP with one linear and one nearest filter: see reference/DEVIATIONS.md.
  const bool linear =
      minify == GL_LINEAR || minify == GL_LINEAR_MIPMAP_NEAREST || minify == GL_LINEAR_MIPMAP_LINEAR;
  const bool mixed = linear != (magnify == GL_LINEAR);
  for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    GLint wrap = o.any_wrap ? r.pick({GL_REPEAT, GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE, GL_CLAMP,
                                      GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT})
                            : r.pick({GL_REPEAT, GL_CLAMP_TO_EDGE});
    if (wrap == GL_CLAMP && mixed) wrap = GL_REPEAT;
    if (rectangle && (wrap == GL_REPEAT || wrap == GL_MIRRORED_REPEAT)) wrap = GL_CLAMP_TO_EDGE;
    gl.TexParameteri(o.target, axis, wrap);
  }
  gl.TexParameteri(o.target, GL_TEXTURE_MIN_FILTER, minify);
  gl.TexParameteri(o.target, GL_TEXTURE_MAG_FILTER, magnify);
  const Float4 border = r.color();
  gl.TexParameterfv(o.target, GL_TEXTURE_BORDER_COLOR, border.data());
  const bool generate = r.chance(40) && mipmaps;
  if (!rectangle) gl.TexParameteri(o.target, GL_GENERATE_MIPMAP, generate);
  upload(s, o.target, format, 0, w, h);
  if (mipmaps && !generate)
    for (int level = 1; w > 1 || h > 1; level++) {
      w = w > 1 ? w / 2 : 1, h = h > 1 ? h / 2 : 1;
      upload(s, o.target, format, level, w, h);
    }
  if (mipmaps && r.chance(20)) gl.TexParameteri(o.target, GL_TEXTURE_MAX_LEVEL, r.integer(0, 4));
  if (mipmaps && r.chance(10)) gl.TexParameterf(o.target, GL_TEXTURE_MIN_LOD, r.real(-1, 3));
  if (mipmaps && r.chance(10)) gl.TexParameterf(o.target, GL_TEXTURE_MAX_LOD, r.real(0, 4));
  if (r.chance(20)) gl.TexParameterf(o.target, GL_TEXTURE_LOD_BIAS, r.real(-2, 2));
  gl.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, r.chance(15) ? r.real(-2, 2) : 0.0f);
  gl.Enable(o.target);
}

static void random_environment(Stage& s, bool combine) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  const Float4 c = r.color();
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, c.data());
  if (!combine) {
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
               r.pick({GL_MODULATE, GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD}));
    return;
  }
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB,
             r.pick({GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB,
                     GL_DOT3_RGBA}));
  gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA,
             r.pick({GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT}));
  for (int i = 0; i < 3; i++) {
    gl.TexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB + GLenum(i),
               r.pick({GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS}));
    gl.TexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_ALPHA + GLenum(i),
               r.pick({GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS}));
    gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB + GLenum(i),
               r.pick({GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}));
    gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA + GLenum(i), r.pick({GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}));
  }
  gl.TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, r.pick({1.0f, 2.0f, 4.0f}));
  gl.TexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, r.pick({1.0f, 2.0f, 4.0f}));
}

static void textured_batch(Stage& s, const TextureOptions& o, bool combine) {
  random_projection(s);
  random_modelview(s);
  random_depth(s, 30);
  random_texture(s, o);
  random_environment(s, combine);
  s.gl.ShadeModel(s.random.chance(70) ? GL_SMOOTH : GL_FLAT);
  PrimitiveOptions options;
  options.mode = s.random.chance(8) ? GLenum(s.random.pick({GL_POINTS, GL_LINES})) : random_filled_mode(s);
  options.texture_coordinates = s.random.chance(70) ? 2 : s.random.integer(1, 4);
  options.texture_scale = s.random.pick({0.6f, 1.0f, 2.0f, 8.0f, 40.0f});
  if (o.target == GL_TEXTURE_RECTANGLE) options.texture_scale *= 20;
  options.spread = s.random.chance(65) ? Spread::View : Spread::Any;
  options.primitives = s.random.integer(2, 12);
  s.gl.PointSize(9);
  s.gl.LineWidth(3);
  random_primitive(s, options);
}

static void draw_texture(Stage& s) {
  random_canvas(s);
  TextureOptions o;
  o.mipmaps = o.any_format = o.any_wrap = false;
  for (int batch = s.random.integer(1, 2); batch > 0; batch--) textured_batch(s, o, false);
}

static void draw_wraps(Stage& s) {
  random_canvas(s);
  TextureOptions o;
  o.mipmaps = s.random.chance(30);
  o.any_format = false;
  textured_batch(s, o, false);
}

static void draw_mipmaps(Stage& s) {
  random_canvas(s);
  TextureOptions o;
  o.any_format = o.any_wrap = false;
  for (int batch = s.random.integer(1, 2); batch > 0; batch--) textured_batch(s, o, false);
}

static void draw_formats(Stage& s) {
  random_canvas(s);
  TextureOptions o;
  o.mipmaps = s.random.chance(40);
  for (int batch = s.random.integer(1, 2); batch > 0; batch--) textured_batch(s, o, s.random.chance(15));
}

static void draw_rectangles(Stage& s) {
  random_canvas(s);
  TextureOptions o;
  o.target = GL_TEXTURE_RECTANGLE;
  o.mipmaps = false;
  for (int batch = s.random.integer(1, 2); batch > 0; batch--) textured_batch(s, o, s.random.chance(15));
}

static void draw_combine(Stage& s) {
  random_canvas(s);
  TextureOptions o;
  o.any_format = s.random.chance(50);
  o.mipmaps = false;
  o.any_wrap = false;
  for (int batch = s.random.integer(1, 2); batch > 0; batch--) {
    if (s.random.chance(30)) {
      s.gl.Enable(GL_COLOR_SUM);
      if (s.random.chance(50)) random_fog(s);
    }
    textured_batch(s, o, s.random.chance(80));
  }
}

static SceneRegistration texture{{"texture", draw_texture, true}}, wraps{{"wraps", draw_wraps, true}},
    mipmaps{{"mipmaps", draw_mipmaps, true}}, formats{{"formats", draw_formats, true}},
    combine{{"combine", draw_combine, true}}, rectangles{{"rectangles", draw_rectangles, true}};

} // namespace softgl::test
