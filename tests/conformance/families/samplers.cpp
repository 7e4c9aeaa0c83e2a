// Sampler objects (GL_ARB_sampler_objects): their parameters take the place of the textures'.
#include "conformance/families/common.h"

namespace softgl::test {
namespace {

constexpr int kTexels = 32 * 32 * 4;

void random_image(Stage& s, GLenum target, GLint format) {
  static unsigned char pixels[kTexels + 5 * 6]; // faces begin 5 bytes after each other
  const bool blocks = s.random.chance(50);
  for (int i = 0; i < kTexels; ++i)
    pixels[i] = static_cast<unsigned char>(blocks && i % 3 ? pixels[i - 1] : s.random.bits() >> 32);
  const GLsizei size = 1 << s.random.integer(0, 5);
  const bool depth = format == GL_DEPTH_COMPONENT24;
  const GLenum client = depth ? GL_DEPTH_COMPONENT : GL_RGBA,
               type = depth ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE;
  switch (target) {
  case GL_TEXTURE_1D: s.gl.TexImage1D(target, 0, format, size, 0, client, type, pixels); break;
  case GL_TEXTURE_3D: {
    const GLsizei side = size < 8 ? size : 8;
    s.gl.TexImage3D(target, 0, format, side, side, side, 0, client, type, pixels);
    break;
  }
  case GL_TEXTURE_CUBE_MAP:
    for (GLenum face = 0; face < 6; ++face)
      s.gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, format, size, size, 0, client, type,
                      pixels + 5 * face);
    break;
  default: s.gl.TexImage2D(target, 0, format, size, size, 0, client, type, pixels); break;
  }
}

struct Filters {
  GLint minify, magnify;
  bool mixed; // one is linear and one is not
};

Filters random_filters(Stage& s, bool mipmaps) {
  const GLint magnify = s.random.pick({GL_NEAREST, GL_LINEAR});
  if (!mipmaps) return {magnify, magnify, false}; // how large a rectangle is drawn: reference/DEVIATIONS.md
  const GLint minify =
      s.random.pick({GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
                     GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR});
  const bool linear =
      minify == GL_LINEAR || minify == GL_LINEAR_MIPMAP_NEAREST || minify == GL_LINEAR_MIPMAP_LINEAR;
  return {minify, magnify, linear != (magnify == GL_LINEAR)};
}

/// Sets parameters through `set(name, value)` and `set_vector(name, values)`.
template <class Set, class SetVector>
void random_parameters(Stage& s, GLenum target, bool compares, Set set, SetVector set_vector) {
  const bool rectangle = target == GL_TEXTURE_RECTANGLE;
  const Filters filters = random_filters(s, !rectangle);
  for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    GLint wrap =
        s.random.pick({GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT});
    if (wrap == GL_CLAMP && filters.mixed) wrap = GL_REPEAT; // reference/DEVIATIONS.md
    if (rectangle && (wrap == GL_REPEAT || wrap == GL_MIRRORED_REPEAT)) wrap = GL_CLAMP_TO_EDGE;
    set(axis, float(wrap));
  }
  set(GL_TEXTURE_MIN_FILTER, float(filters.minify));
  set(GL_TEXTURE_MAG_FILTER, float(filters.magnify));
  const Float4 border = s.random.color();
  set_vector(GL_TEXTURE_BORDER_COLOR, border.data());
  if (!rectangle && s.random.chance(20)) set(GL_TEXTURE_MIN_LOD, s.random.real(-1, 3));
  if (!rectangle && s.random.chance(20)) set(GL_TEXTURE_MAX_LOD, s.random.real(0, 4));
  if (!rectangle && s.random.chance(20)) set(GL_TEXTURE_LOD_BIAS, s.random.real(-2, 2));
  if (compares) {
    set(GL_TEXTURE_COMPARE_MODE, float(s.random.pick({GL_NONE, GL_COMPARE_R_TO_TEXTURE})));
    set(GL_TEXTURE_COMPARE_FUNC, float(random_compare(s)));
  }
}

