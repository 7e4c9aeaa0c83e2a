// Framebuffer objects: all kinds of attachments drawn to with all that fragments go through, and then used:
// as textures in the window's picture, read back, copied. What is attached changes between the draws.
#include <algorithm>
#include <cstring>

#include "conformance/families/common.h"

namespace softgl::test {
namespace {

/// One framebuffer object and what is attached to it.
struct Target {
  GLuint framebuffer = 0;
  int width = 1, height = 1;
  GLenum texture_target = 0; // of the color attachment; 0: a renderbuffer
  GLuint texture = 0;
  int levels = 1;
  bool depth = false, stencil = false;
  bool blue_first = false; // texels of GL_BGRA
};

struct ColorFormat {
  GLint internal;
  GLenum format, type;
};

ColorFormat random_color_format(Random& r) {
  return r.pick<ColorFormat>({{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
                              {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
                              {GL_RGBA, GL_BGRA, GL_UNSIGNED_BYTE},
                              {GL_RGB8, GL_RGBA, GL_UNSIGNED_BYTE},
                              {GL_RGB, GL_RGB, GL_UNSIGNED_BYTE},
                              {GL_RGB, GL_RGB, GL_UNSIGNED_SHORT_5_6_5},
                              {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT},
                              {GL_RGB16, GL_RGBA, GL_UNSIGNED_SHORT}});
}

/// An image of the bound texture, with texels or without.
void specify(Stage& s, GLenum face, int level, const ColorFormat& f, int width, int height, int depth) {
  const Gl& gl = s.gl;
  std::vector<uint8_t> texels;
  if (s.random.chance(50)) {
    texels.resize(size_t(width) * size_t(height) * size_t(depth) * 8 + 64);
    for (uint8_t& t : texels) t = uint8_t(s.random.bits() >> 24);
  }
  const void* p = texels.empty() ? nullptr : texels.data();
  if (face == GL_TEXTURE_1D)
    gl.TexImage1D(face, level, f.internal, width, 0, f.format, f.type, p);
  else if (face == GL_TEXTURE_3D)
    gl.TexImage3D(face, level, f.internal, width, height, depth, 0, f.format, f.type, p);
  else
    gl.TexImage2D(face, level, f.internal, width, height, 0, f.format, f.type, p);
}

void attach_color_texture(Stage& s, Target& t, const ColorFormat& f) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  t.texture_target = r.pick({GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE,
                             GL_TEXTURE_CUBE_MAP, GL_TEXTURE_3D, GL_TEXTURE_1D});
  if (t.texture_target == GL_TEXTURE_1D) t.height = 1;
  if (t.texture_target == GL_TEXTURE_CUBE_MAP) t.height = t.width;
  gl.GenTextures(1, &t.texture);
  gl.BindTexture(t.texture_target, t.texture);
  const GLint minified = r.pick({GL_NEAREST, GL_LINEAR}), magnified = r.pick({GL_NEAREST, GL_LINEAR});
  // OSMesa minifies rectangles of two filters nearly always (reference/DEVIATIONS.md).
  const bool two = t.texture_target != GL_TEXTURE_RECTANGLE;
  gl.TexParameteri(t.texture_target, GL_TEXTURE_MIN_FILTER, minified);
  gl.TexParameteri(t.texture_target, GL_TEXTURE_MAG_FILTER, two ? magnified : minified);
  for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(t.texture_target, axis, GL_CLAMP_TO_EDGE);
  const bool flat = t.texture_target == GL_TEXTURE_RECTANGLE;
  const int level = !flat && r.chance(20) ? r.integer(1, 2) : 0;
  const int scale = 1 << level, depth = t.texture_target == GL_TEXTURE_3D ? r.integer(1, 4) : 1;
  if (t.texture_target == GL_TEXTURE_CUBE_MAP) {
    for (GLenum face = 0; face < 6; ++face)
      // OSMesa attaches levels of complete cube maps only (reference/DEVIATIONS.md).
      for (int l = 0; l <= level || (level > 0 && t.width * scale >> l > 0); ++l)
        specify(s, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, l, f, t.width * scale >> l, t.height * scale >> l,
                1);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                            GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + r.integer(0, 5)), t.texture, level);
    return;
  }
  const bool line = t.texture_target == GL_TEXTURE_1D;
  for (int l = 0; l <= level; ++l)
    specify(s, t.texture_target, l, f, t.width * scale >> l, line ? 1 : t.height * scale >> l,
            std::max(1, depth * scale >> l));
  if (t.texture_target == GL_TEXTURE_3D && r.chance(50))
    gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, t.texture, level,
                               r.integer(0, depth - 1));
  else if (t.texture_target == GL_TEXTURE_3D)
    gl.FramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, t.texture, level,
                            r.integer(0, depth - 1));
  else if (line)
    gl.FramebufferTexture1D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_1D, t.texture, level);
  else
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, t.texture_target, t.texture, level);
  gl.TexParameteri(t.texture_target, GL_TEXTURE_BASE_LEVEL, level);
  gl.TexParameteri(t.texture_target, GL_TEXTURE_MAX_LEVEL, level);
}

