// Textures that are drawn to (GL_ARB_framebuffer_object, 4.4.2.3 and 4.4.3), blits, and where softgl differs
// from OSMesa there.
#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

constexpr uint32_t kRed = 0xff0000ff, kGreen = 0xff00ff00, kBlue = 0xffff0000;

/// An 8x8 texture of one color, bound, and attached to a framebuffer object, which is bound.
struct Target {
  GLuint framebuffer = 0, texture = 0;
  Target(const Gl& gl, uint32_t color, GLint format = GL_RGBA8) {
    const std::vector<uint32_t> texels(64, color);
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexImage2D(GL_TEXTURE_2D, 0, format, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    gl.Viewport(0, 0, 8, 8);
  }
};

uint32_t pixel(const Gl& gl, int x, int y) {
  uint32_t word = 0x12345678;
  gl.ReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &word);
  return word;
}

uint32_t texel(const Gl& gl, int x, int y) {
  uint32_t texels[64] = {};
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  return texels[8 * y + x];
}

void rectangle(const Gl& gl, float x0, float y0, float x1, float y1) {
  gl.Begin(GL_QUADS);
  gl.TexCoord2f(x0 * 0.5f + 0.5f, y0 * 0.5f + 0.5f), gl.Vertex2f(x0, y0);
  gl.TexCoord2f(x1 * 0.5f + 0.5f, y0 * 0.5f + 0.5f), gl.Vertex2f(x1, y0);
  gl.TexCoord2f(x1 * 0.5f + 0.5f, y1 * 0.5f + 0.5f), gl.Vertex2f(x1, y1);
  gl.TexCoord2f(x0 * 0.5f + 0.5f, y1 * 0.5f + 0.5f), gl.Vertex2f(x0, y1);
  gl.End();
}

} // namespace

TEST_CASE("Texels and drawn pixels are one image", "[spec][framebuffers]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  const Target target(gl, kGreen);
  CHECK(pixel(gl, 2, 1) == kGreen);
  gl.Color3f(1, 0, 0);
  rectangle(gl, -1, -1, 0, 0); // the lower left quarter
  CHECK((texel(gl, 0, 0) == kRed && texel(gl, 3, 3) == kRed && texel(gl, 4, 4) == kGreen));
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &kBlue);
  CHECK((pixel(gl, 0, 0) == kBlue && pixel(gl, 1, 0) == kRed && pixel(gl, 7, 7) == kGreen));
  rectangle(gl, 0, 0, 1, 1);
  GLint width = 0;
  gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width); // while the vertices wait
  CHECK(width == 8);
  CHECK((texel(gl, 0, 0) == kBlue && texel(gl, 7, 7) == kRed));
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Viewport(0, 0, 8, 8);
  gl.Color3f(1, 1, 1);
  gl.Enable(GL_TEXTURE_2D);
  rectangle(gl, -1, -1, 1, 1);
  CHECK((pixel(gl, 0, 0) == kBlue && pixel(gl, 1, 1) == kRed && pixel(gl, 7, 0) == kGreen));
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("A draw that samples its own target sees all draws before it", "[spec][framebuffers]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  const Target target(gl, kGreen);
  gl.Color3f(1, 0, 0);
  rectangle(gl, -1, -1, 0, 1); // the left half is red
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.MatrixMode(GL_TEXTURE);
  gl.Translatef(0.5f, 0, 0); // each half samples the other one
  rectangle(gl, -1, -1, 1, 1);
  gl.LoadIdentity();
  CHECK((pixel(gl, 0, 0) == kGreen && pixel(gl, 3, 7) == kGreen));
  CHECK((pixel(gl, 4, 0) == kRed && pixel(gl, 7, 7) == kRed));
}

