// The accumulation buffer (GL 1.5, 4.2.3 and 4.2.4): errors, what its operations change, and what they leave.
#include <catch2/catch.hpp>

#include <array>
#include <vector>

#include "spec/refused_calls.h"
#include "support/environment.h"

using namespace softgl::test;

namespace {

constexpr int kWidth = 100, kHeight = 80;
using Color = std::array<int, 4>;

/// A context with an RGBA buffer of bytes, current while it lives.
struct Window {
  const Gl& gl;
  std::vector<GLubyte> pixels = std::vector<GLubyte>(size_t(kWidth) * kHeight * 4);
  void* context;

  explicit Window(const Gl& library, int accumulation_bits = 16, void* shared = nullptr)
      : gl(library), context(gl.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, accumulation_bits, shared)) {
    REQUIRE(context);
    make_current();
  }
  ~Window() {
    gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    gl.OSMesaDestroyContext(context);
  }
  Window(const Window&) = delete;

  void make_current(int width = kWidth, int height = kHeight) const {
    REQUIRE(
        gl.OSMesaMakeCurrent(context, const_cast<GLubyte*>(pixels.data()), GL_UNSIGNED_BYTE, width, height));
  }
  void clear(float r, float g, float b, float a) const {
    gl.ClearColor(r, g, b, a), gl.Clear(GL_COLOR_BUFFER_BIT);
  }
  void clear_accumulation(float r, float g, float b, float a) const {
    gl.ClearAccum(r, g, b, a), gl.Clear(GL_ACCUM_BUFFER_BIT);
  }
  Color at(int x, int y) const {
    GLubyte c[4] = {};
    gl.ReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, c);
    return {c[0], c[1], c[2], c[3]};
  }
  /// What the accumulation buffer shows of itself.
  Color returned(int x = 0, int y = 0) const { return gl.Accum(GL_RETURN, 1), at(x, y); }
};

} // namespace

REFUSAL_TEST_CASE("glAccum refuses what the specification says, and changes nothing",
                  "[spec][errors][accumulation]") {
  const Gl& gl = softgl_library();
  SECTION("with an accumulation buffer") {
    const Window window(gl);
    window.clear(1, 0, 0, 1);
    window.clear_accumulation(0, 1, 0, 1);
    const BadCall calls[] = {BAD(INVALID_ENUM, Accum(GL_RED, 1)), BAD(INVALID_ENUM, Accum(GL_ACCUM - 1, 1)),
                             BAD(INVALID_ENUM, Accum(GL_ADD + 1, 1))};
    expect_refused(gl, calls, [&] { CHECK(window.at(0, 0) == Color{255, 0, 0, 255}); });
    gl.Begin(GL_POINTS);
    gl.Accum(GL_LOAD, 1);
    gl.End();
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    CHECK(window.returned() == Color{0, 255, 0, 255});
  }
  SECTION("without one") {
    const Window window(gl, 0);
    window.clear(1, 0, 0, 1);
    const BadCall calls[] = {
        BAD(INVALID_OPERATION, Accum(GL_ACCUM, 1)),  BAD(INVALID_OPERATION, Accum(GL_LOAD, 1)),
        BAD(INVALID_OPERATION, Accum(GL_RETURN, 1)), BAD(INVALID_OPERATION, Accum(GL_MULT, 1)),
        BAD(INVALID_OPERATION, Accum(GL_ADD, 1)),    BAD(INVALID_ENUM, Accum(GL_RED, 1))};
    expect_refused(gl, calls, [&] { CHECK(window.at(0, 0) == Color{255, 0, 0, 255}); });
    window.clear_accumulation(1, 1, 1, 1); // clears that have no buffer have no effect
    CHECK(gl.GetError() == GL_NO_ERROR);
  }
}

TEST_CASE("a context has the accumulation bits that OSMesa gives it", "[spec][accumulation]") {
  fix_environment();
  for (const Gl* gl : {&softgl_library(), &osmesa_library()})
    for (const int asked : {0, 1, 16, 32}) {
      INFO(gl->name << ", " << asked);
      const Window window(*gl, asked);
      for (GLenum name : {GL_ACCUM_RED_BITS, GL_ACCUM_GREEN_BITS, GL_ACCUM_BLUE_BITS, GL_ACCUM_ALPHA_BITS}) {
        GLint bits = -1;
        gl->GetIntegerv(name, &bits);
        CHECK(bits == (asked ? 16 : 0));
      }
    }
  const Gl& gl = softgl_library();
  const int attributes[] = {0x32, 8, 0}; // OSMESA_ACCUM_BITS
  void* context = gl.OSMesaCreateContextAttribs(attributes, nullptr);
  std::vector<GLubyte> pixels(16);
  REQUIRE(gl.OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, 2, 2));
  GLint bits = -1;
  gl.GetIntegerv(GL_ACCUM_ALPHA_BITS, &bits);
  CHECK(bits == 16);
  gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl.OSMesaDestroyContext(context);
}

