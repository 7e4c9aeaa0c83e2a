// What the OSMesa functions answer, asked of softgl and of OSMesa with the same script.
#include <catch2/catch.hpp>

#include <cstring>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "support/gl.h"

using namespace softgl::test;

namespace {

struct Log {
  std::vector<std::string> lines;
  template <class... T> void add(const T&... parts) {
    std::ostringstream out;
    ((out << parts << ' '), ...);
    lines.push_back(out.str());
  }
};

/// Runs the script on both libraries and compares what it logs.
void same_answers(const std::function<void(const Gl&, Log&)>& script) {
  Log ours, theirs;
  script(softgl_library(), ours);
  script(osmesa_library(), theirs);
  CHECK(ours.lines.size() == theirs.lines.size());
  for (size_t i = 0; i < ours.lines.size() && i < theirs.lines.size(); ++i)
    CHECK(ours.lines[i] == theirs.lines[i]);
}

unsigned sum_of(const std::vector<unsigned char>& bytes) {
  unsigned hash = 2166136261u;
  for (unsigned char b : bytes) hash = (hash ^ b) * 16777619u;
  return hash;
}

int integer(const Gl& gl, GLint pname) {
  GLint value = -1;
  gl.OSMesaGetIntegerv(pname, &value);
  return value;
}

} // namespace

TEST_CASE("Contexts are created for the formats and sizes that OSMesa accepts", "[abi]") {
  same_answers([](const Gl& gl, Log& log) {
    for (GLenum format : {GLenum(GL_COLOR_INDEX), GLenum(GL_RGBA), 1u, 2u, GLenum(GL_RGB), 4u, 5u, 0u, 3u, 6u,
                          GLenum(GL_LUMINANCE)}) {
      void* context = gl.OSMesaCreateContext(format, nullptr);
      log.add("format", format, context != nullptr);
      gl.OSMesaDestroyContext(context);
    }
    const int lists[][9] = {{0},
                            {0x22, GL_RGBA, 0},
                            {0x30, -1, 0},
                            {0x31, -1, 0},
                            {0x32, -1, 0},
                            {0x33, 0x35, 0},
                            {0x33, 0x99, 0},
                            {0x36, 1, 0x37, 5, 0},
                            {0x36, 0, 0},
                            {0x37, -1, 0},
                            {0x36, 5, 0},
                            {0x77, 1, 0},
                            {0x30, 16, 0x31, 8, 0x32, 16, 0x22, GL_RGB, 0}};
    for (const auto& list : lists) {
      void* context = gl.OSMesaCreateContextAttribs(list, nullptr);
      log.add("attributes", list[0], list[1], context != nullptr);
      gl.OSMesaDestroyContext(context);
    }
  });
}

TEST_CASE("MakeCurrent accepts the same formats and types", "[abi]") {
  same_answers([](const Gl& gl, Log& log) {
    std::vector<unsigned char> buffer(8 * 8 * 16);
    for (GLenum format : {GLenum(GL_COLOR_INDEX), GLenum(GL_RGBA), 1u, 2u, GLenum(GL_RGB), 4u, 5u})
      for (GLenum type :
           {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT, GL_UNSIGNED_SHORT_5_6_5, GL_BYTE, GL_DOUBLE, 0}) {
        void* context = gl.OSMesaCreateContext(format, nullptr);
        log.add(format, type, int(gl.OSMesaMakeCurrent(context, buffer.data(), type, 8, 8)));
        gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
        gl.OSMesaDestroyContext(context);
      }
    void* context = gl.OSMesaCreateContext(GL_RGBA, nullptr);
    log.add("no context", int(gl.OSMesaMakeCurrent(nullptr, buffer.data(), GL_UNSIGNED_BYTE, 8, 8)));
    log.add("no buffer", int(gl.OSMesaMakeCurrent(context, nullptr, GL_UNSIGNED_BYTE, 8, 8)));
    for (int size : {0, -1}) {
      log.add("width", size, int(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, size, 8)));
      log.add("height", size, int(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 8, size)));
    }
    log.add("current", gl.OSMesaGetCurrentContext() == nullptr);
    log.add("made", int(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 8, 8)),
            gl.OSMesaGetCurrentContext() == context);
    log.add("failed", int(gl.OSMesaMakeCurrent(context, nullptr, GL_UNSIGNED_BYTE, 8, 8)),
            gl.OSMesaGetCurrentContext() == context);
    log.add("unbound", int(gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0)),
            gl.OSMesaGetCurrentContext() == nullptr);
    gl.OSMesaDestroyContext(context);
  });
}

