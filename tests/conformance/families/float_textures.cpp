// Textures of floats, signed components, one and two components, and sRGB: what is stored, filtered and read
// back.
#include <algorithm>
#include <cstring>

#include "conformance/families/common.h"
#include "conformance/families/environments.h"

namespace softgl::test {

namespace {

struct Format {
  GLint internal;
  bool renders = true; // OSMesa draws mipmaps of it
};

const Format kFormats[] = {{GL_RGBA32F},
                           {GL_RGB32F},
                           {GL_ALPHA32F_ARB},
                           {GL_LUMINANCE32F_ARB},
                           {GL_LUMINANCE_ALPHA32F_ARB},
                           {GL_INTENSITY32F_ARB},
                           {GL_RGBA16F},
                           {GL_RGB16F},
                           {GL_ALPHA16F_ARB},
                           {GL_LUMINANCE16F_ARB},
                           {GL_LUMINANCE_ALPHA16F_ARB},
                           {GL_INTENSITY16F_ARB},
                           {GL_R32F},
                           {GL_RG32F},
                           {GL_R16F},
                           {GL_RG16F},
                           {GL_RED},
                           {GL_RG},
                           {GL_R8},
                           {GL_RG8},
                           {GL_R16},
                           {GL_RG16},
                           {GL_R11F_G11F_B10F},
                           {GL_RGB9_E5, false},
                           {GL_RGBA8_SNORM},
                           {GL_RGB8_SNORM},
                           {GL_R8_SNORM},
                           {GL_RG8_SNORM},
                           {GL_RGBA16_SNORM},
                           {GL_RGB16_SNORM},
                           {GL_R16_SNORM},
                           {GL_RG16_SNORM},
                           {GL_ALPHA8_SNORM},
                           {GL_LUMINANCE8_SNORM},
                           {GL_LUMINANCE8_ALPHA8_SNORM},
                           {GL_INTENSITY8_SNORM},
                           {GL_ALPHA16_SNORM},
                           {GL_LUMINANCE16_SNORM},
                           {GL_LUMINANCE16_ALPHA16_SNORM},
                           {GL_INTENSITY16_SNORM},
                           {GL_RGBA_SNORM},
                           {GL_RED_SNORM},
                           {GL_SRGB8, false},
                           {GL_SRGB8_ALPHA8, false},
                           {GL_SLUMINANCE8, false},
                           {GL_SLUMINANCE8_ALPHA8, false}};

const GLenum kTypes[] = {GL_FLOAT, GL_FLOAT,          GL_HALF_FLOAT, GL_UNSIGNED_BYTE,
                         GL_BYTE,  GL_UNSIGNED_SHORT, GL_SHORT};

/// Memory of `count` values of a type, which are not all in [0, 1].
std::vector<GLubyte> random_values(Stage& s, GLenum type, size_t count) {
  Random& r = s.random;
  std::vector<GLubyte> bytes(count * 4 + 16);
  if (type == GL_FLOAT) {
    const float scale = r.pick({1.0f, 1.0f, 2.0f, 1000.0f, 1e-4f});
    std::vector<float> values(count);
    for (float& v : values) v = r.real(-0.5f, 1.5f) * scale;
    std::memcpy(bytes.data(), values.data(), count * 4);
  } else if (type == GL_HALF_FLOAT) {
    std::vector<GLushort> values(count);
    // From -2 to 2, small ones that are not normal among them; no infinity.
    for (GLushort& v : values) {
      const uint64_t bits = r.bits() >> 20;
      v = GLushort((bits & 0x83ff) | (bits % 31 == 0 ? 0 : (9 + bits / 31 % 7) << 10));
    }
    std::memcpy(bytes.data(), values.data(), count * 2);
  } else {
    // Not the lowest numbers: reference/DEVIATIONS.md.
    for (GLubyte& b : bytes) {
      b = GLubyte(r.bits() >> 24);
      if (b == 0x80) b = 0x7f;
    }
  }
  return bytes;
}

void image(Stage& s, GLenum target, GLint internal, int level, int w, int h) {
  Random& r = s.random;
  const GLenum format = r.pick({GL_RGBA, GL_RGBA, GL_RGBA, GL_BGRA, GL_RGB, GL_RG, GL_RED, GL_LUMINANCE,
                                GL_LUMINANCE_ALPHA, GL_ALPHA}),
               type = kTypes[r.integer(0, 6)];
  std::vector<GLubyte> values = random_values(s, type, size_t(w) * size_t(h) * 4 + 64);
  if (r.chance(8) && internal != GL_RGB9_E5) { // three floats in a word
    for (GLubyte& b : values) b = GLubyte(r.bits() >> 24);
    for (size_t i = 3; i < values.size(); i += 4) values[i] &= 0x6f; // no infinity
    for (size_t i = 2; i < values.size(); i += 4) values[i] &= 0xbd;
    for (size_t i = 1; i < values.size(); i += 4) values[i] &= 0xfb;
    s.gl.TexImage2D(target, level, internal, w, h, 0, GL_RGB,
                    r.pick({GL_UNSIGNED_INT_10F_11F_11F_REV, GL_UNSIGNED_INT_5_9_9_9_REV}), values.data());
    return;
  }
  s.gl.TexImage2D(target, level, internal, w, h, 0, format, type, values.data());
}

/// Texels that are read become an image of bytes.
void show_what_is_read(Stage& s, int width, int height) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  const GLenum format =
                   r.pick({GL_RGBA, GL_RGBA, GL_BGRA, GL_RGB, GL_RG, GL_RED, GL_ALPHA, GL_LUMINANCE_ALPHA}),
               type = kTypes[r.integer(0, 6)];
  std::vector<GLubyte> pixels(size_t(width) * size_t(height) * 16 + 64);
  gl.GetTexImage(GL_TEXTURE_2D, 0, format, type, pixels.data());
  GLint component_type = 0;
  for (GLenum component : {GL_TEXTURE_RED_TYPE, GL_TEXTURE_ALPHA_TYPE, GL_TEXTURE_LUMINANCE_TYPE_ARB,
                           GL_TEXTURE_INTENSITY_TYPE_ARB})
    if (component_type != GL_SIGNED_NORMALIZED)
      gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, component, &component_type);
  if (component_type == GL_SIGNED_NORMALIZED) clamp_at_minus_one(pixels, type);
  GLint sizes[4] = {};
  gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_RED_SIZE, &sizes[0]);
  gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_ALPHA_TYPE, &sizes[1]);
  gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_LUMINANCE_TYPE_ARB, &sizes[2]);
  gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_SHARED_SIZE, &sizes[3]);
  for (size_t i = 0; i < 4; ++i) pixels[i] ^= GLubyte(sizes[i]);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

