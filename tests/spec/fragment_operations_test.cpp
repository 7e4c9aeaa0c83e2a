// Per-fragment operations (GL 1.5, chapter 4.1) on every kind of buffer: random states, triangles of all
// sizes, points and lines, against OSMesa.
#include <catch2/catch.hpp>

#include <cstring>
#include <random>
#include <vector>

#include "support/gl.h"

using namespace softgl::test;

namespace {

struct Kind {
  const char* name;
  GLenum format, type;
  int bytes;
};
const Kind kKinds[] = {{"rgba ubyte", GL_RGBA, GL_UNSIGNED_BYTE, 4},
                       {"rgb 565", 5, GL_UNSIGNED_SHORT_5_6_5, 2},
                       {"rgba ushort", GL_RGBA, GL_UNSIGNED_SHORT, 8},
                       {"rgba float", GL_RGBA, GL_FLOAT, 16}};

struct Picture {
  std::vector<unsigned char> color;
  std::vector<GLuint> depth;
  std::vector<unsigned char> stencil;
};

struct Options {
  bool blend, stencil, logic;
  int depth_bits;
};

Picture draw(const Gl& gl, const Kind& kind, unsigned seed, const Options& options) {
  std::mt19937 random(seed);
  const auto number = [&](int n) { return int(random() % unsigned(n)); };
  const auto unit = [&] { return float(random() % 10001) / 10000.0f; };
  const int width = 90, height = 70;
  void* context =
      gl.OSMesaCreateContextExt(kind.format, options.depth_bits, options.stencil ? 8 : 0, 0, nullptr);
  Picture p;
  p.color.resize(size_t(width * height * kind.bytes));
  REQUIRE(gl.OSMesaMakeCurrent(context, p.color.data(), kind.type, width, height));
  gl.ClearColor(unit(), unit(), unit(), unit());
  gl.ClearDepth(0.7);
  gl.ClearStencil(number(256));
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  const GLenum factors[] = {GL_ZERO,
                            GL_ONE,
                            GL_SRC_COLOR,
                            GL_ONE_MINUS_SRC_COLOR,
                            GL_SRC_ALPHA,
                            GL_ONE_MINUS_SRC_ALPHA,
                            GL_DST_ALPHA,
                            GL_ONE_MINUS_DST_ALPHA,
                            GL_DST_COLOR,
                            GL_ONE_MINUS_DST_COLOR,
                            GL_CONSTANT_COLOR,
                            GL_ONE_MINUS_CONSTANT_COLOR,
                            GL_CONSTANT_ALPHA,
                            GL_ONE_MINUS_CONSTANT_ALPHA,
                            GL_SRC_ALPHA_SATURATE};
  const GLenum equations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
  const GLenum operations[] = {GL_KEEP, GL_ZERO,   GL_REPLACE,   GL_INCR,
                               GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};
  for (int i = 0; i < 12; ++i) {
    gl.Disable(GL_BLEND), gl.Disable(GL_COLOR_LOGIC_OP), gl.Disable(GL_STENCIL_TEST),
        gl.Disable(GL_ALPHA_TEST);
    if (options.blend && number(4)) {
      gl.Enable(GL_BLEND);
      gl.BlendEquation(equations[number(5)]);
      gl.BlendColor(unit(), unit(), unit(), unit());
      if (number(2)) {
        gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        gl.BlendEquation(GL_FUNC_ADD);
      } else {
        gl.BlendFuncSeparate(factors[number(15)], factors[number(14)], factors[number(15)],
                             factors[number(14)]);
      }
    }
    if (options.logic && number(3) == 0) {
      gl.Enable(GL_COLOR_LOGIC_OP);
      gl.LogicOp(GLenum(GL_CLEAR + number(16)));
    }
    if (number(3) == 0) {
      gl.Enable(GL_ALPHA_TEST);
      gl.AlphaFunc(GLenum(GL_NEVER + 1 + number(7)), unit());
    }
    if (options.stencil && number(4)) {
      gl.Enable(GL_STENCIL_TEST);
      gl.StencilFunc(GLenum(GL_NEVER + 1 + number(7)), number(300), number(2) ? ~0u : unsigned(number(256)));
      gl.StencilOp(operations[number(8)], operations[number(8)], operations[number(8)]);
      gl.StencilMask(number(2) ? ~0u : unsigned(number(256)));
    }
    if (number(4))
      gl.Enable(GL_DEPTH_TEST);
    else
      gl.Disable(GL_DEPTH_TEST);
    gl.DepthFunc(GLenum(GL_NEVER + 1 + number(7)));
    gl.DepthMask(GLboolean(number(3) != 0));
    const bool all = number(3) != 0;
    gl.ColorMask(all || number(2), all || number(2), all || number(2), all || number(2));
    const int mode = number(5);
    const float size = mode < 3 ? (mode == 0 ? 1.5f : mode == 1 ? 0.06f : 0.25f) : 1.0f;
    if (mode == 3) gl.PointSize(1 + unit() * 9);
    if (mode == 4) gl.LineWidth(1 + unit() * 4);
    gl.Begin(mode < 3 ? GL_TRIANGLES : mode == 3 ? GL_POINTS : GL_LINES);
    for (int k = mode == 0 ? 2 : 40; k > 0; --k) {
      const float x = unit() * 2 - 1, y = unit() * 2 - 1;
      for (int c = mode < 3 ? 3 : mode == 3 ? 1 : 2; c > 0; --c) {
        const float r = unit(), g = unit(), b = unit(), a = unit();
        gl.Color4f(r, g, b, a);
        const float dx = unit() - 0.5f, dy = unit() - 0.5f, z = unit() * 1.6f - 0.8f;
        gl.Vertex3f(std::min(std::max(x + size * dx, -0.99f), 0.99f),
                    std::min(std::max(y + size * dy, -0.99f), 0.99f), z);
      }
    }
    gl.End();
  }
  gl.Finish();
  p.depth.resize(size_t(width * height));
  if (options.depth_bits)
    gl.ReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, p.depth.data());
  p.stencil.resize(size_t(width * height));
  if (options.stencil) {
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.ReadPixels(0, 0, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, p.stencil.data());
  }
  CHECK(gl.GetError() == GL_NO_ERROR);
  gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
  gl.OSMesaDestroyContext(context);
  return p;
}

