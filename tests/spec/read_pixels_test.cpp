// glReadPixels, glPixelStore and glClear (GL 1.5, 4.2.3 and 4.3.2): random clears read back in every format
// and type.
#include <catch2/catch.hpp>

#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "spec/state_snapshot.h"
#include "support/gl.h"

using namespace softgl::test;

namespace {

struct Kind {
  GLenum format, type;
  int bytes;
};
const Kind kKinds[] = {
    {GL_RGBA, GL_UNSIGNED_BYTE, 4}, {1, GL_UNSIGNED_BYTE, 4},        {2, GL_UNSIGNED_BYTE, 4},
    {GL_RGB, GL_UNSIGNED_BYTE, 3},  {5, GL_UNSIGNED_SHORT_5_6_5, 2}, {GL_RGBA, GL_UNSIGNED_SHORT, 8},
    {GL_RGBA, GL_FLOAT, 16},        {GL_RGB, GL_FLOAT, 12},          {1, GL_FLOAT, 16},
    {2, GL_UNSIGNED_SHORT, 8}};
const GLenum kFormats[] = {GL_RED,
                           GL_GREEN,
                           GL_BLUE,
                           GL_ALPHA,
                           GL_RGB,
                           GL_BGR,
                           GL_RGBA,
                           GL_BGRA,
                           GL_LUMINANCE,
                           GL_LUMINANCE_ALPHA,
                           GL_DEPTH_COMPONENT,
                           GL_STENCIL_INDEX};
const GLenum kTypes[] = {GL_UNSIGNED_BYTE,
                         GL_BYTE,
                         GL_UNSIGNED_SHORT,
                         GL_SHORT,
                         GL_UNSIGNED_INT,
                         GL_INT,
                         GL_FLOAT,
                         GL_UNSIGNED_BYTE_3_3_2,
                         GL_UNSIGNED_BYTE_2_3_3_REV,
                         GL_UNSIGNED_SHORT_5_6_5,
                         GL_UNSIGNED_SHORT_5_6_5_REV,
                         GL_UNSIGNED_SHORT_4_4_4_4,
                         GL_UNSIGNED_SHORT_4_4_4_4_REV,
                         GL_UNSIGNED_SHORT_5_5_5_1,
                         GL_UNSIGNED_SHORT_1_5_5_5_REV,
                         GL_UNSIGNED_INT_8_8_8_8,
                         GL_UNSIGNED_INT_8_8_8_8_REV,
                         GL_UNSIGNED_INT_10_10_10_2,
                         GL_UNSIGNED_INT_2_10_10_10_REV};
const GLenum kTransfers[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE,
                             GL_RED_BIAS,  GL_GREEN_BIAS,  GL_BLUE_BIAS,  GL_ALPHA_BIAS,  GL_DEPTH_BIAS};

/// One random run; a line per thing seen, in which any difference shows.
std::vector<std::string> run(const Gl& gl, unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&](int n) { return int(random() % unsigned(n)); };
  const auto unit = [&] {
    return number(4) == 0 ? float(number(3)) / 2 : float(random() % 10001) / 10000.0f;
  };
  std::vector<std::string> lines;
  const Kind kind = kKinds[number(10)];
  const bool three_bytes = kind.bytes == 3; // OSMesa cannot draw to them, see reference/DEVIATIONS.md
  const int width = 1 + number(100), height = 1 + number(90);
  const auto note = [&](const char* what, const std::vector<unsigned char>& bytes) {
    uint64_t hash = 1469598103934665603u;
    for (unsigned char b : bytes) hash = (hash ^ b) * 1099511628211u;
    char text[200];
    std::snprintf(text, sizeof text, "%s: buffer %x %x %dx%d hash %lx", what, kind.format, kind.type, width,
                  height, static_cast<unsigned long>(hash));
    lines.push_back(text);
  };
  const int depth = number(3) == 0 ? 0 : number(2) ? 16 : 24;
  const int stencil = depth == 16 ? 0 : 8;
  void* context = gl.OSMesaCreateContextExt(kind.format, depth, stencil, 0, nullptr);
  std::vector<unsigned char> buffer(size_t(width + 20) * size_t(height) * size_t(kind.bytes), 0x5a);
  gl.OSMesaMakeCurrent(context, buffer.data(), kind.type, width, height);
  for (int i = 1 + number(8); i > 0; --i) {
    gl.ClearColor(unit(), unit(), unit(), unit());
    gl.ClearDepth(double(unit()));
    gl.ClearStencil(number(300));
    if (number(2) && !three_bytes) {
      gl.Enable(GL_SCISSOR_TEST);
      gl.Scissor(number(60) - 10, number(60) - 10, number(60), number(60));
    } else {
      gl.Disable(GL_SCISSOR_TEST);
    }
    const bool r = number(5) > 0 || three_bytes, g = number(5) > 0 || three_bytes,
               b = number(5) > 0 || three_bytes, a = number(5) > 0;
    gl.ColorMask(r, g, b, a);
    gl.StencilMask(number(3) ? ~0u : unsigned(random()));
    const int mask = number(8);
    gl.Clear((mask & 1 ? GL_COLOR_BUFFER_BIT : 0u) | (mask & 2 ? GL_DEPTH_BUFFER_BIT : 0u) |
             (mask & 4 ? GL_STENCIL_BUFFER_BIT : 0u));
  }
  gl.OSMesaPixelStore(kOSMesaYUp, number(2));
  gl.OSMesaPixelStore(kOSMesaRowLength, number(2) * (width + number(20)));
  gl.Finish();
  note("finished", buffer);
  bool transferred = false, inverted = false;
  for (int i = 0; i < 5; ++i) {
    GLenum format = kFormats[number(12)], type = kTypes[number(19)];
    // OSMesa 22.3.6 does not return from stencil indices in packed types.
    if ((format == GL_STENCIL_INDEX || format == GL_DEPTH_COMPONENT) && (type < GL_BYTE || type > GL_FLOAT))
      type = GL_FLOAT;
    if (number(6) == 0) {
      const int which = number(10);
      gl.PixelTransferf(kTransfers[which], unit() * 2 - (which < 5 ? 0.0f : 1.0f));
      transferred = true;
    }
    // What is 1.0 on the way to 32-bit integers overflows in OSMesa, see reference/DEVIATIONS.md.
    const bool floats = transferred || kind.format == 5 || kind.type == GL_FLOAT || format == GL_LUMINANCE ||
                        format == GL_LUMINANCE_ALPHA;
    if (floats && (type == GL_INT || type == GL_UNSIGNED_INT)) type = GL_FLOAT;
    const int x = number(20) - 5, y = number(20) - 5, columns = number(80) - 1, rows = number(80) - 1;
    if (number(3) == 0) {
      gl.PixelStorei(GL_PACK_ALIGNMENT, 1 << number(4));
      gl.PixelStorei(GL_PACK_ROW_LENGTH, number(2) * (80 + number(50)));
      const int skipped_rows = number(4);
      gl.PixelStorei(GL_PACK_SKIP_ROWS, skipped_rows);
      inverted = skipped_rows == 0 && number(2);
      gl.PixelStorei(GL_PACK_SKIP_PIXELS, number(5));
      gl.PixelStorei(GL_PACK_SWAP_BYTES, number(2));
    }
    // Of other images OSMesa's rows lie elsewhere: "rows are skipped in front of an inverted image".
    gl.PixelStorei(GL_PACK_INVERT_MESA, inverted && type != GL_BITMAP && y >= 0 && y + rows <= height);
    std::vector<unsigned char> image(150 * 100 * 16, 0xcd);
    gl.ReadPixels(x, y, columns, rows, format, type, image.data());
    char text[100];
    std::snprintf(text, sizeof text, "read %x %x (%d %d %d %d) error %x", format, type, x, y, columns, rows,
                  gl.GetError());
    note(text, image);
  }
  gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
  gl.OSMesaDestroyContext(context);
  return lines;
}

} // namespace

