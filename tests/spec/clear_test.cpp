// glClear (GL 1.5, 4.2.3) among draws and reads. A clear of a whole tile may wait until something needs its
// pixels; a clear of a part never does, so both ways must show the same at all times.
#include <catch2/catch.hpp>

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "support/gl.h"

using namespace softgl::test;

namespace {

constexpr int kWidth = 200, kHeight = 150;

struct Buffer {
  GLenum format, type;
  int bytes, depth, stencil;
};
const Buffer kBuffers[] = {
    {GL_RGBA, GL_UNSIGNED_BYTE, 4, 24, 8},    {GL_RGBA, GL_UNSIGNED_BYTE, 4, 24, 0},
    {GL_RGBA, GL_UNSIGNED_BYTE, 4, 16, 0},    {GL_RGB, GL_UNSIGNED_BYTE, 3, 24, 8},
    {kOSMesaBgra, GL_UNSIGNED_BYTE, 4, 0, 8}, {kOSMesaRgb565, GL_UNSIGNED_SHORT_5_6_5, 2, 24, 8},
    {GL_RGBA, GL_FLOAT, 16, 24, 8},           {GL_RGBA, GL_UNSIGNED_SHORT, 8, 16, 0}};

/// Makes random calls; `parts`: whole clears in two scissored parts. Gives all that was seen on the way.
std::vector<unsigned char> run(const Gl& gl, unsigned seed, bool parts) {
  std::mt19937 random(seed);
  const auto number = [&](int n) { return int(random() % unsigned(n)); };
  const auto unit = [&] { return float(random() % 1001) / 1000.0f; };
  const Buffer& kind = kBuffers[seed % std::size(kBuffers)];
  // As OSMesa does, clears of a part round in another way: values that can be stored are used.
  const auto stored = [&] {
    return kind.format == kOSMesaRgb565 ? float(number(2)) : float(number(256)) / 255.0f;
  };
  std::vector<unsigned char> seen, buffer(size_t(kWidth) * kHeight * size_t(kind.bytes));
  const auto see = [&](const void* data, size_t bytes) {
    const auto* p = static_cast<const unsigned char*>(data);
    seen.insert(seen.end(), p, p + bytes);
  };
  void* context = gl.OSMesaCreateContextExt(kind.format, kind.depth, kind.stencil, 0, nullptr);
  REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), kind.type, kWidth, kHeight));
  const auto read = [&](GLenum format, GLenum type, size_t bytes) {
    std::vector<unsigned char> pixels(size_t(kWidth) * kHeight * bytes);
    gl.ReadPixels(0, 0, kWidth, kHeight, format, type, pixels.data());
    see(pixels.data(), pixels.size());
  };
  const auto see_depths = [&] {
    void* depth = nullptr;
    GLint width = 0, height = 0, bytes = 0;
    if (gl.OSMesaGetDepthBuffer(context, &width, &height, &bytes, &depth))
      see(depth, size_t(width) * size_t(height) * size_t(bytes));
  };
  for (int step = 0; step < 12; ++step) {
    switch (number(8)) {
    case 0:
    case 1:
    case 2: {
      gl.ClearColor(stored(), stored(), stored(), stored());
      gl.ClearDepth(number(2));
      gl.ClearStencil(number(256));
      const GLbitfield mask = (number(4) ? GL_COLOR_BUFFER_BIT : 0u) |
                              (number(4) ? GL_DEPTH_BUFFER_BIT : 0u) |
                              (number(3) ? 0u : GL_STENCIL_BUFFER_BIT);
      if (!parts) {
        gl.Clear(mask);
        break;
      }
      gl.Enable(GL_SCISSOR_TEST);
      gl.Scissor(0, 0, 33, kHeight);
      gl.Clear(mask);
      for (int x = 33; x < kWidth; x += 50) {
        gl.Scissor(x, 0, 50, 70);
        gl.Clear(mask);
        gl.Scissor(x, 70, 50, kHeight);
        gl.Clear(mask);
      }
      gl.Disable(GL_SCISSOR_TEST);
      break;
    }
    case 3: { // part of the surface, in both ways
      gl.Enable(GL_SCISSOR_TEST);
      gl.Scissor(number(kWidth), number(kHeight), number(100), number(100));
      gl.ClearColor(stored(), stored(), stored(), stored());
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
      gl.Disable(GL_SCISSOR_TEST);
      break;
    }
    case 4: {
      const bool all = number(2);
      gl.ColorMask(all || number(2), all || number(2), all || number(2), all || number(2));
      gl.StencilMask(number(2) ? ~0u : unsigned(number(256)));
      gl.DepthMask(GLboolean(number(3) > 0));
      break;
    }
    case 5: { // a triangle of any size
      const auto set = [&](GLenum capability) { number(2) ? gl.Enable(capability) : gl.Disable(capability); };
      set(GL_DEPTH_TEST), set(GL_STENCIL_TEST), set(GL_BLEND);
      gl.DepthFunc(number(2) ? GL_LESS : GL_ALWAYS);
      gl.BlendFunc(GL_ONE, GL_ONE);
      gl.StencilFunc(GL_ALWAYS, number(256), ~0u);
      gl.StencilOp(GL_KEEP, GL_INCR, GL_REPLACE);
      const float size = number(2) ? 0.1f : 1.0f, x = unit() * 2 - 1, y = unit() * 2 - 1;
      gl.Begin(GL_TRIANGLES);
      gl.Color4f(unit(), unit(), unit(), unit());
      gl.Vertex3f(x, y, unit());
      gl.Vertex3f(x + size, y, unit());
      gl.Vertex3f(x, y + size, unit());
      gl.End();
      break;
    }
    case 6: // from the second time on the copy of the depths is that of the last glFinish or glFlush
      number(2) ? gl.Finish() : gl.Flush();
      see(buffer.data(), buffer.size());
      see_depths();
      break;
    case 7:
      read(GL_RGBA, GL_FLOAT, 16);
      if (kind.depth) read(GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4);
      if (kind.stencil) read(GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1);
      break;
    }
  }
  gl.Finish();
  see(buffer.data(), buffer.size());
  see_depths();
  read(GL_RGBA, GL_UNSIGNED_BYTE, 4);
  if (kind.stencil) read(GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1);
  CHECK(gl.GetError() == GL_NO_ERROR);
  gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
  gl.OSMesaDestroyContext(context);
  return seen;
}

} // namespace

