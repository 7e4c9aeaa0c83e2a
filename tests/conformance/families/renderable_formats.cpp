// Images of every format that can be drawn to, with all that becomes of a color on its way into them:
// blending, logic operations, masks, clamping. Then they are read in formats of all kinds, copied, blitted to
// another format, sampled.
#include <algorithm>
#include <cstring>

#include "conformance/families/common.h"

namespace softgl::test {
namespace {

struct ImageFormat {
  GLint internal;
  GLenum base;
  bool has_sign; // and no floats
};

constexpr std::array<ImageFormat, 66> kFormats = {{
    {GL_RGBA8, GL_RGBA, false},
    {GL_RGB8, GL_RGB, false},
    {GL_RGBA2, GL_RGBA, false},
    {GL_RGBA4, GL_RGBA, false},
    {GL_RGB5_A1, GL_RGBA, false},
    {GL_RGB10_A2, GL_RGBA, false},
    {GL_RGBA16, GL_RGBA, false},
    {GL_R3_G3_B2, GL_RGB, false},
    {GL_RGB4, GL_RGB, false},
    {GL_RGB5, GL_RGB, false},
    {GL_RGB565, GL_RGB, false},
    {GL_RGB10, GL_RGB, false},
    {GL_RGB16, GL_RGB, false},
    {GL_R8, GL_RED, false},
    {GL_R16, GL_RED, false},
    {GL_RG8, GL_RG, false},
    {GL_RG16, GL_RG, false},
    {GL_ALPHA8, GL_ALPHA, false},
    {GL_ALPHA16, GL_ALPHA, false},
    {GL_LUMINANCE8, GL_LUMINANCE, false},
    {GL_LUMINANCE16, GL_LUMINANCE, false},
    {GL_LUMINANCE4_ALPHA4, GL_LUMINANCE_ALPHA, false},
    {GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, false},
    {GL_LUMINANCE16_ALPHA16, GL_LUMINANCE_ALPHA, false},
    {GL_INTENSITY8, GL_INTENSITY, false},
    {GL_INTENSITY16, GL_INTENSITY, false},
    {GL_SRGB8, GL_RGB, false},
    {GL_SRGB8_ALPHA8, GL_RGBA, false},
    {GL_R16F, GL_RED, false},
    {GL_RG16F, GL_RG, false},
    {GL_RGB16F, GL_RGB, false},
    {GL_RGBA16F, GL_RGBA, false},
    {GL_R32F, GL_RED, false},
    {GL_RG32F, GL_RG, false},
    {GL_RGB32F, GL_RGB, false},
    {GL_RGBA32F, GL_RGBA, false},
    {GL_ALPHA16F_ARB, GL_ALPHA, false},
    {GL_ALPHA32F_ARB, GL_ALPHA, false},
    {GL_LUMINANCE16F_ARB, GL_LUMINANCE, false},
    {GL_LUMINANCE32F_ARB, GL_LUMINANCE, false},
    {GL_LUMINANCE_ALPHA16F_ARB, GL_LUMINANCE_ALPHA, false},
    {GL_LUMINANCE_ALPHA32F_ARB, GL_LUMINANCE_ALPHA, false},
    {GL_INTENSITY16F_ARB, GL_INTENSITY, false},
    {GL_INTENSITY32F_ARB, GL_INTENSITY, false},
    {GL_R11F_G11F_B10F, GL_RGB, false},
    {GL_R8_SNORM, GL_RED, true},
    {GL_R16_SNORM, GL_RED, true},
    {GL_RG8_SNORM, GL_RG, true},
    {GL_RG16_SNORM, GL_RG, true},
    {GL_RGB8_SNORM, GL_RGB, true},
    {GL_RGB16_SNORM, GL_RGB, true},
    {GL_RGBA8_SNORM, GL_RGBA, true},
    {GL_RGBA16_SNORM, GL_RGBA, true},
    {GL_ALPHA8_SNORM, GL_ALPHA, true},
    {GL_ALPHA16_SNORM, GL_ALPHA, true},
    {GL_LUMINANCE8_SNORM, GL_LUMINANCE, true},
    {GL_LUMINANCE16_SNORM, GL_LUMINANCE, true},
    {GL_LUMINANCE8_ALPHA8_SNORM, GL_LUMINANCE_ALPHA, true},
    {GL_LUMINANCE16_ALPHA16_SNORM, GL_LUMINANCE_ALPHA, true},
    {GL_INTENSITY8_SNORM, GL_INTENSITY, true},
    {GL_INTENSITY16_SNORM, GL_INTENSITY, true},
    {GL_RGBA, GL_RGBA, false},
    {GL_RGB, GL_RGB, false},
    {GL_LUMINANCE, GL_LUMINANCE, false},
    {GL_ALPHA, GL_ALPHA, false},
    {GL_RED, GL_RED, false},
}};

struct Target {
  GLuint framebuffer = 0, texture = 0;
  ImageFormat format{};
  int size = 32, samples = 0;
};

Target make_target(Stage& s, const ImageFormat& format, int samples) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  Target t;
  t.format = format;
  t.samples = samples;
  t.size = r.integer(8, 70);
  gl.GenFramebuffers(1, &t.framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
  GLuint name = 0;
  if (samples || r.chance(40)) {
    gl.GenRenderbuffers(1, &name);
    gl.BindRenderbuffer(GL_RENDERBUFFER, name);
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GLenum(t.format.internal), t.size, t.size);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, name);
  } else {
    gl.GenTextures(1, &t.texture);
    gl.BindTexture(GL_TEXTURE_2D, t.texture);
    const GLint filter = r.pick({GL_NEAREST, GL_LINEAR});
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    std::vector<float> texels(size_t(t.size) * size_t(t.size) * 4);
    for (float& v : texels) v = r.real(-0.5f, 1.5f);
    gl.TexImage2D(GL_TEXTURE_2D, 0, t.format.internal, t.size, t.size, 0, GL_RGBA, GL_FLOAT,
                  r.chance(50) ? texels.data() : nullptr);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, t.texture, 0);
  }
  return t;
}

