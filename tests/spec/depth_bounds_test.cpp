// GL_EXT_depth_bounds_test: fragments live where the depth that is stored lies within bounds. llvmpipe has no
// such test, so the pictures are compared with what the extension says of each pixel.
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <vector>

#include "spec/state_snapshot.h"
#include "support/random.h"

using namespace softgl::test;

namespace {

constexpr int kSize = 64;

template <class T> std::vector<T> read(const Gl& gl, GLenum format, GLenum type) {
  std::vector<T> pixels(size_t(kSize * kSize));
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, kSize, kSize, format, type, pixels.data());
  return pixels;
}

/// Depths of all sizes, the same at each call with one seed.
void draw_depths(const Gl& gl, Random& r) {
  gl.Clear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  gl.Color4ub(9, 9, 9, 9);
  for (int i = 0; i < 12; ++i) {
    gl.Begin(GL_TRIANGLES);
    for (int corner = 0; corner < 3; ++corner) {
      const float x = r.real(-1.5f, 1.5f), y = r.real(-1.5f, 1.5f), z = r.real(-1, 1);
      gl.Vertex3f(x, y, z);
    }
    gl.End();
  }
  gl.Disable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
}

void square(const Gl& gl, float z) {
  gl.Begin(GL_QUADS);
  gl.Vertex3f(-1, -1, z), gl.Vertex3f(1, -1, z), gl.Vertex3f(1, 1, z), gl.Vertex3f(-1, 1, z);
  gl.End();
}

/// Many triangles of a pixel or two, which have paths of their own.
void specks(const Gl& gl) {
  gl.Begin(GL_TRIANGLES);
  for (int y = 0; y < kSize; y += 2)
    for (int x = 0; x < kSize; x += 2) {
      const float left = float(x) / 32 - 1, low = float(y) / 32 - 1;
      gl.Vertex2f(left, low), gl.Vertex2f(left + 0.125f, low), gl.Vertex2f(left, low + 0.125f);
    }
  gl.End();
}

/// OSMesa 22.3.6 and softgl store a depth so.
uint32_t stored(double depth) { return uint32_t(std::nearbyint(depth * 16777215.0)); }

/// GL_UNSIGNED_INT answers (z << 8) | (z >> 16).
bool within(uint32_t answer, double least, double greatest) {
  return answer >> 8 >= stored(least) && answer >> 8 <= stored(greatest);
}

} // namespace

TEST_CASE("Fragments live where the stored depth is within the bounds", "[spec][depth_bounds]") {
  const Gl& gl = softgl_library();
  Random r(3);
  for (int scene = 0; scene < 12; ++scene) {
    CurrentContext context(gl);
    draw_depths(gl, r);
    const auto depths = read<uint32_t>(gl, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
    const double a = double(r.real(0, 1)), b = double(r.real(0, 1));
    const double least = scene == 0 ? double(depths[77] >> 8) / 16777215.0 : std::min(a, b),
                 greatest = scene == 0 ? least : std::max(a, b); // the bounds themselves are within
    gl.Enable(GL_DEPTH_BOUNDS_TEST_EXT);
    gl.DepthBoundsEXT(least, greatest);
    gl.Enable(GL_STENCIL_TEST); // whose operations come after
    gl.StencilOp(GL_INCR, GL_INCR, GL_INCR);
    gl.StencilFunc(scene % 3 ? GL_ALWAYS : GL_NEVER, 0, 255);
    if (scene % 2) gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ZERO);
    gl.Color4ub(200, 100, 50, 255);
    if (scene % 4 == 3) gl.Disable(GL_STENCIL_TEST);
    square(gl, 0.3f);
    const auto stencils = read<uint8_t>(gl, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE);
    const auto reds = read<uint8_t>(gl, GL_RED, GL_UNSIGNED_BYTE);
    CHECK(read<uint32_t>(gl, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT) ==
          depths); // no depth test, so none is written
    int wrong = 0, alive = 0;
    for (size_t i = 0; i < depths.size(); ++i) {
      const bool lives = within(depths[i], least, greatest);
      alive += lives;
      if (scene % 4 != 3) wrong += stencils[i] != (lives ? 1 : 0);
      if (scene % 3 != 0 || scene % 4 == 3) wrong += (reds[i] == 200) != lives;
    }
    CHECK(wrong == 0);
    CHECK((alive > 0 || scene != 0));
  }
}