TEST_CASE("Clears and reads of every kind give OSMesa's bytes", "[spec][pixels]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    const auto ours = run(softgl_library(), seed), theirs = run(osmesa_library(), seed);
    for (size_t i = 0; i < ours.size(); ++i) CHECK(ours[i] == theirs[i]);
  }
}

TEST_CASE("A full component reads as the largest integer", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  for (const Kind& kind : {kKinds[0], kKinds[4], kKinds[5], kKinds[6]}) {
    std::vector<unsigned char> buffer(8 * 8 * 16);
    void* context = gl.OSMesaCreateContext(kind.format, nullptr);
    REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), kind.type, 8, 8));
    gl.ClearColor(1, 1, 1, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    GLuint whole = 0;
    GLint half = 0;
    gl.ReadPixels(0, 0, 1, 1, GL_RED, GL_UNSIGNED_INT, &whole);
    gl.ReadPixels(0, 0, 1, 1, GL_RED, GL_INT, &half);
    CHECK(whole == 0xffffffffu);
    CHECK(half == 0x7fffffff);
    gl.ReadPixels(0, 0, 1, 1, GL_LUMINANCE, GL_UNSIGNED_INT, &whole);
    CHECK(whole == 0xffffffffu);
    gl.OSMesaDestroyContext(context);
  }
}