TEST_CASE("A framebuffer object may have depths alone", "[spec][framebuffers]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  GLuint framebuffer = 0, texture = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT16, 8, 8, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT,
                nullptr);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  REQUIRE(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  gl.Viewport(0, 0, 8, 8);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.Translatef(0, 0, 1);
  rectangle(gl, -1, -1, 0, 1);
  GLushort depths[64];
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, depths);
  CHECK((depths[0] == 65535 && depths[7] == 65535)); // 1 is not less than 1
  gl.Translatef(0, 0, -2);
  rectangle(gl, -1, -1, 0, 1);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, depths);
  CHECK((depths[0] == 0 && depths[7] == 65535));
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("Depths and stencil values are kept together", "[spec][framebuffers]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  std::vector<uint32_t> words(64), back(64);
  for (size_t i = 0; i < 64; ++i) words[i] = uint32_t(i) * 0x01234567u;
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 8, 8, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                words.data());
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, back.data());
  CHECK(words == back);
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  std::fill(back.begin(), back.end(), 0);
  gl.ReadPixels(0, 0, 8, 8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, back.data());
  CHECK(words == back);
  gl.BlitFramebuffer(0, 0, 8, 4, 8, 8, 0, 4, GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT,
                     GL_NEAREST); // turned
  gl.ReadPixels(0, 0, 8, 8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, back.data());
  CHECK((back[63] == words[0] && back[32] == words[31] && back[5] == words[5]));
  gl.WindowPos2i(0, 0);
  gl.StencilMask(0x0f);
  const uint32_t one = 0x123456ff;
  gl.DrawPixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, &one);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, back.data());
  CHECK(back[0] == (0x12345600u | 0x0f | (words[0] & 0xf0)));
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("Contexts that share objects share renderbuffers and not framebuffer objects",
          "[spec][framebuffers]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  GLuint renderbuffer = 0, framebuffer = 0;
  gl.GenRenderbuffers(1, &renderbuffer);
  gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 8, 8);
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
  gl.ClearColor(0, 0, 1, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Finish();
  void* const mine = gl.OSMesaGetCurrentContext();
  void* const other = gl.OSMesaCreateContext(kOSMesaRgba, mine);
  std::vector<uint32_t> buffer(64 * 64), old(64 * 64);
  REQUIRE(gl.OSMesaMakeCurrent(other, buffer.data(), GL_UNSIGNED_BYTE, 64, 64));
  CHECK((gl.IsRenderbuffer(renderbuffer) && !gl.IsFramebuffer(framebuffer)));
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
  CHECK(pixel(gl, 7, 7) == kBlue);
  CHECK(gl.GetError() == GL_NO_ERROR);
  REQUIRE(gl.OSMesaMakeCurrent(mine, old.data(), GL_UNSIGNED_BYTE, 64, 64));
  gl.OSMesaDestroyContext(other);
}

TEST_CASE("Blits stretch, and mix where they are linear", "[spec][framebuffers]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  const Target target(gl, kRed);
  gl.Color3f(0, 1, 0);
  rectangle(gl, 0, -1, 1, 1);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl.ClearColor(0, 0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.BlitFramebuffer(0, 0, 8, 8, 10, 10, 42, 42, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(44, 0, 20, 64);
  gl.BlitFramebuffer(0, 0, 8, 8, 44, 10, 36, 26, GL_COLOR_BUFFER_BIT, GL_NEAREST); // all is cut off
  gl.Disable(GL_SCISSOR_TEST);
  gl.BlitFramebuffer(0, 0, 8, 8, 10, 50, 26, 58, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  CHECK((pixel(gl, 9, 10) == 0xff000000 && pixel(gl, 10, 10) == kRed && pixel(gl, 25, 41) == kRed));
  CHECK((pixel(gl, 26, 10) == kGreen && pixel(gl, 41, 41) == kGreen && pixel(gl, 42, 10) == 0xff000000));
  CHECK((pixel(gl, 10, 50) == kRed && pixel(gl, 17, 50) == 0xff0040bf && pixel(gl, 18, 57) == 0xff00bf40));
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("Floats are mixed by the weights that a linear blit has", "[spec][framebuffers][osmesa]") {
  constexpr int kFrom = 23, kTo = 2 * kFrom, kSize = 51; // OSMesa rounds coordinates of such sizes
  std::vector<float> red(kSize * kSize);
  for (size_t i = 0; i < red.size(); ++i) red[i] = float((i * 37) % 101) / 101.0f;
  const auto blit = [&](const Gl& gl) {
    const CurrentContext current{gl};
    GLuint framebuffers[2], textures[2];
    gl.GenFramebuffers(2, framebuffers);
    gl.GenTextures(2, textures);
    for (int i = 0; i < 2; ++i) {
      gl.BindTexture(GL_TEXTURE_2D, textures[i]);
      gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, kSize, kSize, 0, GL_RED, GL_FLOAT, red.data());
      gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[i]);
      gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[i], 0);
    }
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[0]);
    gl.BlitFramebuffer(0, 0, kFrom, kFrom, 0, 0, kTo, kFrom, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[1]);
    std::vector<float> out(kTo * kFrom);
    gl.ReadPixels(0, 0, kTo, kFrom, GL_RED, GL_FLOAT, out.data());
    CHECK(gl.GetError() == GL_NO_ERROR);
    return out;
  };
  const std::vector<float> ours = blit(softgl_library()), theirs = blit(osmesa_library());
  size_t others = 0;
  for (int y = 0; y < kFrom; ++y)
    for (int x = 0; x < kTo; ++x) {
      const int left = std::max((x - 1) / 2, 0), at = y * kSize + left;
      const float weight = x == 0 ? 0.0f : x % 2 ? 0.25f : 0.75f; // of the right one of two
      const float a = red[size_t(at)], b = red[size_t(at + 1)];
      const size_t i = size_t(y * kTo + x);
      CHECK(ours[i] == weight * (b - a) + a);
      CHECK(theirs[i] == Approx(ours[i]).margin(1e-4));
      others += theirs[i] != ours[i];
    }
  CHECK(others > 0);
}

