// Framebuffer objects of several samples a pixel: drawn to with all that coverage has to do with, then
// resolved by glBlitFramebuffer, read back and shown in the window.
#include <vector>

#include "conformance/families/common.h"

namespace softgl::test {
namespace {

struct Target {
  GLuint framebuffer = 0;
  int width = 1, height = 1;
  GLenum color = GL_RGBA8, depth = 0; // formats; depth 0: none
  bool stencil() const { return depth == GL_DEPTH24_STENCIL8; }
};

void attach(Stage& s, GLenum attachment, GLenum format, int samples, int width, int height) {
  const Gl& gl = s.gl;
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
}

/// As `like`, with another number of samples.
Target make_target(Stage& s, const Target& like, int samples) {
  Target t = like;
  s.gl.GenFramebuffers(1, &t.framebuffer);
  s.gl.BindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
  attach(s, GL_COLOR_ATTACHMENT0, t.color, samples, t.width, t.height);
  if (t.depth)
    attach(s, t.stencil() ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, t.depth, samples, t.width,
           t.height);
  return t;
}

void random_stencil(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.Enable(GL_STENCIL_TEST);
  const auto mask = GLuint(r.pick({255, 15}));
  const GLint reference = r.integer(0, 255);
  gl.StencilFunc(random_compare(s), reference, mask);
  const auto operation = [&] {
    return GLenum(r.pick({GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT}));
  };
  const GLenum fail = operation(), zfail = operation(), zpass = operation();
  gl.StencilOp(fail, zfail, zpass);
}

/// What happens to coverage (GL 1.5, 4.1.3).
void random_coverage(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  if (r.chance(20)) gl.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  if (r.chance(15)) gl.Enable(GL_SAMPLE_ALPHA_TO_ONE);
  if (r.chance(20)) {
    gl.Enable(GL_SAMPLE_COVERAGE);
    const auto invert = GLboolean(r.chance(30));
    gl.SampleCoverage(r.real(0, 1.1f), invert);
  }
}

/// A small texture with levels, for all primitives behind it.
void random_texture(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  std::vector<uint8_t> texels(16 * 16 * 4);
  for (uint8_t& t : texels) t = uint8_t(r.bits() >> 24);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  const bool nearest = r.chance(50);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, r.pick({GL_MODULATE, GL_ADD}));
  gl.Enable(GL_TEXTURE_2D);
}

/// Flat, without depths and fog: what OSMesa interpolates lies half a pixel away. Longer than a pixel in both
/// directions, else OSMesa loses some (reference/DEVIATIONS.md).
void draw_lines(Stage& s, const Target& t) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  if (t.width < 8 || t.height < 8 || t.width > 64 || t.height > 64) return;
  gl.ShadeModel(GL_FLAT);
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_FOG);
  for (GLenum matrix : {GL_MODELVIEW, GL_PROJECTION}) {
    gl.MatrixMode(matrix);
    gl.LoadIdentity();
  }
  gl.Ortho(0, t.width, 0, t.height, -1, 1);
  gl.LineWidth(r.pick({1.0f, 1.0f, 1.5f, 2.0f, 5.0f}));
  gl.Begin(GL_LINES);
  for (int i = r.integer(1, 10); i > 0; --i) {
    const Float4 color = r.color();
    gl.Color4fv(color.data());
    const float y = r.real(1, float(t.height - 4)), x = r.real(1, float(t.width - 4));
    const float up = r.real(2, float(t.height) - 1 - y), right = r.real(2, float(t.width) - 1 - x);
    const bool falls = r.chance(50);
    gl.Vertex2f(x, falls ? y + up : y);
    gl.Vertex2f(x + right, falls ? y : y + up);
  }
  gl.End();
}

void draw_points(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.PointSize(r.pick({1.0f, 2.0f, 3.3f, 8.0f}));
  gl.Enable(GL_POINT_SPRITE);
  PrimitiveOptions options;
  options.mode = GL_POINTS;
  options.spread = r.pick({Spread::Any, Spread::Grid, Spread::View});
  random_primitive(s, options);
  gl.Disable(GL_POINT_SPRITE);
}

/// An image or a bitmap, at a whole position. OSMesa draws them without multisampling.
void draw_rectangle(Stage& s, const Target& t) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  for (GLenum what : {GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE,
                      GL_STENCIL_TEST, GL_DEPTH_TEST})
    gl.Disable(what);
  const GLint at_y = r.integer(0, t.height - 1), at_x = r.integer(0, t.width - 1);
  gl.WindowPos2i(at_x, at_y);
  std::vector<uint8_t> pixels(20 * 20 * 4);
  for (uint8_t& p : pixels) p = uint8_t(r.bits() >> 24);
  const int w = r.integer(1, 20), h = r.integer(1, 20);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (r.chance(50)) {
    gl.Bitmap(w, h, 0, 0, 3, 2, pixels.data());
    gl.Flush(); // OSMesa draws waiting bitmaps with later state (DEVIATIONS.md)
  } else {
    gl.DrawPixels(w, h, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  }
}