void attach_color(Stage& s, Target& t) {
  const Gl& gl = s.gl;
  const ColorFormat f = random_color_format(s.random);
  t.blue_first = f.format == GL_BGRA;
  if (s.random.chance(60)) return attach_color_texture(s, t, f);
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  gl.RenderbufferStorage(GL_RENDERBUFFER,
                         f.type == GL_UNSIGNED_SHORT_5_6_5 ? GLenum(GL_RGB565) : GLenum(f.internal), t.width,
                         t.height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, name);
}

void attach_depth(Stage& s, Target& t) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  // OSMesa does not clip what it draws to blue, green, red and alpha without depths
  // (reference/DEVIATIONS.md).
  if (r.chance(15) && !t.blue_first) return;
  t.depth = true;
  // Planes of other sizes: the picture is as large as the smaller one.
  const int width = t.width + (r.chance(15) ? r.integer(0, 80) : 0),
            height = t.height + (r.chance(15) ? r.integer(0, 80) : 0);
  GLuint name = 0;
  if (r.chance(30)) {
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    if (r.chance(40)) {
      const bool floats = r.chance(40), from_floats = r.chance(50);
      std::vector<uint32_t> words(size_t(width) * size_t(height) * 2);
      for (size_t i = 0; i < words.size(); ++i) {
        words[i] = uint32_t(r.bits());
        const float depth = r.real(-0.2f, 1.2f);
        if (from_floats && i % 2 == 0) std::memcpy(&words[i], &depth, 4);
      }
      t.stencil = true;
      gl.TexImage2D(GL_TEXTURE_2D, 0, floats ? GL_DEPTH32F_STENCIL8 : GL_DEPTH24_STENCIL8, width, height, 0,
                    GL_DEPTH_STENCIL, from_floats ? GL_FLOAT_32_UNSIGNED_INT_24_8_REV : GL_UNSIGNED_INT_24_8,
                    words.data());
      gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, name, 0);
      return;
    }
    gl.TexImage2D(GL_TEXTURE_2D, 0,
                  r.pick({GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F}), width, height,
                  0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, name, 0);
    return;
  }
  gl.GenRenderbuffers(1, &name);
  gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  t.stencil = r.chance(50);
  const GLenum format =
      t.stencil
          ? r.pick({GL_DEPTH24_STENCIL8, GL_DEPTH24_STENCIL8, GL_DEPTH32F_STENCIL8})
          : r.pick({GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT32F});
  gl.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, t.stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                             GL_RENDERBUFFER, name);
}

