// GL 1.5, 3.5.2: polygons with a pattern.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <vector>

#include "spec/state_snapshot.h"
#include "support/runner.h"

namespace softgl::test {
namespace {

std::array<GLubyte, 128> pattern; // these are read by the scenes
GLenum primitive, mode;
bool in_list;

// A white square of 64 x 64 pixels in the lower left corner, or its edges or corners.
void draw_square(Stage& s) {
  const Gl& gl = s.gl;
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.MatrixMode(GL_PROJECTION);
  gl.Ortho(0, s.width, 0, s.height, -1, 1);
  gl.PolygonStipple(pattern.data());
  gl.Enable(GL_POLYGON_STIPPLE);
  gl.PolygonMode(GL_FRONT_AND_BACK, mode);
  if (in_list) gl.NewList(1, GL_COMPILE);
  gl.Begin(primitive);
  gl.Vertex2f(0, 0);
  gl.Vertex2f(64, 0);
  gl.Vertex2f(64, 64);
  gl.Vertex2f(0, 64);
  gl.End();
  if (in_list) gl.EndList(), gl.CallList(1);
  gl.Finish();
}

Picture square(GLenum p, GLenum m, bool list = false) {
  primitive = p, mode = m, in_list = list;
  return draw(softgl_library(), {"square", draw_square}, 0);
}

/// Whether the pixel in column x of row y, counted from the bottom, is white.
bool lit(const Picture& p, int x, int y) { return p.color[size_t(y * p.width + x) * 4] == 255; }

TEST_CASE("A polygon's pattern begins at the window's lower left corner, with the most significant bit",
          "[spec][polygon]") {
  pattern.fill(0);
  pattern[0] = 0x80;     // row 0: column 0
  pattern[4 * 3] = 0x41; // row 3: columns 1 and 7
  pattern[127] = 0x02;   // row 31: column 30
  for (bool list : {false, true}) {
    const Picture p = square(GL_QUADS, GL_FILL, list);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const int px = x & 31, py = y & 31;
        INFO("column " << x << " row " << y);
        REQUIRE(lit(p, x, y) ==
                ((px == 0 && py == 0) || (py == 3 && (px == 1 || px == 7)) || (px == 30 && py == 31)));
      }
  }
}

// OSMesa writes a byte behind its memory then (reference/DEVIATIONS.md).
TEST_CASE("A polygon's pattern may begin inside a byte", "[spec][polygon]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  std::array<GLubyte, 8 * 32> bits{};
  const auto set = [&](int x, int y) { bits[size_t(8 * y + x / 8)] |= GLubyte(1u << (x % 8)); };
  set(5, 0);       // column 0 of row 0
  set(5 + 31, 31); // column 31 of row 31
  gl.PixelStorei(GL_UNPACK_LSB_FIRST, 1);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 64);
  gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 5);
  gl.PolygonStipple(bits.data());
  GLubyte read[128] = {};
  gl.GetPolygonStipple(read);
  for (int i = 0; i < 128; ++i) CHECK(int(read[i]) == (i == 0 ? 0x80 : i == 127 ? 0x01 : 0));
}

TEST_CASE("Lines and points have no polygon's pattern, those of polygons neither", "[spec][polygon]") {
  pattern.fill(0);
  const Picture nothing = square(GL_QUADS, GL_FILL);
  for (const auto& [p, m] : {std::pair<GLenum, GLenum>{GL_LINE_LOOP, GL_FILL},
                             {GL_POINTS, GL_FILL},
                             {GL_QUADS, GL_LINE},
                             {GL_QUADS, GL_POINT}}) {
    INFO("primitive " << p << " mode " << m);
    CHECK(compare(square(p, m), nothing).any());
  }
  CHECK(nothing.color == std::vector<uint8_t>(nothing.color.size(), 0));
}

TEST_CASE("A polygon's pattern stays at the lower left corner when the window's height changes",
          "[spec][polygon][deviation]") {
  const Gl& gl = softgl_library();
  std::vector<GLubyte> tall(40 * 50 * 4), low(40 * 37 * 4);
  void* context = gl.OSMesaCreateContextExt(GL_RGBA, 0, 0, 0, nullptr);
  REQUIRE(gl.OSMesaMakeCurrent(context, tall.data(), GL_UNSIGNED_BYTE, 40, 50));
  pattern.fill(0);
  pattern[4 * 3] = 0x40; // column 1 of row 3
  gl.PolygonStipple(pattern.data());
  gl.Enable(GL_POLYGON_STIPPLE);
  const auto draw_all = [&](const std::vector<GLubyte>& window, int height) {
    gl.Viewport(0, 0, 40, height);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Rectf(-1, -1, 1, 1);
    gl.Finish();
    CHECK(window[(40 * 3 + 1) * 4] == 255);
    CHECK(window[(40 * 35 + 33) * 4] == 255);
    CHECK(std::count(window.begin(), window.end(), 255) == 4 * 4); // 2 columns of 2 rows
  };
  draw_all(tall, 50);
  REQUIRE(gl.OSMesaMakeCurrent(context, low.data(), GL_UNSIGNED_BYTE, 40, 37));
  draw_all(low, 37);
  gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
  gl.OSMesaDestroyContext(context);
}

} // namespace
} // namespace softgl::test
