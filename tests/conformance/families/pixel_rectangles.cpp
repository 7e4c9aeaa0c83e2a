// Images drawn into the window: glDrawPixels, glCopyPixels and glBitmap, with zoom and with all that
// fragments go through.
#include <cmath>

#include "conformance/families/common.h"

namespace softgl::test {

static std::vector<GLubyte> random_bytes(Stage& s, size_t count) {
  std::vector<GLubyte> v(count);
  for (GLubyte& b : v) b = GLubyte(s.random.bits());
  return v;
}

static void random_raster_position(Stage& s) {
  const Gl& gl = s.gl;
  const Float4 color = s.random.color();
  gl.Color4fv(color.data());
  const float x = s.random.real(-10, float(s.width)), y = s.random.real(-10, float(s.height)),
              z = s.random.real(-0.1f, 1.1f);
  if (s.random.chance(50))
    gl.WindowPos3f(x, y, z);
  else
    gl.WindowPos3f(std::floor(x), std::floor(y), z);
}

/// Tests and blending that the fragments of rectangles go through as all others do.
static void random_fragment_operations(Stage& s) {
  random_depth(s, 40);
  random_scissor(s, 20);
  for (GLenum what : {GL_ALPHA_TEST, GL_BLEND, GL_COLOR_LOGIC_OP, GL_STENCIL_TEST}) s.gl.Disable(what);
  s.gl.ColorMask(1, 1, 1, 1);
  if (s.random.chance(30)) random_blending(s);
  if (s.random.chance(20)) random_alpha_test(s);
  if (s.random.chance(20)) {
    s.gl.Enable(GL_STENCIL_TEST);
    const int reference = s.random.integer(0, 3);
    s.gl.StencilFunc(random_compare(s), reference, 0xff);
    // Not all GL_KEEP: then OSMesa copies whatever the test says (DEVIATIONS.md).
    const GLenum pass = s.random.pick({GL_INCR, GL_INVERT});
    s.gl.StencilOp(s.random.pick({GL_KEEP, GL_INCR, GL_REPLACE}), GL_KEEP, pass);
  }
}

// None that puts centres of pixels between two elements, where OSMesa takes either (DEVIATIONS.md).
static void random_zoom(Stage& s) {
  auto factor = [&] {
    return s.random.chance(60) ? 1.0f : s.random.pick({-1.0f, 2.0f, 3.0f, -2.0f, 0.7371f, -1.3172f, 4.8173f});
  };
  const float x = factor(), y = factor();
  s.gl.PixelZoom(x, y);
}

static void draw_bitmaps(Stage& s) {
  const Gl& gl = s.gl;
  random_canvas(s);
  for (int batch = s.random.integer(1, 4); batch > 0; batch--) {
    random_fragment_operations(s);
    random_raster_position(s);
    for (int count = s.random.integer(1, 5); count > 0; count--) {
      const int width = s.random.integer(0, 36), height = s.random.integer(0, 30);
      random_unpacking(s);
      const std::vector<GLubyte> bits = random_bytes(s, 4096);
      const float x = s.random.real(-9, 9), y = s.random.chance(50) ? 0 : s.random.real(-9, 9);
      const float move_x = s.random.chance(50) ? float(width) : s.random.real(-9, 30),
                  move_y = s.random.real(-4, 4);
      gl.Flush(); // OSMesa draws waiting bitmaps with later state, and where they overlap once
                  // (DEVIATIONS.md)
      gl.Bitmap(width, height, x, y, move_x, move_y, bits.data());
      if (s.random.chance(30)) {
        const Float4 color = s.random.color(); // of later raster positions
        gl.Color4fv(color.data());
      }
    }
  }
}

static void draw_images(Stage& s) {
  const Gl& gl = s.gl;
  random_canvas(s);
  for (int batch = s.random.integer(1, 4); batch > 0; batch--) {
    random_fragment_operations(s);
    random_raster_position(s);
    random_zoom(s);
    random_unpacking(s);
    const std::vector<GLubyte> pixels = random_bytes(s, 48 * 48 * 4);
    const int width = s.random.integer(1, 36), height = s.random.integer(1, 30);
    const GLenum format = s.random.pick({GL_RGBA, GL_RGBA, GL_RGB, GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                                         GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_BGR});
    gl.DrawPixels(width, height, format, GL_UNSIGNED_BYTE, pixels.data());
  }
}

static void random_copy(Stage& s, GLenum type) {
  const int width = std::min(s.random.integer(1, 40), s.width),
            height = std::min(s.random.integer(1, 40), s.height);
  const int x = s.random.integer(0, s.width - width), y = s.random.integer(0, s.height - height);
  s.gl.CopyPixels(x, y, width, height, type);
}

static void draw_copies(Stage& s) {
  random_canvas(s);
  backdrop(s);
  PrimitiveOptions options;
  random_projection(s);
  random_modelview(s);
  random_primitive(s, options);
  for (int batch = s.random.integer(1, 4); batch > 0; batch--) {
    random_fragment_operations(s);
    random_raster_position(s);
    random_zoom(s);
    random_copy(s, GL_COLOR);
  }
}

// Stencil values, drawn and copied. OSMesa neither shifts nor maps them, and depths lose bits on their way
// through its textures (DEVIATIONS.md).
static void draw_stencil_images(Stage& s) {
  const Gl& gl = s.gl;
  random_canvas(s);
  PrimitiveOptions options;
  random_projection(s);
  random_modelview(s);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilOp(GL_KEEP, GL_INCR, GL_INVERT);
  random_primitive(s, options);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) {
    random_fragment_operations(s);
    gl.StencilMask(s.random.chance(70) ? 0xff : s.random.integer(0, 255));
    random_raster_position(s);
    random_zoom(s);
    random_unpacking(s);
    if (s.random.chance(30)) {
      random_copy(s, GL_STENCIL);
    } else {
      const int width = s.random.integer(1, 30), height = s.random.integer(1, 30);
      const std::vector<GLubyte> pixels = random_bytes(s, 48 * 48 * 4);
      gl.DrawPixels(width, height, GL_STENCIL_INDEX,
                    s.random.pick({GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT}), pixels.data());
    }
  }
}

static SceneRegistration stencils{{"stencil_images", draw_stencil_images, true}};
static SceneRegistration bitmaps{{"bitmaps", draw_bitmaps, true}}, images{{"images", draw_images, true}},
    copies{{"copies", draw_copies, true}};

} // namespace softgl::test