void draw_batch(Stage& s, const Target& t) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  random_projection(s);
  random_modelview(s);
  random_culling(s);
  // Without multisampling OSMesa tests one sample only; and samples outside of the scissor box are drawn
  // (reference/DEVIATIONS.md).
  const bool per_sample = r.chance(85);
  if (per_sample)
    random_coverage(s);
  else
    gl.Disable(GL_MULTISAMPLE);
  random_depth(s, per_sample ? 60 : 0);
  if (r.chance(30)) random_blending(s);
  if (r.chance(10)) random_alpha_test(s);
  if (r.chance(10)) random_fog(s);
  if (per_sample && r.chance(30)) random_stencil(s);
  if (r.chance(10)) {
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.PolygonOffset(r.real(-2, 2), 3);
  }
  if (r.chance(20)) random_texture(s);
  if (r.chance(10)) {
    GLubyte pattern[128];
    for (GLubyte& b : pattern) b = GLubyte(r.bits() >> 20);
    gl.PolygonStipple(pattern);
    gl.Enable(GL_POLYGON_STIPPLE);
  }
  gl.ShadeModel(r.chance(60) ? GL_SMOOTH : GL_FLAT);
  PrimitiveOptions options;
  options.mode = random_filled_mode(s);
  options.texture_coordinates = r.chance(50) ? 2 : 0;
  options.spread = r.pick({Spread::Any, Spread::Any, Spread::Grid, Spread::Tiny, Spread::View, Spread::Huge});
  random_primitive(s, options);
  gl.Disable(GL_TEXTURE_2D);
  gl.Disable(GL_POLYGON_STIPPLE);
  if (per_sample && r.chance(30)) draw_lines(s, t);
  if (r.chance(20)) draw_points(s);
  if (r.chance(10)) draw_rectangle(s, t);
  for (GLenum what :
       {GL_FOG, GL_ALPHA_TEST, GL_BLEND, GL_COLOR_LOGIC_OP, GL_STENCIL_TEST, GL_SAMPLE_ALPHA_TO_COVERAGE,
        GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE, GL_POLYGON_OFFSET_FILL, GL_DEPTH_TEST, GL_CULL_FACE})
    gl.Disable(what);
  gl.Enable(GL_MULTISAMPLE);
  gl.ColorMask(1, 1, 1, 1);
  gl.DepthMask(1);
  gl.DepthRange(0, 1);
}

void clear(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  const Float4 c = r.color();
  gl.ClearColor(c[0], c[1], c[2], c[3]);
  gl.ClearDepth(r.chance(50) ? 1.0 : double(r.real(0, 1)));
  gl.ClearStencil(r.integer(0, 255));
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

/// Reads one kind of the bound framebuffer's values, and draws them in the window at (x, y).
void show(Stage& s, const Target& t, GLenum format, int x, int y) {
  const Gl& gl = s.gl;
  std::vector<uint8_t> pixels(size_t(t.width) * size_t(t.height) * 4);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.BindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
  gl.ReadPixels(0, 0, t.width, t.height, format,
                format == GL_DEPTH_COMPONENT ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE, pixels.data());
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.WindowPos2i(x, y);
  gl.DrawPixels(t.width, t.height, format == GL_STENCIL_INDEX ? GL_LUMINANCE : GL_RGBA, GL_UNSIGNED_BYTE,
                pixels.data());
}

void draw_multisample(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  random_canvas(s);
  Target like;
  like.width = r.integer(1, s.width);
  like.height = r.integer(1, s.height);
  like.color = GLenum(r.pick({GL_RGBA8, GL_RGBA8, GL_RGBA8, GL_RGB8, GL_RGB565, GL_RGBA16}));
  like.depth = GLenum(
      r.pick({GL_DEPTH24_STENCIL8, GL_DEPTH24_STENCIL8, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT16, 0}));
  const Target resolved = make_target(s, like, 0);
  const Target t = make_target(s, like, r.integer(1, 4));
  gl.Viewport(0, 0, t.width, t.height);
  clear(s);
  for (int batch = r.integer(1, 4); batch > 0; --batch) draw_batch(s, t);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved.framebuffer);
  gl.BlitFramebuffer(0, 0, t.width, t.height, 0, 0, t.width, t.height,
                     GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
  show(s, resolved, GL_RGBA, 0, 0);
  if (r.chance(50) && t.depth == GL_DEPTH_COMPONENT16) show(s, resolved, GL_DEPTH_COMPONENT, s.width / 2, 0);
  if (t.stencil() && r.chance(50)) show(s, resolved, GL_STENCIL_INDEX, 0, s.height / 2);
}

SceneRegistration multisample{{"multisample", draw_multisample, true}};

} // namespace
} // namespace softgl::test