TEST_CASE("a clear is the clear of its parts, whatever is drawn and read in between", "[spec][pixels]") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    INFO("seed " << seed);
    const bool same = run(softgl_library(), seed, false) == run(softgl_library(), seed, true);
    CHECK(same);
  }
}

TEST_CASE("a surface that nobody has cleared or drawn on is black and zero", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  for (const Buffer& kind : kBuffers) {
    INFO("format " << kind.format << " type " << kind.type);
    std::vector<unsigned char> buffer(size_t(kWidth) * kHeight * size_t(kind.bytes), 0x5a);
    void* context = gl.OSMesaCreateContextExt(kind.format, kind.depth, kind.stencil, 0, nullptr);
    REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), kind.type, kWidth, kHeight));
    std::vector<unsigned char> pixels(size_t(kWidth) * kHeight * 4, 0x5a);
    gl.ReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    const unsigned char alpha = kind.format == GL_RGB || kind.format == kOSMesaRgb565 ? 255 : 0;
    bool black = true;
    for (size_t i = 0; i < pixels.size(); ++i) black = black && pixels[i] == (i % 4 == 3 ? alpha : 0);
    CHECK(black);
    if (kind.depth) {
      GLuint depth = 1;
      gl.ReadPixels(kWidth - 1, kHeight - 1, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &depth);
      CHECK(depth == 0);
    }
    gl.OSMesaDestroyContext(context);
  }
}

TEST_CASE("clears in a row need no memory for each", "[spec][pixels]") {
  const auto resident = [] {
    long size = 0, pages = 0;
    std::ifstream("/proc/self/statm") >> size >> pages;
    return double(pages) * double(sysconf(_SC_PAGESIZE)) / 1e6;
  };
  const Gl& gl = softgl_library();
  std::vector<unsigned char> buffer(512 * 512 * 4);
  void* context = gl.OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, nullptr);
  REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 512, 512));
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Finish();
  const double before = resident(); // in megabytes
  gl.ClearColor(0, 0, 1, 1);
  for (int i = 0; i < 100000; ++i) gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Finish();
  CHECK(resident() - before < 100);
  CHECK(int(buffer[2]) == 255);
  gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
  gl.OSMesaDestroyContext(context);
}