Target make_target(Stage& s) {
  const Gl& gl = s.gl;
  Target t;
  t.width = s.random.integer(1, s.random.chance(20) ? 150 : 70);
  t.height = s.random.integer(1, s.random.chance(20) ? 150 : 70);
  gl.GenFramebuffers(1, &t.framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
  attach_color(s, t);
  attach_depth(s, t);
  return t;
}

void random_stencil(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.Enable(GL_STENCIL_TEST);
  const auto mask = GLuint(r.pick({255, 15, 240}));
  const GLint reference = r.integer(0, 255);
  gl.StencilFunc(random_compare(s), reference, mask);
  const auto operation = [&] {
    return GLenum(r.pick({GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT}));
  };
  const GLenum fail = operation(), zfail = operation(), zpass = operation();
  gl.StencilOp(fail, zfail, zpass);
  gl.StencilMask(GLuint(r.pick({255, 255, 15})));
}

/// Images drawn and bitmaps, at whole positions.
void draw_rectangles(Stage& s, const Target& t) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  const GLint at_y = r.integer(0, t.height - 1), at_x = r.integer(0, t.width - 1);
  gl.WindowPos2i(at_x, at_y);
  std::vector<uint8_t> pixels(40 * 40 * 4);
  for (uint8_t& p : pixels) p = uint8_t(r.bits() >> 24);
  const int w = r.integer(1, 20), h = r.integer(1, 20);
  switch (r.integer(0, 4)) {
  case 0:
    gl.Bitmap(w, h, 0, 0, 3, 2, pixels.data());
    gl.Flush(); // OSMesa draws waiting bitmaps with later state (DEVIATIONS.md)
    break;
  case 1: {
    const float zoom_y = r.pick({1.0f, -1.0f, 3.0f});
    gl.PixelZoom(r.pick({1.0f, -1.0f, 2.0f}), zoom_y);
    gl.DrawPixels(w, h, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    gl.PixelZoom(1, 1);
    break;
  }
  case 2: { // under the depth test, which has to be on
    std::vector<float> depths(20 * 20);
    for (float& d : depths) d = r.real(-0.2f, 1.2f);
    gl.Enable(GL_DEPTH_TEST);
    gl.DrawPixels(w, h, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    break;
  }
  case 3: {
    std::vector<uint32_t> words(20 * 20 * 2);
    for (size_t i = 0; i < words.size(); ++i) {
      const float d = r.real(0, 1);
      words[i] = uint32_t(r.bits());
      if (i % 2 == 0) std::memcpy(&words[i], &d, 4);
    }
    gl.Enable(GL_DEPTH_TEST);
    if (t.stencil) gl.DrawPixels(w, h, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, words.data());
    break;
  }
  default: {
    const int x = r.integer(0, t.width / 2), y = r.integer(0, t.height / 2);
    gl.CopyPixels(x, y, std::min(w, t.width - x), std::min(h, t.height - y), GL_COLOR);
  }
  }
}

/// Lines and points that are wide, stippled, sprites.
void random_lines_and_points(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.LineWidth(r.pick({1.0f, 1.0f, 2.0f, 5.0f}));
  gl.PointSize(r.pick({1.0f, 2.0f, 3.0f, 8.0f}));
  if (r.chance(20)) {
    gl.Enable(GL_LINE_STIPPLE);
    const auto pattern = GLushort(r.bits());
    gl.LineStipple(r.integer(1, 3), pattern);
  }
  PrimitiveOptions options;
  options.mode = GLenum(r.pick({GL_LINES, GL_LINE_STRIP, GL_POINTS}));
  options.spread = r.pick({Spread::Any, Spread::Grid, Spread::View});
  random_primitive(s, options);
  gl.Disable(GL_LINE_STIPPLE);
}

void draw_into(Stage& s, const Target& t) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.BindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
  gl.Viewport(0, 0, t.width, t.height);
  if (r.chance(15)) {
    const int height = r.integer(1, 2 * t.height), width = r.integer(1, 2 * t.width);
    const int y = r.integer(-10, 20), x = r.integer(-10, 20);
    gl.Viewport(x, y, width, height);
  }
  if (r.chance(70)) {
    const Float4 c = r.color();
    gl.ClearColor(c[0], c[1], c[2], c[3]);
    gl.ClearDepth(r.chance(50) ? 1.0 : double(r.real(0, 1)));
    gl.ClearStencil(r.integer(0, 255));
    random_scissor(s, 20);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  }
  for (int batch = r.integer(1, 3); batch > 0; --batch) {
    random_projection(s);
    random_modelview(s);
    random_culling(s);
    random_depth(s, 60);
    random_scissor(s, 20);
    gl.FrontFace(r.pick({GL_CW, GL_CCW}));
    if (r.chance(30)) random_blending(s);
    if (r.chance(10)) random_alpha_test(s);
    if (r.chance(10)) random_fog(s);
    if (r.chance(30)) random_stencil(s);
    if (r.chance(20)) {
      const float factor = r.real(-2, 2);
      gl.PolygonOffset(factor, r.real(-1000, 1000));
      gl.Enable(GL_POLYGON_OFFSET_FILL);
    }
    if (r.chance(15)) {
      GLubyte pattern[128];
      for (GLubyte& b : pattern) b = GLubyte(r.bits() >> 20);
      gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
      gl.PolygonStipple(pattern);
      gl.Enable(GL_POLYGON_STIPPLE);
    }
    gl.ShadeModel(r.chance(60) ? GL_SMOOTH : GL_FLAT);
    // Lines and points among stippled triangles are stippled by OSMesa, too: not here.
    if (r.chance(12)) {
      gl.Disable(GL_POLYGON_STIPPLE);
      // Where faces have two modes OSMesa lets the first one decide about the offset
      // (reference/DEVIATIONS.md).
      gl.Disable(GL_POLYGON_OFFSET_FILL);
      gl.PolygonMode(GL_FRONT, r.pick({GL_LINE, GL_POINT}));
    }
    PrimitiveOptions options;
    options.mode = random_filled_mode(s);
    options.spread =
        r.pick({Spread::Any, Spread::Any, Spread::Grid, Spread::Tiny, Spread::View, Spread::Huge});
    random_primitive(s, options);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    if (r.chance(40)) random_lines_and_points(s);
    for (GLenum what : {GL_FOG, GL_ALPHA_TEST, GL_BLEND, GL_COLOR_LOGIC_OP, GL_STENCIL_TEST,
                        GL_POLYGON_STIPPLE, GL_POLYGON_OFFSET_FILL})
      gl.Disable(what);
    gl.ColorMask(1, 1, 1, 1);
    gl.StencilMask(255);
    if (r.chance(25)) draw_rectangles(s, t);
  }
  for (GLenum what : {GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_CULL_FACE}) gl.Disable(what);
  gl.DepthMask(1);
  gl.DepthRange(0, 1);
}

/// Reads a part back and shows it in the window.
void show_pixels(Stage& s, const Target& t) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.BindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
  const int width = std::min(t.width, 70), height = std::min(t.height, 70);
  std::vector<uint8_t> pixels(size_t(width) * size_t(height) * 8);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const bool depth = t.depth && r.chance(40), stencil = t.stencil && !depth && r.chance(40);
  const bool both = depth && t.stencil && r.chance(50);
  const GLenum format = both      ? GL_DEPTH_STENCIL
                        : depth   ? GL_DEPTH_COMPONENT
                        : stencil ? GL_STENCIL_INDEX
                                  : GL_RGBA;
  const int y = r.integer(0, 5), x = r.integer(0, 5);
  const bool floats = r.chance(40);
  gl.ReadPixels(x, y, width, height, format,
                both    ? floats ? GL_FLOAT_32_UNSIGNED_INT_24_8_REV : GL_UNSIGNED_INT_24_8
                : depth ? floats ? GL_FLOAT : GL_UNSIGNED_INT
                        : GL_UNSIGNED_BYTE,
                pixels.data());
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  const int to_y = r.integer(0, s.height - 1), to_x = r.integer(0, s.width - 1);
  gl.WindowPos2i(to_x, to_y);
  if (stencil)
    gl.DrawPixels(width, height, GL_LUMINANCE, GL_UNSIGNED_BYTE, pixels.data());
  else
    gl.DrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

/// Draws a rectangle with the texture in the window, or in another target.
void show_texture(Stage& s, const Target& t) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.BindTexture(t.texture_target, t.texture);
  if (t.texture_target != GL_TEXTURE_RECTANGLE && t.texture_target != GL_TEXTURE_3D && r.chance(20)) {
    gl.TexParameteri(t.texture_target, GL_TEXTURE_MAX_LEVEL, 1000);
    gl.GenerateMipmap(t.texture_target);
    gl.TexParameteri(t.texture_target, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  }
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, r.pick({GL_MODULATE, GL_REPLACE}));
  gl.Enable(t.texture_target);
  const float x = r.real(-1, 0), y = r.real(-1, 0), w = r.real(0.4f, 1.2f), h = r.real(0.4f, 1.2f);
  const float sx = t.texture_target == GL_TEXTURE_RECTANGLE ? float(t.width) : 1.0f,
              sy = t.texture_target == GL_TEXTURE_RECTANGLE ? float(t.height) : 1.0f;
  gl.Begin(GL_TRIANGLE_FAN);
  for (int i = 0; i < 4; ++i) {
    const float right = i == 1 || i == 2 ? 1.0f : 0.0f, top = i >= 2 ? 1.0f : 0.0f;
    const Float4 color = r.color();
    gl.Color4fv(color.data());
    if (t.texture_target == GL_TEXTURE_CUBE_MAP)
      gl.TexCoord3f(right * 2 - 1, top * 2 - 1, r.real(-2, 2));
    else
      gl.TexCoord3f(right * sx, top * sy, r.real(0, 1));
    gl.Vertex2f(x + right * w, y + top * h);
  }
  gl.End();
  gl.Disable(t.texture_target);
}

