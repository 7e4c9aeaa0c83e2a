// Several contexts: in a thread, one after another in several threads, sharing objects, and with buffers of
// changing size. softgl is asked, and OSMesa with the same script.
#include <catch2/catch.hpp>

#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "support/gl.h"

using namespace softgl::test;

namespace {

using Bytes = std::vector<unsigned char>;

/// What the script returns must be the same of both libraries, and not empty.
void same_bytes(const std::function<Bytes(const Gl&)>& script) {
  const Bytes ours = script(softgl_library());
  REQUIRE_FALSE(ours.empty());
  CHECK((ours == script(osmesa_library())));
}

/// A context and the memory it draws to.
struct Window {
  Window(const Gl& gl, int width, int height, const Window* share = nullptr)
      : gl(gl), context(gl.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, 0, share ? share->context : nullptr)) {
    if (!context) throw std::runtime_error("no context"); // threads may not ask Catch
    resize(width, height);
  }
  ~Window() {
    if (context) gl.OSMesaDestroyContext(context);
  }
  void resize(int new_width, int new_height) {
    width = new_width, height = new_height;
    pixels.assign(size_t(width) * size_t(height) * 4, 77);
  }
  bool make_current() {
    return gl.OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, width, height);
  }

  const Gl& gl;
  void* context;
  int width = 0, height = 0;
  Bytes pixels;
};

void release(const Gl& gl) { gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0); }

void triangle(const Gl& gl, float depth) {
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3; ++i) {
    gl.TexCoord2f(i == 1 ? 2.0f : 0.0f, i == 2 ? 2.0f : 0.0f);
    gl.Vertex3f(i == 1 ? 1.0f : -1.0f, i == 2 ? 1.0f : -1.0f, depth);
  }
  gl.End();
}

/// Four by four texels of many colors, as the bound texture.
void checkered_texture(const Gl& gl) {
  Bytes texels(4 * 4 * 4);
  for (size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<unsigned char>(i * 37);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
}

} // namespace

TEST_CASE("Contexts of one thread take turns", "[abi][contexts]") {
  same_bytes([](const Gl& gl) {
    Window a(gl, 40, 30), b(gl, 30, 40), c(gl, 40, 30);
    Bytes all;
    for (int turn = 0; turn < 6; ++turn)
      for (Window* window : {&a, &b, &c}) {
        REQUIRE(window->make_current());
        gl.Enable(GL_DEPTH_TEST);
        if (turn == 0) gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl.Rotatef(window == &b ? 30.0f : -20.0f, 0, 0, 1);
        gl.Color3f(float(turn) / 5, window == &c ? 1.0f : 0.0f, 0.5f);
        triangle(gl, 0.5f - float(turn) / 10);
      }
    for (Window* window : {&a, &b, &c}) {
      REQUIRE(window->make_current());
      gl.Finish();
      all.insert(all.end(), window->pixels.begin(), window->pixels.end());
    }
    release(gl);
    return all;
  });
}

TEST_CASE("A context goes on in another thread where it was left", "[abi][contexts]") {
  same_bytes([](const Gl& gl) {
    Window window(gl, 40, 30);
    bool current = true;
    for (int turn = 0; turn < 6; ++turn)
      std::thread([&] {
        if (!window.make_current()) current = false;
        if (turn == 0) {
          gl.Enable(GL_DEPTH_TEST);
          gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        }
        gl.Color3f(float(turn) / 5, 1.0f - float(turn) / 5, 0.5f);
        gl.Rotatef(25, 0, 0, 1);
        triangle(gl, 0.5f - float(turn) / 10);
        release(gl);
      }).join();
    REQUIRE(current);
    return window.pixels;
  });
}

TEST_CASE("A context may leave its thread between glBegin and glEnd, with any number of vertices",
          "[abi][contexts]") {
  const Gl& gl = softgl_library();
  const auto drawn = [&](int leave_at) {
    Window window(gl, 40, 30);
    REQUIRE(window.make_current());
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Begin(GL_TRIANGLE_FAN);
    for (int i = 0; i <= 5; ++i) {
      if (i == leave_at) {
        release(gl);
        REQUIRE(window.make_current());
      }
      if (i == 5) break;
      gl.Color3f(float(i) / 4, 1 - float(i) / 4, 0.5f);
      gl.Vertex2f(i == 2 || i == 3 ? 0.9f : -0.9f, i == 3 || i == 4 ? 0.9f : -0.9f);
    }
    gl.End();
    CHECK(gl.GetError() == GL_NO_ERROR);
    gl.Finish();
    release(gl);
    return window.pixels;
  };
  const Bytes whole = drawn(-1);
  CHECK(whole != Bytes(whole.size(), 0));
  for (int leave_at = 0; leave_at <= 5; ++leave_at) CHECK((drawn(leave_at) == whole));
}