void random_sampler(Stage& s, GLuint sampler, GLenum target, bool compares) {
  random_parameters(
      s, target, compares, [&](GLenum name, float value) { s.gl.SamplerParameterf(sampler, name, value); },
      [&](GLenum name, const float* values) { s.gl.SamplerParameterfv(sampler, name, values); });
}

/// Coordinates of the active unit from positions.
void generate_coordinates(const Gl& gl) {
  const GLfloat planes[3][4] = {{2, 0, 0.5f, 0}, {0, 3, 0, 0.25f}, {0.5f, 0, 1, 0.3f}};
  for (GLenum i = 0; i < 3; ++i) {
    gl.TexGeni(GL_S + i, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    gl.TexGenfv(GL_S + i, GL_OBJECT_PLANE, planes[i]);
    gl.Enable(GL_TEXTURE_GEN_S + i);
  }
}

void draw_samplers(Stage& s) {
  const Gl& gl = s.gl;
  random_canvas(s);
  GLuint samplers[2] = {};
  gl.GenSamplers(2, samplers);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_depth(s, 30);
    const int units = s.random.chance(40) ? 2 : 1;
    GLenum targets[2] = {};
    for (int unit = 0; unit < units; ++unit) {
      const GLenum target = targets[unit] =
          s.random.pick<GLenum>({GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_3D,
                                 GL_TEXTURE_CUBE_MAP, GL_TEXTURE_RECTANGLE});
      const bool compares = target == GL_TEXTURE_2D && s.random.chance(25);
      gl.ActiveTexture(GL_TEXTURE0 + GLenum(unit));
      GLuint texture = 0;
      gl.GenTextures(1, &texture);
      gl.BindTexture(target, texture);
      random_parameters(
          s, target, compares, [&](GLenum name, float value) { gl.TexParameterf(target, name, value); },
          [&](GLenum name, const float* values) { gl.TexParameterfv(target, name, values); });
      if (target != GL_TEXTURE_RECTANGLE && !compares &&
          s.random.chance(80)) // else some filters find no levels
        gl.TexParameteri(target, GL_GENERATE_MIPMAP, 1);
      random_image(s, target,
                   compares ? GL_DEPTH_COMPONENT24
                            : s.random.pick({GL_RGBA8, GL_RGB8, GL_LUMINANCE8, GL_ALPHA8, GL_RGBA16}));
      gl.Enable(target);
      if (unit == 1) generate_coordinates(gl);
      random_sampler(s, samplers[unit], target, compares);
      if (s.random.chance(85)) gl.BindSampler(GLuint(unit), samplers[unit]);
      if (s.random.chance(20)) random_sampler(s, samplers[unit], target, compares);
    }
    if (units == 2 && targets[0] == targets[1] && s.random.chance(40)) gl.BindSampler(1, samplers[0]);
    PrimitiveOptions options;
    options.mode = random_filled_mode(s);
    options.texture_coordinates = s.random.integer(2, 4);
    options.texture_scale = s.random.pick({0.6f, 1.0f, 2.0f, 8.0f});
    options.spread = s.random.chance(65) ? Spread::View : Spread::Any;
    options.primitives = s.random.integer(2, 8);
    random_primitive(s, options);
    if (s.random.chance(30)) {
      gl.BindSampler(0, 0);
      random_primitive(s, options);
    }
    if (s.random.chance(20)) {
      gl.DeleteSamplers(1, &samplers[0]);
      random_primitive(s, options);
      gl.GenSamplers(1, &samplers[0]);
    }
    for (int unit = 0; unit < units; ++unit) {
      gl.BindSampler(GLuint(unit), 0);
      gl.ActiveTexture(GL_TEXTURE0 + GLenum(unit));
      gl.Disable(targets[unit]);
    }
    gl.ActiveTexture(GL_TEXTURE0);
  }
}

SceneRegistration sampler_scenes{{"samplers", draw_samplers, true}};

} // namespace
} // namespace softgl::test