/// Beyond [0, 1], sometimes much.
Float4 wide_color(Random& r) {
  Float4 c;
  const float most = r.pick({1.0f, 2.0f, 20.0f});
  for (float& v : c) v = r.chance(10) ? float(r.integer(-1, 2)) : r.real(-0.3f * most, most);
  return c;
}

void clear(Stage& s) {
  const Gl& gl = s.gl;
  const Float4 c = wide_color(s.random);
  gl.ClearColor(c[0], c[1], c[2], c[3]);
  random_scissor(s, 30);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Disable(GL_SCISSOR_TEST);
}

void random_clamping(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  for (GLenum what : {GL_CLAMP_VERTEX_COLOR, GL_CLAMP_FRAGMENT_COLOR, GL_CLAMP_READ_COLOR})
    if (r.chance(60)) gl.ClampColor(what, GLenum(r.pick({GL_TRUE, GL_FALSE, GL_FALSE, GL_FIXED_ONLY})));
}

/// OSMesa blends a lone alpha with the equation of colors, and signed alpha as if its factors were those of
/// colors (reference/DEVIATIONS.md).
void random_merging(Stage& s, const Target& t) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  if (r.chance(60)) random_blending(s);
  if (t.format.base == GL_ALPHA) gl.BlendEquation(GL_FUNC_ADD);
  if (t.format.has_sign) {
    const GLenum source =
        r.pick({GL_ONE, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_COLOR, GL_DST_COLOR, GL_ONE_MINUS_DST_ALPHA});
    gl.BlendFunc(
        source, r.pick({GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR, GL_ONE_MINUS_DST_COLOR, GL_DST_COLOR}));
  }
  if (r.chance(20)) {
    gl.Enable(GL_COLOR_LOGIC_OP);
    gl.LogicOp(GLenum(GL_CLEAR + r.integer(0, 15)));
  }
  if (r.chance(25)) {
    const bool red = r.chance(60), green = r.chance(60), blue = r.chance(60), alpha = r.chance(60);
    gl.ColorMask(red, green, blue, alpha);
  }
  if (r.chance(20)) random_alpha_test(s);
  if (r.chance(15)) random_fog(s);
}