template <class T> size_t differences(const std::vector<T>& a, const std::vector<T>& b) {
  size_t n = 0;
  for (size_t i = 0; i < a.size(); ++i) n += a[i] != b[i];
  return n;
}

void compare(const Kind& kind, const Options& options, unsigned first, unsigned count) {
  for (unsigned seed = first; seed < first + count; ++seed) {
    INFO(kind.name << " depth " << options.depth_bits << " blend " << options.blend << " stencil "
                   << options.stencil << " logic " << options.logic << " seed " << seed);
    const Picture ours = draw(softgl_library(), kind, seed, options),
                  theirs = draw(osmesa_library(), kind, seed, options);
    CHECK(differences(ours.color, theirs.color) == 0);
    CHECK(differences(ours.depth, theirs.depth) == 0);
    CHECK(differences(ours.stencil, theirs.stencil) == 0);
  }
}

} // namespace

TEST_CASE("Fragments of 8-bit buffers are tested, blended and combined as by OSMesa", "[spec][fragments]") {
  for (bool stencil : {false, true}) compare(kKinds[0], {true, stencil, true, 24}, 100, 12);
  compare(kKinds[0], {true, false, true, 16}, 200, 6);
  compare(kKinds[0], {true, false, true, 0}, 300, 6);
}

TEST_CASE("Fragments of 5-6-5 buffers are tested, blended and combined as by OSMesa", "[spec][fragments]") {
  for (bool stencil : {false, true}) compare(kKinds[1], {true, stencil, true, 24}, 400, 8);
}

TEST_CASE("Fragments of 16-bit buffers are tested and stored as by OSMesa", "[spec][fragments]") {
  for (bool stencil : {false, true}) compare(kKinds[2], {false, stencil, true, 24}, 500, 8);
}

TEST_CASE("Fragments of float buffers are tested and stored as by OSMesa", "[spec][fragments]") {
  for (bool stencil : {false, true}) compare(kKinds[3], {false, stencil, false, 24}, 600, 8);
}

TEST_CASE("Fragments of 16-bit and float buffers are blended as by OSMesa", "[spec][fragments]") {
  compare(kKinds[2], {true, false, false, 24}, 700, 8);
  compare(kKinds[3], {true, false, false, 24}, 800, 8);
}

TEST_CASE("Polygon offset of filled polygons obeys GL_POLYGON_OFFSET_FILL only", "[spec][fragments]") {
  // OSMesa 22.3.6 offsets fills when any of the three enables is set: see reference/DEVIATIONS.md.
  const Gl& gl = softgl_library();
  auto depth_with = [&](GLenum enable) {
    std::vector<unsigned char> buffer(16 * 16 * 4);
    void* context = gl.OSMesaCreateContextExt(GL_RGBA, 24, 0, 0, nullptr);
    REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 16, 16));
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Enable(GL_DEPTH_TEST);
    gl.PolygonOffset(0, 1000);
    if (enable) gl.Enable(enable);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex3f(-1, -1, 0), gl.Vertex3f(1, -1, 0), gl.Vertex3f(0, 1, 0);
    gl.End();
    GLuint depth = 0;
    gl.ReadPixels(8, 8, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &depth);
    gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    gl.OSMesaDestroyContext(context);
    return depth;
  };
  const GLuint plain = depth_with(0);
  CHECK(depth_with(GL_POLYGON_OFFSET_LINE) == plain);
  CHECK(depth_with(GL_POLYGON_OFFSET_POINT) == plain);
  CHECK(depth_with(GL_POLYGON_OFFSET_FILL) > plain);
}

TEST_CASE("the color sum reaches the fog as it is", "[spec][fragments]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    std::vector<unsigned char> color(4 * 4 * 4);
    void* context = gl->OSMesaCreateContext(GL_RGBA, nullptr);
    REQUIRE(gl->OSMesaMakeCurrent(context, color.data(), GL_UNSIGNED_BYTE, 4, 4));
    const float black[4] = {0, 0, 0, 0};
    gl->Enable(GL_COLOR_SUM);
    gl->Enable(GL_FOG);
    gl->Fogi(GL_FOG_MODE, GL_LINEAR);
    gl->Fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    gl->Fogfv(GL_FOG_COLOR, black);
    gl->Fogf(GL_FOG_END, 1);
    gl->FogCoordf(0.5f);
    gl->Color3f(1, 1, 0);
    gl->SecondaryColor3f(1, 0, 0);
    gl->Rectf(-1, -1, 1, 1);
    gl->Finish();
    INFO(gl->name);
    CHECK(int(color[0]) == 255); // half of 2, not of 1
    CHECK(int(color[1]) == 128);
    CHECK(int(color[2]) == 0);
    gl->OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    gl->OSMesaDestroyContext(context);
  }
}