TEST_CASE("Levels of cube maps can be attached one by one", "[spec][framebuffers][osmesa]") {
  const auto status = [](const Gl& gl) {
    const CurrentContext current{gl};
    GLuint framebuffer = 0, texture = 0;
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, texture);
    for (GLenum face = 0; face < 6; ++face)
      for (int level = 0; level < 2; ++level)
        gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, GL_RGBA8, 64 >> level, 64 >> level, 0,
                      GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, texture, 1);
    return gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  };
  CHECK(status(softgl_library()) == GL_FRAMEBUFFER_COMPLETE);
  CHECK(status(osmesa_library()) == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
}

TEST_CASE("A draw or read buffer without an image does not make a framebuffer object incomplete",
          "[spec][framebuffers][osmesa]") {
  const auto check = [](const Gl& gl) {
    const CurrentContext current{gl};
    GLuint framebuffer = 0, renderbuffer = 0;
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.GenRenderbuffers(1, &renderbuffer);
    gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, 8, 8);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, renderbuffer);
    CHECK(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    // Depths alone are drawn.
    gl.Viewport(0, 0, 8, 8);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Enable(GL_DEPTH_TEST);
    rectangle(gl, -1, -1, 0, 1);
    GLushort depth[2] = {};
    gl.ReadPixels(3, 4, 2, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, depth);
    CHECK((depth[0] == 0x8000 && depth[1] == 0xffff));
    gl.BlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    CHECK(gl.GetError() == GL_NO_ERROR);
    // There are no colors to read.
    pixel(gl, 0, 0);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    gl.WindowPos2i(0, 0);
    gl.CopyPixels(0, 0, 1, 1, GL_COLOR);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 4, 4, 0);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
  };
  check(softgl_library());
  check(osmesa_library());
}

TEST_CASE("Images are zoomed upwards from the raster position in framebuffer objects, too",
          "[spec][framebuffers][osmesa]") {
  const auto first_row = [](const Gl& gl) {
    const CurrentContext current{gl};
    const Target target(gl, kGreen);
    const std::vector<uint32_t> image(16, kRed);
    gl.WindowPos2i(2, 2);
    gl.PixelZoom(1, 0.7371f);
    gl.DrawPixels(2, 8, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    int y = 0;
    while (y < 8 && pixel(gl, 2, y) != kRed) ++y;
    return y;
  };
  CHECK(first_row(softgl_library()) == 2);
  CHECK(first_row(osmesa_library()) == 1);
}

TEST_CASE("Blits leave pixels that have no source", "[spec][framebuffers][osmesa]") {
  const auto drawn = [](const Gl& gl) {
    const CurrentContext current{gl};
    const Target target(gl, kRed);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl.ClearColor(0, 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.BlitFramebuffer(30, 0, -1, 8, 50, 0, 81, 8, GL_COLOR_BUFFER_BIT,
                       GL_NEAREST); // columns 72 .. 79 beyond 64
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    bool any = false;
    for (int x = 0; x < 64; ++x) any = any || pixel(gl, x, 3) == kRed;
    return any;
  };
  CHECK(!drawn(softgl_library()));
  CHECK(drawn(osmesa_library()));
}

TEST_CASE("Depths of 32 bits are drawn with 24", "[spec][framebuffers][osmesa]") {
  const auto depth_bits = [](const Gl& gl) {
    const CurrentContext current{gl};
    GLuint renderbuffer = 0;
    gl.GenRenderbuffers(1, &renderbuffer);
    gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32, 8, 8);
    GLint bits = -1;
    gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_DEPTH_SIZE, &bits);
    return bits;
  };
  CHECK(depth_bits(softgl_library()) == 24);
  CHECK(depth_bits(osmesa_library()) == 32);
}

TEST_CASE("A wide line is clipped to the view volume, whatever it is drawn to",
          "[spec][framebuffers][deviation]") {
  // Its first vertex lies above the view volume, which it enters near the column 16.
  const auto first_column = [](const Gl& gl, GLenum format) {
    const CurrentContext current{gl};
    constexpr int kWidth = 49, kHeight = 64;
    GLuint texture = 0, framebuffer = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kWidth, kHeight, 0, format, GL_UNSIGNED_BYTE, nullptr);
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    gl.Viewport(0, 0, kWidth, kHeight);
    gl.ClearColor(0, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.LineWidth(5);
    gl.Begin(GL_LINES);
    gl.Vertex2f(-0.6911416f, 1.0588704f);
    gl.Vertex2f(0.887853f, 0.7923841f);
    gl.End();
    for (int x = 0; x < kWidth; ++x)
      for (int y = 0; y < kHeight; ++y)
        if (pixel(gl, x, y) != 0) return x;
    return kWidth;
  };
  for (GLenum format : {GL_RGBA, GL_BGRA}) CHECK(first_column(softgl_library(), format) == 16);
  CHECK(first_column(osmesa_library(), GL_RGBA) == 16);
  CHECK(first_column(osmesa_library(), GL_BGRA) == 7); // blue first, and no depths: it clips nothing
}