void use(Stage& s, const Target& t) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  if (t.texture && r.chance(70)) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.Viewport(0, 0, s.width, s.height);
    show_texture(s, t);
  } else if (r.chance(40)) { // a texture copied from it
    gl.BindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
    Target copy;
    copy.texture_target = GL_TEXTURE_2D;
    gl.GenTextures(1, &copy.texture);
    gl.BindTexture(GL_TEXTURE_2D, copy.texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const GLenum depth = r.pick({GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F});
    gl.CopyTexImage2D(GL_TEXTURE_2D, 0, t.depth && r.chance(40) ? depth : r.pick({GL_RGBA8, GL_RGB8}), 0, 0,
                      t.width, t.height, 0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.Viewport(0, 0, s.width, s.height);
    show_texture(s, copy);
  } else {
    show_pixels(s, t);
  }
}

/// Copies a part of one target to another, or to the window.
void blit(Stage& s, const Target& from, const Target& to) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer);
  GLbitfield mask = GL_COLOR_BUFFER_BIT;
  GLint bits[2] = {};
  gl.GetIntegerv(GL_DEPTH_BITS, &bits[0]);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, from.framebuffer);
  gl.GetIntegerv(GL_DEPTH_BITS, &bits[1]);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer);
  if (bits[0] == bits[1] && from.stencil == to.stencil && r.chance(50)) mask |= GL_DEPTH_BUFFER_BIT;
  if (bits[0] == bits[1] && from.stencil && to.stencil && r.chance(50)) mask |= GL_STENCIL_BUFFER_BIT;
  const bool cut = r.chance(40);
  if (cut) random_scissor(s, 100);
  const int w = r.integer(1, from.width), h = r.integer(1, from.height);
  // Where both rectangles lie partly outside, OSMesa clips wrongly (reference/DEVIATIONS.md).
  int x0 = r.integer(0, from.width - w), y0 = r.integer(0, from.height - h), x1 = x0 + w, y1 = y0 + h;
  int u0 = r.integer(-10, to.width), v0 = r.integer(-10, to.height), u1 = u0 + w, v1 = v0 + h;
  // Depths that are turned or cut, or go to the window, which lies the other way up, go through floats in
  // OSMesa, where some lose their last bit.
  const bool turned = r.chance(30);
  if (turned) std::swap(x0, x1);
  if (turned && r.chance(50)) std::swap(v0, v1);
  if (turned || cut || !from.framebuffer || !to.framebuffer) mask &= ~GLbitfield(GL_DEPTH_BUFFER_BIT);
  gl.BlitFramebuffer(x0, y0, x1, y1, u0, v0, u1, v1, mask,
                     mask == GL_COLOR_BUFFER_BIT && r.chance(30) ? GL_LINEAR : GL_NEAREST);
  gl.Disable(GL_SCISSOR_TEST);
}