void float_texture(Stage& s, bool reads) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  const Format& format = kFormats[r.integer(0, int(std::size(kFormats)) - 1)];
  const bool odd = r.chance(40);
  const int width = odd ? r.integer(1, 37) : 1 << r.integer(0, 5);
  const int height = odd ? r.integer(1, 37) : 1 << r.integer(0, 5);
  const bool mipmaps = !reads && r.chance(50);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                   mipmaps ? r.pick({GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
                                     GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR})
                           : r.pick({GL_NEAREST, GL_LINEAR}));
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, r.pick({GL_NEAREST, GL_LINEAR}));
  for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(
        GL_TEXTURE_2D, axis,
        r.pick({GL_REPEAT, GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT}));
  Float4 border = r.color();
  if (r.chance(50))
    for (float& b : border) b = b * 3 - 1;
  gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border.data());
  const bool generate = mipmaps && format.renders && r.chance(40);
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, generate);
  if (r.chance(10)) gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, GL_SKIP_DECODE_EXT);
  const bool scaled = r.chance(10);
  if (scaled) {
    gl.PixelTransferf(GL_RED_SCALE, 1.5f);
    gl.PixelTransferf(GL_ALPHA_BIAS, -0.25f);
  }
  int w = width, h = height;
  for (int level = 0;; ++level) {
    image(s, GL_TEXTURE_2D, format.internal, level, w, h);
    if (!mipmaps || generate || (w == 1 && h == 1)) break;
    w = std::max(1, w / 2), h = std::max(1, h / 2);
  }
  gl.PixelTransferf(GL_RED_SCALE, 1);
  gl.PixelTransferf(GL_ALPHA_BIAS, 0);
  if (reads) show_what_is_read(s, width, height);
  gl.Enable(GL_TEXTURE_2D);
}

void draw_floats(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  float_texture(s, r.chance(25));
  if (r.chance(50))
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, r.pick({GL_REPLACE, GL_MODULATE}));
  else
    random_environment(s, 1, true);
  const float scale = r.pick({0.6f, 1.0f, 2.0f, 8.0f});
  gl.Begin(GL_TRIANGLES);
  for (int triangle = 0; triangle < 2; ++triangle)
    for (int i = 0; i < 3; ++i) {
      const float x = (i + triangle) % 3 == 1 ? 0.9f : -0.9f, y = (i + triangle) % 3 == 2 ? 0.9f : -0.9f;
      const float flip = triangle ? -1.0f : 1.0f;
      const Float4 color = r.color();
      gl.Color4fv(color.data());
      const float a = r.real(-scale, scale), b = r.real(-scale, scale);
      gl.TexCoord2f(a, b);
      gl.Vertex2f(x * flip, y * flip);
    }
  gl.End();
}

SceneRegistration floats{{"float_textures", draw_floats, true}};

} // namespace

} // namespace softgl::test