TEST_CASE("The caller's buffer is written at the same moments", "[abi]") {
  same_answers([](const Gl& gl, Log& log) {
    std::vector<unsigned char> a(16 * 16 * 4, 0x11), b(16 * 16 * 4, 0x22), c(20 * 20 * 4, 0x33);
    void* context = gl.OSMesaCreateContext(GL_RGBA, nullptr);
    gl.OSMesaMakeCurrent(context, a.data(), GL_UNSIGNED_BYTE, 16, 16);
    gl.Finish();
    log.add("finish of nothing", sum_of(a));
    gl.ClearColor(0.25f, 0.5f, 0.75f, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    log.add("cleared", sum_of(a));
    unsigned char pixel[4] = {};
    gl.ReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    log.add("read", int(pixel[0]), int(pixel[2]), sum_of(a));
    gl.Flush();
    log.add("flushed", sum_of(a));
    a.assign(a.size(), 0x44);
    gl.Finish();
    log.add("nothing new", sum_of(a));
    gl.ReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    gl.Finish();
    log.add("after a read", sum_of(a));
    gl.OSMesaMakeCurrent(context, b.data(), GL_UNSIGNED_BYTE, 16, 16);
    gl.Finish();
    log.add("other buffer, nothing new", sum_of(a), sum_of(b));
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(2, 3, 4, 5);
    gl.ClearColor(1, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Finish();
    log.add("other buffer keeps the contents", sum_of(b));
    gl.OSMesaMakeCurrent(context, c.data(), GL_UNSIGNED_BYTE, 20, 20);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Finish();
    log.add("larger buffer begins with zeros", sum_of(c));
    GLint viewport[4], scissor[4];
    gl.GetIntegerv(GL_VIEWPORT, viewport);
    gl.GetIntegerv(GL_SCISSOR_BOX, scissor);
    log.add("viewport", viewport[2], viewport[3], "scissor", scissor[2], scissor[3]);
    gl.ClearColor(0, 1, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    log.add("unbinding writes", sum_of(c));
    gl.OSMesaDestroyContext(context);
  });
}

TEST_CASE("A context that loses its thread to another writes its buffer", "[abi]") {
  same_answers([](const Gl& gl, Log& log) {
    std::vector<unsigned char> a(8 * 8 * 4), b(8 * 8 * 4);
    void* first = gl.OSMesaCreateContext(GL_RGBA, nullptr);
    void* second = gl.OSMesaCreateContext(1, first);
    gl.OSMesaMakeCurrent(first, a.data(), GL_UNSIGNED_BYTE, 8, 8);
    gl.ClearColor(1, 0.5f, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.OSMesaMakeCurrent(second, b.data(), GL_UNSIGNED_BYTE, 8, 8);
    log.add(sum_of(a), sum_of(b));
    gl.ClearColor(0, 0.5f, 1, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.OSMesaMakeCurrent(first, a.data(), GL_UNSIGNED_BYTE, 8, 8);
    log.add(sum_of(a), sum_of(b));
    GLfloat color[4];
    gl.GetFloatv(GL_COLOR_CLEAR_VALUE, color);
    log.add(color[0], color[1]);
    gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    gl.OSMesaDestroyContext(first);
    gl.OSMesaDestroyContext(second);
  });
}

TEST_CASE("A primitive that is open when its context loses its thread goes on afterwards", "[abi][lists]") {
  const Gl& gl = softgl_library();
  // The same picture whether another context is current for a while between two vertices or not.
  for (const bool compiled : {false, true}) {
    std::vector<unsigned char> picture[2];
    for (const bool leaves : {false, true}) {
      std::vector<unsigned char> a(64 * 64 * 4), b(64 * 64 * 4);
      void* first = gl.OSMesaCreateContext(GL_RGBA, nullptr);
      void* second = gl.OSMesaCreateContext(GL_RGBA, nullptr);
      gl.OSMesaMakeCurrent(first, a.data(), GL_UNSIGNED_BYTE, 64, 64);
      gl.Clear(
          GL_COLOR_BUFFER_BIT); // waits in the frame, whose memory is used anew when the context has left
      if (compiled) gl.NewList(1, GL_COMPILE_AND_EXECUTE);
      gl.Begin(GL_TRIANGLE_FAN);
      gl.Color3f(1, 0, 0);
      gl.Vertex2f(-0.9f, -0.8f);
      gl.Color3f(0, 1, 0);
      gl.Vertex2f(0.9f, -0.7f);
      if (leaves) {
        gl.OSMesaMakeCurrent(second, b.data(), GL_UNSIGNED_BYTE, 64, 64);
        gl.Begin(GL_POINTS);
        for (int i = 0; i < 100; ++i) gl.Vertex2f(float(i) / 100, 0);
        gl.End();
        gl.OSMesaMakeCurrent(first, a.data(), GL_UNSIGNED_BYTE, 64, 64);
      }
      gl.Color3f(0, 0, 1);
      for (int i = 0; i < 2000; ++i) {
        if (i == 1000) gl.FogCoordf(1); // all vertices get longer
        gl.Vertex2f(0.9f - float(i) / 1200, 0.9f - float(i % 3) / 10);
      }
      gl.End();
      if (compiled) gl.EndList();
      gl.Finish();
      CHECK(gl.GetError() == GL_NO_ERROR);
      picture[leaves] = a;
      gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
      gl.OSMesaDestroyContext(first);
      gl.OSMesaDestroyContext(second);
    }
    CHECK(sum_of(picture[0]) != sum_of(std::vector<unsigned char>(64 * 64 * 4)));
    CHECK(picture[0] == picture[1]);
  }
}

TEST_CASE("Destroying the current context leaves the buffer alone", "[abi]") {
  same_answers([](const Gl& gl, Log& log) {
    std::vector<unsigned char> buffer(8 * 8 * 4, 0x77);
    void* context = gl.OSMesaCreateContext(GL_RGBA, nullptr);
    gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 8, 8);
    gl.ClearColor(1, 1, 1, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.OSMesaDestroyContext(context);
    log.add(sum_of(buffer), gl.OSMesaGetCurrentContext() == nullptr);
  });
}

TEST_CASE("Rows of the buffer: every format, upside down and with gaps", "[abi]") {
  const struct {
    GLenum format, type;
    int bytes;
  } kinds[] = {{GL_RGBA, GL_UNSIGNED_BYTE, 4},
               {1, GL_UNSIGNED_BYTE, 4},
               {2, GL_UNSIGNED_BYTE, 4},
               {GL_RGB, GL_UNSIGNED_BYTE, 3},
               {5, GL_UNSIGNED_SHORT_5_6_5, 2},
               {GL_RGBA, GL_UNSIGNED_SHORT, 8},
               {1, GL_UNSIGNED_SHORT, 8},
               {2, GL_UNSIGNED_SHORT, 8},
               {GL_RGBA, GL_FLOAT, 16},
               {1, GL_FLOAT, 16},
               {2, GL_FLOAT, 16},
               {GL_RGB, GL_FLOAT, 12}};
  for (const auto& kind : kinds)
    for (int up : {0, 1})
      for (int row_length : {0, 70}) {
        INFO("format " << kind.format << " type " << kind.type << " up " << up << " row length "
                       << row_length);
        same_answers([&](const Gl& gl, Log& log) {
          std::vector<unsigned char> buffer(size_t(70) * 70 * size_t(kind.bytes), 0x5a);
          void* context = gl.OSMesaCreateContext(kind.format, nullptr);
          gl.OSMesaMakeCurrent(context, buffer.data(), kind.type, 67, 69);
          gl.OSMesaPixelStore(kOSMesaYUp, up);
          gl.OSMesaPixelStore(kOSMesaRowLength, row_length);
          gl.ClearColor(0.1f, 0.4f, 0.8f, 0.6f);
          gl.Clear(GL_COLOR_BUFFER_BIT);
          gl.Enable(GL_SCISSOR_TEST);
          // OSMesa draws into 3-byte pixels as if they had 4 bytes (reference/DEVIATIONS.md): only whole
          // clears agree.
          for (int i = 0; i < (kind.bytes == 3 ? 0 : 5); ++i) {
            gl.Scissor(7 * i - 3, 13 * i - 5, 20, 9);
            gl.ClearColor(0.2f * float(i), 1.0f - 0.15f * float(i), 0.3f, 0.1f * float(i));
            gl.Clear(GL_COLOR_BUFFER_BIT);
          }
          gl.Finish();
          log.add(sum_of(buffer));
          log.add(integer(gl, 0x20), integer(gl, 0x21), integer(gl, 0x22), integer(gl, 0x23),
                  integer(gl, 0x24), integer(gl, 0x25), integer(gl, 0x10), integer(gl, 0x11));
          gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
          gl.OSMesaDestroyContext(context);
        });
      }
}

TEST_CASE("An RGB buffer is the RGBA buffer without alpha", "[abi]") {
  const Gl& gl = softgl_library();
  constexpr int kWidth = 67, kHeight = 69;
  std::vector<unsigned char> pictures[2];
  for (int kind = 0; kind < 2; ++kind) {
    pictures[kind].resize(size_t(kWidth) * kHeight * 4);
    void* context = gl.OSMesaCreateContext(kind ? GL_RGB : GL_RGBA, nullptr);
    gl.OSMesaMakeCurrent(context, pictures[kind].data(), GL_UNSIGNED_BYTE, kWidth, kHeight);
    gl.Enable(GL_SCISSOR_TEST);
    for (int i = 0; i < 9; ++i) {
      gl.Scissor(7 * i - 3, 5 * i - 5, 20 + 3 * i, 29);
      gl.ColorMask(i != 3, i != 4, i != 5, GL_TRUE);
      gl.ClearColor(0.1f * float(i), 1.0f - 0.1f * float(i), 0.3f, 1);
      gl.Clear(GL_COLOR_BUFFER_BIT);
    }
    gl.Finish();
    unsigned char pixel[4];
    gl.ReadPixels(66, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel); // never written
    CHECK(int(pixel[3]) == (kind ? 255 : 0));
    gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    gl.OSMesaDestroyContext(context);
  }
  int wrong = 0;
  for (int i = 0; i < kWidth * kHeight; ++i)
    for (int k = 0; k < 3; ++k) wrong += pictures[0][size_t(4 * i + k)] != pictures[1][size_t(3 * i + k)];
  CHECK(wrong == 0);
}

TEST_CASE("The depth and color buffers can be had", "[abi]") {
  for (int depth : {24, 16, 32, 8, 0})
    for (int stencil : {8, 0}) {
      INFO("depth " << depth << " stencil " << stencil);
      same_answers([&](const Gl& gl, Log& log) {
        std::vector<unsigned char> buffer(30 * 20 * 4);
        void* context = gl.OSMesaCreateContextExt(GL_RGBA, depth, stencil, 0, nullptr);
        gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 30, 20);
        GLint bits = -1;
        gl.GetIntegerv(GL_DEPTH_BITS, &bits);
        log.add("depth bits", bits);
        gl.GetIntegerv(GL_STENCIL_BITS, &bits);
        log.add("stencil bits", bits);
        gl.ClearDepth(0.3);
        gl.ClearStencil(0x35);
        gl.Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        gl.Enable(GL_SCISSOR_TEST);
        gl.Scissor(4, 5, 10, 6);
        gl.ClearDepth(0.6);
        gl.Clear(GL_DEPTH_BUFFER_BIT);
        GLint width = -1, height = -1, bytes = -1, format = -1;
        void* data = nullptr;
        bool there = gl.OSMesaGetDepthBuffer(context, &width, &height, &bytes, &data);
        log.add("depth", there, width, height, bytes, data != nullptr);
        if (data) {
          std::vector<unsigned char> copy(size_t(width) * size_t(height) * size_t(bytes));
          std::memcpy(copy.data(), data, copy.size());
          log.add(sum_of(copy));
        }
        there = gl.OSMesaGetColorBuffer(context, &width, &height, &format, &data);
        log.add("color", there, width, height, format, data == buffer.data());
        gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
        gl.OSMesaDestroyContext(context);
      });
    }
}

TEST_CASE("Lists and textures are shared with the share list", "[abi]") {
  same_answers([](const Gl& gl, Log& log) {
    std::vector<unsigned char> buffer(8 * 8 * 4);
    void* first = gl.OSMesaCreateContext(GL_RGBA, nullptr);
    void* second = gl.OSMesaCreateContext(GL_RGBA, first);
    void* third = gl.OSMesaCreateContext(GL_RGBA, nullptr);
    gl.OSMesaMakeCurrent(first, buffer.data(), GL_UNSIGNED_BYTE, 8, 8);
    gl.NewList(5, GL_COMPILE);
    gl.ClearColor(1, 0, 1, 1);
    gl.EndList();
    gl.BindTexture(GL_TEXTURE_2D, 9);
    for (void* context : {first, second, third}) {
      gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 8, 8);
      gl.CallList(5);
      GLfloat color[4];
      gl.GetFloatv(GL_COLOR_CLEAR_VALUE, color);
      log.add(int(gl.IsList(5)), int(gl.IsTexture(9)), color[0], color[2]);
    }
    gl.OSMesaDestroyContext(first);
    gl.OSMesaMakeCurrent(second, buffer.data(), GL_UNSIGNED_BYTE, 8, 8);
    log.add(int(gl.IsList(5)));
    gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    gl.OSMesaDestroyContext(second);
    gl.OSMesaDestroyContext(third);
  });
}

TEST_CASE("Bad arguments of OSMesa functions are turned away", "[abi]") {
  const Gl& gl = softgl_library(); // OSMesa crashes on most of these
  GLint value = 5;
  gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
  gl.OSMesaGetIntegerv(0x22, &value);
  CHECK(value == 0);
  gl.OSMesaGetIntegerv(0x20, nullptr);
  gl.OSMesaPixelStore(kOSMesaYUp, 0);
  gl.OSMesaDestroyContext(nullptr);
  GLint w = 1, h = 1, b = 1;
  void* p = &w;
  CHECK_FALSE(gl.OSMesaGetDepthBuffer(nullptr, &w, &h, &b, &p));
  CHECK(p == nullptr);
  void* context = gl.OSMesaCreateContext(GL_RGBA, nullptr);
  CHECK_FALSE(gl.OSMesaGetDepthBuffer(context, &w, &h, &b, &p));
  CHECK_FALSE(gl.OSMesaGetColorBuffer(context, &w, &h, &b, nullptr));
  gl.OSMesaPostprocess(context, "pp_nored", 1);
  unsigned char byte = 0;
  CHECK_FALSE(gl.OSMesaMakeCurrent(context, &byte, GL_UNSIGNED_BYTE, 2147483647, 2147483647));
  CHECK(gl.OSMesaGetCurrentContext() == nullptr);
  gl.OSMesaDestroyContext(context);
}

TEST_CASE("The largest surface can be drawn to", "[abi][slow]") {
  const Gl& gl = softgl_library();
  void* context = gl.OSMesaCreateContext(GL_RGBA, nullptr);
  std::vector<unsigned char> buffer(size_t(16384) * 64 * 4);
  REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 16384, 64));
  gl.ClearColor(1, 1, 1, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Finish();
  CHECK(buffer.back() == 255);
  gl.OSMesaDestroyContext(context);
}