TEST_CASE("A context may lose its window to one of another size", "[abi][contexts]") {
  same_bytes([](const Gl& gl) {
    Window window(gl, 40, 30);
    Bytes all;
    const int sizes[][2] = {{40, 30}, {200, 100}, {1, 1}, {64, 64}, {65, 63}, {3, 300}};
    for (const auto& size : sizes) {
      window.resize(size[0], size[1]);
      REQUIRE(window.make_current());
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      triangle(gl, 0); // the viewport is that of the first window
      gl.Viewport(0, 0, size[0], size[1]);
      gl.Rotatef(70, 0, 0, 1);
      triangle(gl, 0.1f);
      gl.Finish();
      all.insert(all.end(), window.pixels.begin(), window.pixels.end());
    }
    release(gl);
    return all;
  });
}

TEST_CASE("A texture outlives the context that made it, while another one uses it", "[abi][contexts]") {
  same_bytes([](const Gl& gl) {
    Window first(gl, 16, 16), second(gl, 40, 30, &first);
    REQUIRE(first.make_current());
    gl.BindTexture(GL_TEXTURE_2D, 5);
    checkered_texture(gl);
    gl.NewList(7, GL_COMPILE);
    triangle(gl, 0);
    gl.EndList();
    REQUIRE(second.make_current());
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Enable(GL_TEXTURE_2D);
    gl.BindTexture(GL_TEXTURE_2D, 5);
    triangle(gl, 0); // waits in the frame while the context dies
    std::thread([&] {
      gl.OSMesaDestroyContext(first.context);
      first.context = nullptr;
    }).join();
    gl.Rotatef(120, 0, 0, 1);
    gl.CallList(7);
    // Its last binding goes: the texels must live until they are drawn.
    const GLuint name = 5;
    gl.DeleteTextures(1, &name);
    gl.Rotatef(120, 0, 0, 1);
    triangle(gl, 0);
    gl.Finish();
    release(gl);
    return second.pixels;
  });
}

TEST_CASE("A texture that one context deletes stays bound in another one", "[abi][contexts]") {
  // GL 1.5, 3.8.12: it is unbound where it is deleted, as though BindTexture had been executed there.
  same_bytes([](const Gl& gl) {
    Window first(gl, 40, 30), second(gl, 40, 30, &first);
    first.make_current();
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Enable(GL_TEXTURE_2D);
    gl.BindTexture(GL_TEXTURE_2D, 5);
    checkered_texture(gl);
    triangle(gl, 0); // waits, and has the texture
    second.make_current();
    const GLuint name = 5;
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.DeleteTextures(1, &name);
    CHECK(gl.IsTexture(5) == GL_FALSE);
    GLint bound = -1;
    gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    CHECK(bound == 0);
    gl.BindTexture(GL_TEXTURE_2D, name); // another texture
    first.make_current();
    gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    CHECK(bound == 5);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.Rotatef(180, 0, 0, 1);
    triangle(gl, 0);
    gl.Finish();
    Bytes seen = first.pixels;
    gl.BindTexture(GL_TEXTURE_2D, name); // the new one, which has no image
    gl.Rotatef(90, 0, 0, 1);
    triangle(gl, -0.5f);
    gl.Finish();
    seen.insert(seen.end(), first.pixels.begin(), first.pixels.end());
    release(gl);
    return seen;
  });
}

TEST_CASE("Many contexts draw in many threads at the same time", "[abi][contexts]") {
  const Gl& gl = softgl_library();
  const auto picture = [&gl](int seed) {
    Window window(gl, 150, 130);
    if (!window.make_current()) return Bytes{};
    for (int i = 0; i < 20; ++i) {
      gl.Color3f(float((seed + i) % 7) / 6, float(i % 3) / 2, float(seed) / 8);
      gl.Rotatef(float(17 + seed), 0, 0, 1);
      triangle(gl, 0);
      if (i % 5 == 0) gl.Finish();
    }
    release(gl);
    return window.pixels;
  };
  constexpr int kThreads = 8;
  Bytes alone[kThreads], together[kThreads];
  for (int i = 0; i < kThreads; ++i) alone[i] = picture(i);
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) threads.emplace_back([&, i] { together[i] = picture(i); });
  for (std::thread& thread : threads) thread.join();
  for (int i = 0; i < kThreads; ++i) CHECK((alone[i] == together[i]));
}

TEST_CASE("The depths of a buffer that became narrower have its width", "[abi][deviation]") {
  const Gl& gl = softgl_library();
  Window window(gl, 64, 8);
  REQUIRE(window.make_current());
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Finish();
  window.resize(20, 8);
  REQUIRE(window.make_current());
  gl.Enable(GL_SCISSOR_TEST);
  for (int y = 0; y < 8; ++y) {
    gl.Scissor(0, y, 20, 1);
    gl.ClearDepth(y / 8.0);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
  }
  gl.Finish();
  GLint width = 0, height = 0, bytes = 0;
  void* data = nullptr;
  REQUIRE(gl.OSMesaGetDepthBuffer(window.context, &width, &height, &bytes, &data));
  REQUIRE(std::vector<GLint>{width, height, bytes} == std::vector<GLint>{20, 8, 4});
  for (int i = 0; i < 20 * 8; ++i) {
    INFO("value " << i);
    REQUIRE((static_cast<const GLuint*>(data)[i] + 8) >> 21 == GLuint(i / 20)); // 24 bits
  }
  release(gl);
}