void draw(Stage& s, const Target& t) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.BindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
  gl.Viewport(0, 0, t.size, t.size);
  random_clamping(s);
  random_merging(s, t);
  if (r.chance(50)) gl.Enable(GL_FRAMEBUFFER_SRGB);
  if (r.chance(60)) clear(s);
  for (int n = r.integer(1, 3); n > 0; --n) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 5; ++i) {
      const Float4 c = wide_color(r);
      gl.Color4fv(c.data());
      const float y = r.real(-1.2f, 1.2f), x = r.real(-1.2f, 1.2f);
      gl.Vertex2f(x, y);
    }
    gl.End();
    if (r.chance(30)) {
      std::vector<float> pixels(16 * 16 * 4);
      for (float& v : pixels) v = r.real(-0.5f, 1.5f);
      const int at_y = r.integer(0, t.size / 2), at_x = r.integer(0, t.size / 2);
      gl.WindowPos2i(at_x, at_y);
      // OSMesa makes copies of sRGB linear, and draws them so (reference/DEVIATIONS.md).
      const bool srgb = t.format.internal == GL_SRGB8 || t.format.internal == GL_SRGB8_ALPHA8;
      if (t.samples || srgb || r.chance(70))
        gl.DrawPixels(16, 16, GL_RGBA, GL_FLOAT, pixels.data());
      else {
        // OSMesa copies under no mask and does not clamp (reference/DEVIATIONS.md).
        gl.ColorMask(1, 1, 1, 1);
        gl.ClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
        gl.CopyPixels(0, 0, t.size / 2, t.size / 2, GL_COLOR);
      }
    }
    random_merging(s, t);
  }
  reset_state(s);
  gl.ColorMask(1, 1, 1, 1);
  gl.Disable(GL_COLOR_LOGIC_OP);
  if (r.chance(70)) gl.Disable(GL_FRAMEBUFFER_SRGB); // else blits convert, too
}

struct ReadFormat {
  GLenum format, type;
  int bytes;
};
/// Reads what is bound and shows the bytes themselves in the window.
void show_pixels(Stage& s, const Target& t, bool had_sign = false) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  const bool has_sign = had_sign || t.format.has_sign;
  auto f = r.pick<ReadFormat>({{GL_RGBA, GL_FLOAT, 16},
                               {GL_RGBA, GL_UNSIGNED_BYTE, 4},
                               {GL_BGRA, GL_UNSIGNED_BYTE, 4},
                               {GL_RGBA, GL_BYTE, 4},
                               {GL_RGBA, GL_UNSIGNED_SHORT, 8},
                               {GL_RGBA, GL_SHORT, 8},
                               {GL_RGBA, GL_HALF_FLOAT, 8},
                               {GL_LUMINANCE, GL_UNSIGNED_BYTE, 1},
                               {GL_RGB, GL_FLOAT, 12},
                               {GL_ALPHA, GL_FLOAT, 4},
                               {GL_RED, GL_FLOAT, 4},
                               {GL_LUMINANCE, GL_FLOAT, 4},
                               {GL_LUMINANCE_ALPHA, GL_UNSIGNED_SHORT, 4}});
  // A sum does not show which component lay below -1.
  if (has_sign && (f.format == GL_LUMINANCE || f.format == GL_LUMINANCE_ALPHA))
    f = {GL_RED, f.type, f.format == GL_LUMINANCE ? f.bytes : 2};
  const int n = std::min(t.size, 24);
  std::vector<uint8_t> pixels(size_t(n) * size_t(n) * 16);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const int y = r.integer(0, t.size - n), x = r.integer(0, t.size - n);
  gl.ReadPixels(x, y, n, n, f.format, f.type, pixels.data());
  if (has_sign) clamp_at_minus_one(pixels, f.type);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  const int to_y = r.integer(0, std::max(0, s.height - n)), to_x = r.integer(0, std::max(0, s.width - n));
  gl.WindowPos2i(to_x, to_y);
  gl.DrawPixels(n * f.bytes / 4, n, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

/// Mipmaps of sRGB are averaged in another way (reference/DEVIATIONS.md).
void show_texture(Stage& s, GLuint texture, GLint internal_format) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Viewport(0, 0, s.width, s.height);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  const bool srgb = internal_format == GL_SRGB8 || internal_format == GL_SRGB8_ALPHA8;
  if (r.chance(20) && !srgb) {
    gl.GenerateMipmap(GL_TEXTURE_2D);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  }
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.Color4f(0.2f, 0.4f, 0.6f, 0.8f);
  gl.Enable(GL_TEXTURE_2D);
  const float x = r.real(-1, 0), y = r.real(-1, 0), w = r.real(0.2f, 1.2f), h = r.real(0.2f, 1.2f);
  gl.Begin(GL_TRIANGLE_FAN);
  for (int i = 0; i < 4; ++i) {
    const float right = i == 1 || i == 2 ? 1.0f : 0.0f, top = i >= 2 ? 1.0f : 0.0f;
    gl.TexCoord2f(right, top);
    gl.Vertex2f(x + right * w, y + top * h);
  }
  gl.End();
  gl.Disable(GL_TEXTURE_2D);
}