/// Changes the texels of a texture that is or was attached.
void change_texels(Stage& s, const Target& t) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  if (t.texture_target != GL_TEXTURE_2D) return;
  gl.BindTexture(GL_TEXTURE_2D, t.texture);
  GLint level = 0;
  gl.GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, &level);
  std::vector<uint8_t> pixels(size_t(t.width) * size_t(t.height) * 4);
  for (uint8_t& p : pixels) p = uint8_t(r.bits() >> 24);
  const int w = r.integer(1, t.width), h = r.integer(1, t.height);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexSubImage2D(GL_TEXTURE_2D, level, t.width - w, t.height - h, w, h, GL_RGBA, GL_UNSIGNED_BYTE,
                   pixels.data());
}

void draw_framebuffers(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  random_canvas(s);
  std::vector<Target> targets;
  for (int n = r.integer(1, 3); n > 0; --n) targets.push_back(make_target(s));
  Target window;
  window.width = s.width, window.height = s.height;
  window.depth = window.stencil = true;
  for (int round = r.integer(1, 4); round > 0; --round) {
    const Target& t = targets[size_t(r.integer(0, int(targets.size()) - 1))];
    draw_into(s, t);
    if (r.chance(25)) {
      const Target& from = targets[size_t(r.integer(0, int(targets.size()) - 1))];
      if (from.texture && from.texture != t.texture) show_texture(s, from);
    }
    if (r.chance(15)) change_texels(s, t);
    if (r.chance(35)) {
      const Target& other = targets[size_t(r.integer(0, int(targets.size()) - 1))];
      if (other.framebuffer != t.framebuffer) blit(s, t, r.chance(50) ? other : window);
    }
    if (r.chance(60)) use(s, t);
  }
  for (const Target& t : targets) use(s, t);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

SceneRegistration framebuffers{{"framebuffers", draw_framebuffers, true}};

} // namespace
} // namespace softgl::test