TEST_CASE("The depth test and the bounds are two tests", "[spec][depth_bounds]") {
  const Gl& gl = softgl_library();
  for (const bool small : {false, true})
    for (const bool textured : {false, true}) {
      Random r(5);
      CurrentContext context(gl);
      draw_depths(gl, r);
      const auto depths = read<uint32_t>(gl, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
      gl.Enable(GL_DEPTH_TEST);
      gl.Enable(GL_DEPTH_BOUNDS_TEST_EXT);
      gl.DepthBoundsEXT(0.3, 0.9);
      const GLubyte texel[4] = {255, 255, 255, 255};
      gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
      gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      if (textured) gl.Enable(GL_TEXTURE_2D);
      gl.Color4ub(200, 100, 50, 255);
      small ? specks(gl) : square(gl, 0);
      const auto after = read<uint32_t>(gl, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
      const auto reds = read<uint8_t>(gl, GL_RED, GL_UNSIGNED_BYTE);
      int wrong = 0, drawn = 0;
      const uint32_t middle = 0x800000; // of z = 0
      for (size_t i = 0; i < depths.size(); ++i) {
        const bool passes = middle < depths[i] >> 8 && within(depths[i], 0.3, 0.9);
        const bool is_drawn = reds[i] == 200;
        drawn += is_drawn;
        wrong += small ? is_drawn && !passes : is_drawn != passes;
        wrong += after[i] >> 8 != (is_drawn ? middle : depths[i] >> 8);
      }
      CHECK(wrong == 0);
      CHECK(drawn > 100);
    }
}

TEST_CASE("Bounds of depths without a depth buffer, of pixels and of samples", "[spec][depth_bounds]") {
  const Gl& gl = softgl_library();
  {
    std::vector<GLubyte> buffer(kSize * kSize * 4);
    void* context = gl.OSMesaCreateContextExt(GL_RGBA, 0, 0, 0, nullptr);
    REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, kSize, kSize));
    gl.Enable(GL_DEPTH_BOUNDS_TEST_EXT);
    gl.DepthBoundsEXT(0.5, 0.5);
    square(gl, 0);
    CHECK(read<uint8_t>(gl, GL_RED, GL_UNSIGNED_BYTE)[100] == 255);
    gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    gl.OSMesaDestroyContext(context);
  }
  CurrentContext context(gl);
  gl.ClearDepth(0.25);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_BOUNDS_TEST_EXT);
  const auto red_of_pixel = [&](double least, double greatest) {
    const GLubyte color[4] = {77, 1, 2, 3};
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.DepthBoundsEXT(least, greatest);
    gl.WindowPos2i(3, 3);
    gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, color);
    GLubyte pixel[4] = {};
    gl.ReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    return int(pixel[0]);
  };
  CHECK(red_of_pixel(0.25, 0.5) == 77);
  CHECK(red_of_pixel(0.26, 0.5) == 0);

  GLuint names[3] = {}, framebuffers[2] = {};
  gl.GenRenderbuffers(3, names);
  gl.GenFramebuffers(2, framebuffers);
  const std::array<GLenum, 3> formats = {GL_RGBA8, GL_DEPTH_COMPONENT32F, GL_RGBA8};
  for (size_t i = 0; i < 3; ++i) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, names[i]);
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, i == 2 ? 0 : 4, formats[i], 8, 8);
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[1]);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[2]);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[0]);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, names[1]);
  REQUIRE(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  gl.Viewport(0, 0, 8, 8);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Disable(GL_DEPTH_BOUNDS_TEST_EXT); // half of a pixel's samples get another depth
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  gl.ColorMask(0, 0, 0, 0);
  gl.Begin(GL_QUADS);
  gl.Vertex3f(-1, -1, 0.5f), gl.Vertex3f(0.125f, -1, 0.5f), gl.Vertex3f(0.125f, 1, 0.5f),
      gl.Vertex3f(-1, 1, 0.5f);
  gl.End();
  gl.ColorMask(1, 1, 1, 1);
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_DEPTH_BOUNDS_TEST_EXT);
  gl.DepthBoundsEXT(0.7, 0.8);
  square(gl, 0);
  gl.Disable(GL_DEPTH_BOUNDS_TEST_EXT);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers[1]);
  gl.BlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[1]);
  GLubyte row[8 * 4] = {};
  gl.ReadPixels(0, 4, 8, 1, GL_RGBA, GL_UNSIGNED_BYTE, row);
  CHECK((row[0] == 255 && row[3 * 4] == 255 && row[5 * 4] == 0));
  CHECK((row[4 * 4] > 100 && row[4 * 4] < 150)); // two of four
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("The bounds are set, clamped, saved and compiled", "[spec][depth_bounds]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const auto bounds = [&] {
    std::array<double, 2> values = {7, 7};
    gl.GetDoublev(GL_DEPTH_BOUNDS_EXT, values.data());
    return values;
  };
  using Bounds = std::array<double, 2>;
  gl.NewList(1, GL_COMPILE);
  gl.DepthBoundsEXT(0.25, 0.5);
  gl.EndList();
  CHECK(bounds() == Bounds{0, 1});
  gl.PushAttrib(GL_DEPTH_BUFFER_BIT);
  gl.CallList(1);
  CHECK(bounds() == Bounds{0.25, 0.5});
  GLint whole[2] = {};
  gl.GetIntegerv(GL_DEPTH_BOUNDS_EXT, whole);
  CHECK((whole[0] == 536870911 && whole[1] == 1073741823));
  gl.DepthBoundsEXT(0.75, 0.5);
  CHECK(gl.GetError() == GL_INVALID_VALUE);
  CHECK(bounds() == Bounds{0.25, 0.5});
  gl.DepthBoundsEXT(-3, 2);
  CHECK(bounds() == Bounds{0, 1});
  gl.DepthBoundsEXT(0.125, 0.25);
  gl.PopAttrib();
  CHECK(bounds() == Bounds{0, 1});
}