void copy_to_texture(Stage& s, const Target& t) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const GLint to = r.chance(40) ? t.format.internal : r.pick(kFormats).internal;
  gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GLenum(to), 0, 0, t.size, t.size, 0);
  show_texture(s, texture, to);
}

void draw_renderable_formats(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  random_canvas(s);
  const ImageFormat format = r.pick(kFormats);
  const int samples = r.chance(15) ? 4 : 0;
  const Target t = make_target(s, format, samples);
  if (samples) { // are resolved
    draw(s, t);
    const Target resolved = make_target(s, format, 0);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, t.framebuffer);
    const int w = std::min(t.size, resolved.size);
    gl.BlitFramebuffer(0, 0, w, w, 0, 0, w, w, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved.framebuffer);
    return show_pixels(s, resolved);
  }
  for (int round = r.integer(1, 3); round > 0; --round) {
    draw(s, t);
    switch (r.integer(0, 4)) {
    case 0:
      if (t.texture) {
        show_texture(s, t.texture, t.format.internal);
        break;
      }
      [[fallthrough]];
    case 1: copy_to_texture(s, t); break;
    case 2: {
      const ImageFormat other_format = r.pick(kFormats);
      const Target other = make_target(s, other_format, 0);
      gl.BindFramebuffer(GL_READ_FRAMEBUFFER, t.framebuffer);
      const int w = r.integer(1, std::min(t.size, other.size));
      // Twice as wide: no pixel's center lies between two others.
      const int to = r.chance(30) && 2 * w <= other.size ? 2 * w : w;
      const auto filter = GLenum(r.pick({GL_NEAREST, GL_NEAREST, GL_LINEAR}));
      // Weights of floats have other last bits (DEVIATIONS.md).
      const bool mixes = filter == GL_LINEAR && to != w;
      gl.BlitFramebuffer(0, 0, w, w, 0, 0, to, w, GL_COLOR_BUFFER_BIT, mixes ? GLenum(GL_NEAREST) : filter);
      gl.BindFramebuffer(GL_READ_FRAMEBUFFER, other.framebuffer);
      show_pixels(s, other, t.format.has_sign);
      break;
    }
    default: show_pixels(s, t);
    }
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
  show_pixels(s, t);
}

SceneRegistration renderable_formats{{"renderable_formats", draw_renderable_formats, true}};

} // namespace
} // namespace softgl::test