TEST_CASE("the operations of the accumulation buffer do what they are called", "[spec][accumulation]") {
  const Gl& gl = softgl_library();
  const Window window(gl);
  CHECK(window.returned() == Color{0, 0, 0, 0}); // nobody has written it yet
  window.clear(1, 0.6f, 0.2f, 0.8f);
  gl.Accum(GL_ACCUM, 0.5f);
  CHECK(window.returned() == Color{127, 76, 25, 102}); // fractions of 1/32767 are cut off
  window.clear(1, 0, 0, 1);
  gl.Accum(GL_LOAD, 0.5f);
  gl.Accum(GL_ADD, 0.25f);
  CHECK(window.returned() == Color{191, 64, 64, 191});
  gl.Accum(GL_MULT, -2.0f / 3);
  CHECK(window.returned() == Color{0, 0, 0, 0}); // clamped
  gl.Accum(GL_RETURN, -1);
  CHECK(window.at(kWidth - 1, kHeight - 1) == Color{127, 42, 42, 127});
  gl.Accum(GL_RETURN, -4);
  CHECK(window.at(kWidth / 2, kHeight / 2) == Color{255, 170, 170, 255});
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("draws before glAccum are in it, draws after it are not", "[spec][accumulation]") {
  const Gl& gl = softgl_library();
  const Window window(gl);
  window.clear(0, 0, 0, 1);
  gl.Color3f(1, 0, 0);
  gl.Rectf(-1, -1, 0, 1);
  gl.Accum(GL_LOAD, 0.5f);
  window.clear(0, 0, 0, 1);
  gl.Color3f(0, 0, 1);
  gl.Rectf(-1, -1, 1, 0);
  gl.Accum(GL_ACCUM, 0.5f);
  gl.Color3f(1, 1, 1);
  gl.Rectf(-1, -1, 1, 1);
  gl.Accum(GL_RETURN, 1);
  gl.Color3f(0, 1, 0);
  gl.Rectf(0.5f, 0.5f, 1, 1);
  CHECK(window.at(1, 1) == Color{127, 0, 127, 255});
  CHECK(window.at(1, kHeight - 1) == Color{127, 0, 0, 255});
  CHECK(window.at(kWidth - 40, 1) == Color{0, 0, 127, 255});
  CHECK(window.at(kWidth - 40, kHeight - 30) == Color{0, 0, 0, 255});
  CHECK(window.at(kWidth - 1, kHeight - 1) == Color{0, 255, 0, 255});
  gl.Finish();
  CHECK(int(window.pixels[(size_t(kHeight - 1) * kWidth + kWidth - 1) * 4 + 1]) == 255);
  CHECK(int(window.pixels[0]) == 127);
}

TEST_CASE("the scissor box, the color mask and the draw buffer hold for glAccum", "[spec][accumulation]") {
  const Gl& gl = softgl_library();
  const Window window(gl);
  window.clear(1, 1, 1, 1);
  window.clear_accumulation(0.2f, 0.2f, 0.2f, 0.2f);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(13, 21, 50, 47);
  window.clear_accumulation(0.4f, 0.4f, 0.4f, 0.4f);
  gl.Accum(GL_ADD, 0.2f);
  gl.Scissor(14, 22, 48, 45);
  gl.ColorMask(1, 0, 1, 0);
  gl.Accum(GL_RETURN, 1);
  gl.Disable(GL_SCISSOR_TEST);
  CHECK(window.at(13, 22) == Color{255, 255, 255, 255});
  CHECK(window.at(14, 21) == Color{255, 255, 255, 255});
  CHECK(window.at(62, 66) == Color{255, 255, 255, 255});
  CHECK(window.at(14, 22) == Color{153, 255, 153, 255});
  CHECK(window.at(61, 66) == Color{153, 255, 153, 255});
  gl.ColorMask(1, 1, 1, 1);
  gl.DrawBuffer(GL_NONE);
  gl.Accum(GL_RETURN, 1);
  CHECK(window.at(14, 22) == Color{153, 255, 153, 255});
  gl.DrawBuffer(GL_FRONT);
  gl.Accum(GL_RETURN, 1);
  CHECK(window.at(13, 22) == Color{153, 153, 153, 153});
  CHECK(window.at(12, 22) == Color{51, 51, 51, 51});
  CHECK(window.at(13, 20) == Color{51, 51, 51, 51});
  // An empty or a distant box.
  for (int x : {0, 5000}) {
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(x, 0, x, x);
    for (GLenum op : {GL_LOAD, GL_ACCUM, GL_ADD, GL_MULT, GL_RETURN}) gl.Accum(op, 0.5f);
    window.clear_accumulation(1, 1, 1, 1);
    gl.Disable(GL_SCISSOR_TEST);
    CHECK(window.returned(13, 22) == Color{153, 153, 153, 153});
  }
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("glAccum does nothing in selection and feedback", "[spec][accumulation]") {
  const Gl& gl = softgl_library();
  const Window window(gl);
  window.clear(1, 1, 1, 1);
  window.clear_accumulation(0.2f, 0.2f, 0.2f, 0.2f);
  GLuint names[8];
  gl.SelectBuffer(8, names);
  gl.RenderMode(GL_SELECT);
  gl.Accum(GL_LOAD, 1);
  gl.Accum(GL_RETURN, 1);
  window.clear_accumulation(1, 1, 1, 1);
  gl.RenderMode(GL_RENDER);
  CHECK(window.at(0, 0) == Color{255, 255, 255, 255});
  CHECK(window.returned() == Color{51, 51, 51, 51});
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("attribute groups and lists know the accumulation buffer", "[spec][accumulation][lists]") {
  const Gl& gl = softgl_library();
  const Window window(gl);
  gl.ClearAccum(0.25f, -3, 3, 0.5f);
  gl.PushAttrib(GL_ACCUM_BUFFER_BIT);
  gl.ClearAccum(1, 1, 1, 1);
  gl.PopAttrib();
  GLfloat value[4] = {};
  gl.GetFloatv(GL_ACCUM_CLEAR_VALUE, value);
  CHECK(std::array{value[0], value[1], value[2], value[3]} == std::array{0.25f, -1.0f, 1.0f, 0.5f});
  gl.NewList(1, GL_COMPILE);
  gl.ClearAccum(0.2f, 0.2f, 0.2f, 0.2f);
  gl.Clear(GL_ACCUM_BUFFER_BIT);
  gl.Accum(GL_ADD, 0.2f);
  gl.Accum(GL_RETURN, 1);
  gl.Accum(GL_RED, 1);
  gl.EndList();
  CHECK(gl.GetError() == GL_NO_ERROR);
  CHECK(window.at(0, 0) == Color{0, 0, 0, 0});
  gl.CallList(1);
  CHECK(gl.GetError() == GL_INVALID_ENUM);
  CHECK(window.at(0, 0) == Color{102, 102, 102, 102});
}

TEST_CASE("contexts have accumulation buffers of their own, and new ones with a new size",
          "[spec][accumulation]") {
  const Gl& gl = softgl_library();
  const Window first(gl);
  first.clear_accumulation(1, 1, 1, 1);
  {
    const Window second(gl, 16, first.context);
    CHECK(second.returned() == Color{0, 0, 0, 0});
    second.clear_accumulation(0.2f, 0.2f, 0.2f, 0.2f);
  }
  first.make_current();
  CHECK(first.returned() == Color{255, 255, 255, 255});
  first.make_current(kWidth / 2, kHeight);
  CHECK(first.returned() == Color{0, 0, 0, 0});
}

TEST_CASE("glFinish shows what glAccum has returned", "[spec][accumulation][deviation]") {
  fix_environment();
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    const Window window(*gl);
    window.clear(1, 0, 0, 1);
    window.clear_accumulation(0, 1, 0, 1);
    gl->Finish();
    gl->Accum(GL_RETURN, 1);
    gl->Finish();
    const Color seen = {window.pixels[0], window.pixels[1], window.pixels[2], window.pixels[3]};
    CHECK(seen == (gl == &softgl_library() ? Color{0, 255, 0, 255} : Color{255, 0, 0, 255}));
    CHECK(window.at(0, 0) == Color{0, 255, 0, 255});
  }
}

TEST_CASE("draws have their colors after glAccum without a buffer to draw to",
          "[spec][accumulation][deviation]") {
  const Gl& gl = softgl_library();
  const Window window(gl);
  window.clear(0, 0, 0, 0);
  gl.Color3f(0, 1, 0);
  gl.Rectf(-1, -1, 1, 1);
  gl.DrawBuffer(GL_NONE);
  gl.Accum(GL_ACCUM, 0.2f);
  gl.DrawBuffer(GL_FRONT);
  window.clear(0, 0, 1, 1);
  gl.Color3f(0, 1, 1);
  gl.Rectf(-1, -1, 1, 1);
  CHECK(window.at(0, 0) == Color{0, 255, 255, 255}); // OSMesa: what was left in its memory
  CHECK(window.returned() == Color{0, 51, 0, 51});
}