TEST_CASE("glPixelStore and glReadPixels raise the errors of the specification", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  std::vector<unsigned char> buffer(8 * 8 * 4);
  void* context = gl.OSMesaCreateContextExt(GL_RGBA, 0, 0, 0, nullptr);
  REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 8, 8));
  const auto error_of = [&](auto&& call) {
    call();
    return gl.GetError();
  };
  unsigned char pixels[1024] = {9};
  CHECK(error_of([&] { gl.PixelStorei(GL_PACK_ALIGNMENT, 3); }) == GL_INVALID_VALUE);
  CHECK(error_of([&] { gl.PixelStorei(GL_UNPACK_ROW_LENGTH, -1); }) == GL_INVALID_VALUE);
  CHECK(error_of([&] { gl.PixelStoref(GL_PACK_SKIP_ROWS, -1.0f); }) == GL_INVALID_VALUE);
  CHECK(error_of([&] { gl.PixelStorei(GL_RED_SCALE, 1); }) == GL_INVALID_ENUM);
  GLint value = 0;
  gl.GetIntegerv(GL_PACK_ALIGNMENT, &value);
  CHECK(value == 4);
  CHECK(error_of([&] { gl.ReadPixels(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels); }) == GL_INVALID_VALUE);
  CHECK(error_of([&] { gl.ReadPixels(0, 0, 1, 1, 0x1234, GL_UNSIGNED_BYTE, pixels); }) == GL_INVALID_ENUM);
  CHECK(error_of([&] { gl.ReadPixels(0, 0, 1, 1, GL_RGBA, 0x1234, pixels); }) == GL_INVALID_ENUM);
  CHECK(error_of([&] { gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_BITMAP, pixels); }) == GL_INVALID_ENUM);
  CHECK(error_of([&] { gl.ReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4, pixels); }) ==
        GL_INVALID_OPERATION);
  CHECK(error_of([&] { gl.ReadPixels(0, 0, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, pixels); }) ==
        GL_INVALID_OPERATION);
  CHECK(error_of([&] { gl.ReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, pixels); }) ==
        GL_INVALID_OPERATION);
  CHECK(error_of([&] { gl.ReadPixels(0, 0, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, pixels); }) ==
        GL_INVALID_OPERATION);
  CHECK(error_of([&] {
          gl.ReadPixels(2147483647, -2147483647, 2147483647, 2147483647, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
        }) == GL_NO_ERROR);
  CHECK(pixels[0] == 9);
  CHECK(error_of([&] { gl.Clear(0x1); }) == GL_INVALID_VALUE);
  gl.Begin(GL_POINTS);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.End();
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.GetIntegerv(GL_PACK_ALIGNMENT, &value);
  CHECK(value == 4);
  gl.OSMesaDestroyContext(context);
}

// OSMesa repeats the upper bits (reference/DEVIATIONS.md).
TEST_CASE("bytes are read as the nearest elements of ten bits", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (int v = 0; v < 256; v++) {
    const GLubyte pixel[4] = {GLubyte(v), GLubyte(v), GLubyte(v), GLubyte(v)};
    gl.WindowPos2i(0, 0);
    gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    GLuint reversed, element;
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, &reversed);
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_INT_10_10_10_2, &element);
    const GLuint ten = GLuint(std::lround(v * 1023.0 / 255)), two = GLuint(std::lround(v * 3.0 / 255));
    INFO(v);
    CHECK(reversed == (ten | ten << 10 | ten << 20 | two << 30));
    CHECK(element == (ten << 22 | ten << 12 | ten << 2 | two));
  }
}

TEST_CASE("rows are skipped in front of an inverted image", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  std::vector<unsigned char> buffer(8 * 8 * 4);
  void* context = gl.OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, nullptr);
  REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 8, 8));
  const unsigned char rows[4] = {10, 20, 30, 40};
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_PACK_INVERT_MESA, GL_TRUE);
  GLint value = 0;
  gl.GetIntegerv(GL_PACK_INVERT_MESA, &value);
  CHECK(value == GL_TRUE);
  gl.WindowPos2i(4, 4);
  gl.DrawPixels(1, 4, GL_RED, GL_UNSIGNED_BYTE, rows); // unpacking is not inverted
  using Bytes = std::vector<int>;
  unsigned char read[8] = {};
  gl.PixelStorei(GL_PACK_SKIP_ROWS, 1);
  gl.ReadPixels(4, 4, 1, 4, GL_RED, GL_UNSIGNED_BYTE, read);
  CHECK(Bytes(read, read + 6) == Bytes{0, 40, 30, 20, 10, 0});
  // What lies outside of the window is left out, at its place.
  std::fill_n(read, 8, 7);
  gl.ReadPixels(4, 6, 1, 4, GL_RED, GL_UNSIGNED_BYTE, read);
  CHECK(Bytes(read, read + 6) == Bytes{7, 7, 7, 40, 30, 7});
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 1, 4, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, rows);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, read);
  CHECK(Bytes(read, read + 6) == Bytes{7, 40, 30, 20, 10, 7});
  gl.PixelStorei(GL_PACK_SKIP_ROWS, 0);
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, name);
  gl.BufferData(GL_PIXEL_PACK_BUFFER, 4, nullptr, GL_STREAM_READ);
  gl.ReadPixels(4, 4, 1, 4, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  CHECK(gl.GetError() == GL_NO_ERROR);
  gl.GetBufferSubData(GL_PIXEL_PACK_BUFFER, 0, 4, read);
  CHECK(Bytes(read, read + 4) == Bytes{40, 30, 20, 10});
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  GLubyte stipple[128], back[128];
  for (int i = 0; i < 128; ++i) stipple[i] = GLubyte(i);
  gl.PolygonStipple(stipple);
  gl.GetPolygonStipple(back);
  for (int i = 0; i < 128; ++i) CHECK(back[i] == stipple[(31 - i / 4) * 4 + i % 4]);
  gl.OSMesaDestroyContext(context);
}
