// GL 1.5, 3.6.4, 3.7 and 4.3.3: glDrawPixels, glBitmap and glCopyPixels. What they have in common with OSMesa
// is in the families bitmaps, images, copies and stencil_images of tests/conformance; here is what OSMesa
// does otherwise (reference/DEVIATIONS.md), errors, lists.
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "spec/state_snapshot.h"

namespace softgl::test {
namespace {

/// The red bytes of pixels (x, y) .. (x + count - 1, y).
std::vector<int> reds(const Gl& gl, int x, int y, int count) {
  std::vector<GLubyte> rgba(size_t(count) * 4);
  gl.PixelTransferf(GL_RED_SCALE, 1);
  gl.ReadPixels(x, y, count, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  std::vector<int> v;
  for (int i = 0; i < count; i++) v.push_back(rgba[size_t(i) * 4]);
  return v;
}

GLuint depth_at(const Gl& gl, int x, int y) {
  GLuint z = 0;
  gl.ReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &z);
  return z >> 8;
}

TEST_CASE("A centre between two elements belongs to the one whose left edge it is", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLubyte pixels[4] = {10, 20, 30, 40};
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.WindowPos2i(8, 3);
  gl.PixelZoom(0.5f, 1);
  gl.DrawPixels(4, 1, GL_RED, GL_UNSIGNED_BYTE, pixels);
  CHECK(reds(gl, 7, 3, 4) == std::vector<int>{0, 20, 40, 0});
  gl.WindowPos2i(8, 4);
  gl.PixelZoom(-0.5f, 1);
  gl.DrawPixels(4, 1, GL_RED, GL_UNSIGNED_BYTE, pixels);
  CHECK(reds(gl, 5, 4, 4) == std::vector<int>{0, 30, 10, 0});
  gl.WindowPos2i(8, 5);
  gl.PixelZoom(1, 0.5f);
  gl.DrawPixels(1, 4, GL_RED, GL_UNSIGNED_BYTE, pixels);
  CHECK(reds(gl, 8, 5, 1) == std::vector<int>{20});
  CHECK(reds(gl, 8, 6, 1) == std::vector<int>{40});
}

TEST_CASE("Each bitmap is drawn with the state it met, and all of them where they overlap",
          "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLubyte bits[8] = {0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff};
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  gl.Color3f(0.2f, 0, 0);
  gl.WindowPos2i(0, 0);
  for (int i = 0; i < 2; i++) gl.Bitmap(8, 1, 0, 0, 0, 0, bits);
  CHECK(reds(gl, 0, 0, 1) == std::vector<int>{102});
  gl.WindowPos2i(20, 0);
  gl.Bitmap(8, 1, 0, 0, 0, 0, bits);
  gl.ColorMask(0, 0, 0, 0);
  gl.Bitmap(8, 1, 4, 0, 0, 0, bits);
  CHECK(reds(gl, 14, 0, 8) == std::vector<int>{0, 0, 0, 0, 0, 0, 51, 51});
  gl.ColorMask(1, 1, 1, 1);
  gl.Enable(GL_FOG); // black
  gl.Fogi(GL_FOG_MODE, GL_LINEAR);
  gl.Fogf(GL_FOG_START, -1); // half of the color is left at a distance of 0
  gl.WindowPos2i(40, 0);
  gl.Bitmap(8, 1, 0, 0, 0, 0, bits);
  gl.Fogf(GL_FOG_START, -3);
  CHECK(reds(gl, 40, 0, 1) == std::vector<int>{26});
}

TEST_CASE("A bitmap moves the raster position, with and without bits", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLfloat p[4];
  gl.WindowPos2f(3, 4);
  gl.Bitmap(0, 0, 0, 0, 2.5f, -1, nullptr);
  gl.GetFloatv(GL_CURRENT_RASTER_POSITION, p);
  CHECK(p[0] == 5.5f);
  CHECK(p[1] == 3);
  gl.RasterPos2f(9, 9); // out of view
  gl.Bitmap(0, 0, 0, 0, 2.5f, -1, nullptr);
  gl.GetFloatv(GL_CURRENT_RASTER_POSITION, p);
  CHECK(p[0] == 5.5f);
}

TEST_CASE("The stencil test decides about copied pixels whatever its operations are", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.ClearColor(1, 0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(0, 0, 32, 64);
  gl.ClearColor(0, 0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilFunc(GL_NEVER, 0, 0xff);
  gl.WindowPos2i(0, 0);
  gl.CopyPixels(40, 0, 4, 4, GL_COLOR);
  CHECK(reds(gl, 0, 0, 1) == std::vector<int>{0});
  gl.StencilFunc(GL_ALWAYS, 0, 0xff);
  gl.CopyPixels(40, 0, 4, 4, GL_COLOR);
  CHECK(reds(gl, 0, 0, 1) == std::vector<int>{255});
}

TEST_CASE("Depths are drawn and copied with 24 bits, scaled and biased, and bring the raster color",
          "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.ClearDepth(0.25);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  gl.Color3f(1, 0, 0);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const std::array<GLuint, 3> integers{0x21201f1e, 0x80000000, 0xffffffff};
  gl.WindowPos2i(1, 1);
  gl.DrawPixels(3, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, integers.data());
  CHECK(depth_at(gl, 1, 1) == 0x21201f);
  CHECK(depth_at(gl, 2, 1) == 0x800000);
  CHECK(depth_at(gl, 3, 1) == 0xffffff);
  CHECK(reds(gl, 0, 1, 5) == std::vector<int>{0, 255, 255, 255, 0});
  const GLubyte byte = 244;
  gl.WindowPos2i(1, 2);
  gl.DrawPixels(1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, &byte);
  CHECK(depth_at(gl, 1, 2) == 0xf4f4f4);
  gl.PixelTransferf(GL_DEPTH_SCALE, 0.5f);
  gl.PixelTransferf(GL_DEPTH_BIAS, 0.25f);
  gl.WindowPos2i(1, 3);
  gl.CopyPixels(3, 1, 1, 1, GL_DEPTH);
  gl.PixelTransferf(GL_DEPTH_SCALE, 1);
  gl.PixelTransferf(GL_DEPTH_BIAS, 0);
  CHECK(depth_at(gl, 1, 3) == 0xbfffff);
  gl.PixelTransferf(GL_DEPTH_SCALE, -1);
  gl.PixelTransferf(GL_DEPTH_BIAS, 1);
  const GLfloat quarter = 0.25f;
  gl.WindowPos2i(1, 4);
  gl.DrawPixels(1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &quarter);
  gl.PixelTransferf(GL_DEPTH_SCALE, 1);
  gl.PixelTransferf(GL_DEPTH_BIAS, 0);
  CHECK(depth_at(gl, 1, 4) == 0xbfffff);
  gl.DepthFunc(GL_LESS); // compares with each fragment's own depth
  const std::array<GLuint, 2> two{0x10000000, 0x70000000};
  gl.WindowPos2i(10, 10);
  gl.DrawPixels(2, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, two.data());
  CHECK(depth_at(gl, 10, 10) == 0x100000);
  CHECK(depth_at(gl, 11, 10) == 0x400000);
}

TEST_CASE("Stencil values are shifted, offset and mapped, and written under the mask, whatever the tests are",
          "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_NEVER);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilFunc(GL_NEVER, 0, 0);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_NEVER, 0);
  const auto drawn = [&](GLubyte value) {
    GLubyte s = 0;
    gl.WindowPos2i(2, 2);
    gl.DrawPixels(1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &value);
    gl.PushAttrib(GL_PIXEL_MODE_BIT);
    gl.PixelTransferi(GL_INDEX_SHIFT, 0);
    gl.PixelTransferi(GL_INDEX_OFFSET, 0);
    gl.PixelTransferi(GL_MAP_STENCIL, 0);
    gl.ReadPixels(2, 2, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &s);
    gl.PopAttrib();
    return int(s);
  };
  CHECK(drawn(77) == 77);
  gl.PixelTransferi(GL_INDEX_SHIFT, 1);
  gl.PixelTransferi(GL_INDEX_OFFSET, 3);
  CHECK(drawn(10) == 23);
  const GLushort map[2] = {200, 100};
  gl.PixelMapusv(GL_PIXEL_MAP_S_TO_S, 2, map);
  gl.PixelTransferi(GL_MAP_STENCIL, 1);
  CHECK(drawn(10) == 100); // by the last bit of 23
  gl.StencilMask(0x0f);
  CHECK(drawn(10) == (100 & 0x0f) + (100 & 0xf0));
  gl.PixelTransferi(GL_MAP_STENCIL, 0);
  CHECK(drawn(4) == (11 & 0x0f) + (100 & 0xf0));
  CHECK(reds(gl, 2, 2, 1) == std::vector<int>{0});
}

TEST_CASE("Depths and stencil values are copied as the bytes of colors", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLuint word = 0x12345678;
  gl.Enable(GL_DEPTH_TEST), gl.DepthFunc(GL_ALWAYS);
  gl.WindowPos2i(3, 3);
  gl.DrawPixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, &word);
  gl.DepthMask(GL_FALSE), gl.Disable(GL_DEPTH_TEST);
  for (const GLenum type : {GL_DEPTH_STENCIL_TO_RGBA_NV, GL_DEPTH_STENCIL_TO_BGRA_NV}) {
    GLubyte rgba[4] = {};
    gl.WindowPos2i(20, 20);
    gl.CopyPixels(3, 3, 1, 1, type);
    gl.ReadPixels(20, 20, 1, 1, type == GL_DEPTH_STENCIL_TO_RGBA_NV ? GL_RGBA : GL_BGRA, GL_UNSIGNED_BYTE,
                  rgba);
    CHECK(std::vector<int>(rgba, rgba + 4) == std::vector<int>{0x12, 0x34, 0x56, 0x78});
  }
  // They are scaled and shifted first, and are fragments then: alpha is tested.
  gl.PixelTransferf(GL_DEPTH_SCALE, 2), gl.PixelTransferi(GL_INDEX_SHIFT, -4);
  gl.Enable(GL_ALPHA_TEST), gl.AlphaFunc(GL_LESS, 0.1f);
  gl.CopyPixels(3, 3, 1, 1, GL_DEPTH_STENCIL_TO_RGBA_NV);
  GLubyte rgba[4] = {};
  gl.ReadPixels(20, 20, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  CHECK(std::vector<int>(rgba, rgba + 4) == std::vector<int>{0x24, 0x68, 0xac, 7});
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("Color indexes become colors through the maps", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLfloat red[4] = {0, 0.2f, 0.4f, 1};
  gl.PixelMapfv(GL_PIXEL_MAP_I_TO_R, 4, red);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const GLshort index[4] = {0, 1, 2, 7};
  gl.WindowPos2i(0, 0);
  gl.DrawPixels(4, 1, GL_COLOR_INDEX, GL_SHORT, index);
  CHECK(reds(gl, 0, 0, 4) == std::vector<int>{0, 51, 102, 255});
  const GLubyte bits = 0x50;
  gl.WindowPos2i(0, 1);
  gl.DrawPixels(4, 1, GL_COLOR_INDEX, GL_BITMAP, &bits);
  CHECK(reds(gl, 0, 1, 4) == std::vector<int>{0, 51, 0, 51});
}

TEST_CASE("Lists keep pixel rectangles as the unpacking state then was", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const std::vector<GLubyte> pixels{1, 2, 3, 40, 50, 60, 7, 8};
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 4);
  gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 1);
  gl.NewList(1, GL_COMPILE);
  gl.WindowPos2i(5, 5);
  gl.DrawPixels(2, 2, GL_RED, GL_UNSIGNED_BYTE, pixels.data());
  gl.EndList();
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
  CHECK(reds(gl, 5, 5, 2) == std::vector<int>{0, 0});
  gl.CallList(1);
  CHECK(reds(gl, 5, 5, 2) == std::vector<int>{2, 3});
  CHECK(reds(gl, 5, 6, 2) == std::vector<int>{60, 7});
}

TEST_CASE("Texture, fog and color sum change the fragments of pixel rectangles", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLubyte texels[4] = {255, 0, 0, 255}, pixel[4] = {200, 200, 200, 255};
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.Enable(GL_TEXTURE_2D);
  gl.WindowPos2i(0, 0);
  gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  GLubyte out[4];
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, out);
  CHECK(int(out[0]) == 200);
  CHECK(int(out[1]) == 0);
  gl.Disable(GL_TEXTURE_2D);
  gl.Enable(GL_COLOR_SUM);
  gl.SecondaryColor3f(0, 0.2f, 0);
  gl.WindowPos2i(0, 0);
  gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, out);
  CHECK(int(out[0]) == 200);
  CHECK(int(out[1]) == 251);
}

TEST_CASE("Bad pixel rectangles raise errors and change nothing", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLubyte pixel[64] = {};
  const auto check = [&](GLenum error) { CHECK(gl.GetError() == error); };
  gl.DrawPixels(-1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel), check(GL_INVALID_VALUE);
  gl.DrawPixels(1, -1, GL_RGBA, GL_UNSIGNED_BYTE, pixel), check(GL_INVALID_VALUE);
  gl.DrawPixels(1, 1, GL_TEXTURE_2D, GL_UNSIGNED_BYTE, pixel), check(GL_INVALID_ENUM);
  gl.DrawPixels(1, 1, GL_RGBA, GL_RGBA, pixel), check(GL_INVALID_ENUM);
  gl.DrawPixels(1, 1, GL_RGBA, GL_BITMAP, pixel), check(GL_INVALID_ENUM);
  gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, pixel), check(GL_INVALID_OPERATION);
  gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr), check(GL_NO_ERROR);
  gl.CopyPixels(0, 0, -1, 1, GL_COLOR), check(GL_INVALID_VALUE);
  gl.CopyPixels(0, 0, 1, 1, GL_RGBA), check(GL_INVALID_ENUM);
  gl.CopyPixels(2147483647, -2147483647 - 1, 2147483647, 2147483647, GL_COLOR), check(GL_NO_ERROR);
  gl.Bitmap(-1, 1, 0, 0, 1, 1, pixel), check(GL_INVALID_VALUE);
  gl.Begin(GL_POINTS);
  gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  gl.End(), check(GL_INVALID_OPERATION);
  gl.Begin(GL_POINTS);
  gl.Bitmap(1, 1, 0, 0, 1, 1, pixel);
  gl.End(), check(GL_INVALID_OPERATION);
  gl.Begin(GL_POINTS);
  gl.CopyPixels(0, 0, 1, 1, GL_COLOR);
  gl.End(), check(GL_INVALID_OPERATION);
  GLfloat p[4];
  gl.GetFloatv(GL_CURRENT_RASTER_POSITION, p);
  CHECK(p[0] == 0);
  for (float zoom : {0.0f, INFINITY, -INFINITY, NAN, 1e30f, 1e-30f}) {
    gl.PixelZoom(zoom, zoom);
    gl.DrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    check(GL_NO_ERROR);
  }
  gl.PixelZoom(1, 1);
  gl.Bitmap(1, 1, NAN, INFINITY, INFINITY, NAN, pixel);
  gl.Bitmap(1, 1, 0, 0, 1, 1, pixel);
  gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  gl.Finish();
  check(GL_NO_ERROR);
}

// OSMesa repeats the upper bits (reference/DEVIATIONS.md).
TEST_CASE("elements of five and six bits are drawn as the nearest bytes", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (const auto& [type, format, red, red_bits] :
       {std::tuple{GL_UNSIGNED_SHORT_5_6_5, GL_RGB, 11, 5}, std::tuple{GL_UNSIGNED_SHORT_5_6_5, GL_RGB, 5, 6},
        std::tuple{GL_UNSIGNED_SHORT_5_6_5_REV, GL_RGB, 0, 5},
        std::tuple{GL_UNSIGNED_SHORT_5_5_5_1, GL_RGBA, 11, 5},
        std::tuple{GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_RGBA, 0, 5}})
    for (int v = 0; v < 1 << red_bits; v++) {
      const GLushort element = GLushort(v << red);
      gl.WindowPos2i(0, 0);
      gl.DrawPixels(1, 1, GLenum(format), GLenum(type), &element);
      GLubyte pixel[4];
      gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
      INFO(type << " " << v);
      CHECK(pixel[red == 5 ? 1 : 0] == std::lround(v * 255.0 / ((1 << red_bits) - 1)));
    }
}

} // namespace
} // namespace softgl::test
