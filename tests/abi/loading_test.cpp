// Loading, unloading, forking, threads.
#include <catch2/catch.hpp>

#include <dlfcn.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "support/gl.h"
#include "test_paths.h"

using namespace softgl::test;

namespace {

constexpr int kSize = 600; // large enough that worker threads take part

/// Clears to `red` and draws a white triangle; the sum of all bytes.
unsigned long draw_something(const Gl& gl, float red) {
  std::vector<unsigned char> buffer(size_t(kSize) * kSize * 4);
  void* context = gl.OSMesaCreateContext(kOSMesaRgba, nullptr);
  if (!context || !gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, kSize, kSize)) return 0;
  gl.ClearColor(red, 0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3; ++i) gl.Vertex2f(i == 1 ? 1.0f : -1.0f, i == 2 ? 1.0f : -1.0f);
  gl.End();
  gl.Finish();
  gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl.OSMesaDestroyContext(context);
  unsigned long sum = 0;
  for (unsigned char byte : buffer) sum += byte;
  return sum;
}

/// What a process holds.
struct Footprint {
  long threads = 0, mappings = 0, resident_pages = 0;
};
Footprint footprint() {
  Footprint f;
  for ([[maybe_unused]] const auto& thread : std::filesystem::directory_iterator("/proc/self/task"))
    ++f.threads;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) ++f.mappings;
  long size = 0;
  std::ifstream("/proc/self/statm") >> size >> f.resident_pages;
  return f;
}

template <class Function> bool succeeds_in_child(const Function& function) {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) _exit(function() ? 0 : 1);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Whether a child, and a child of that one after it has drawn, draw the picture whose bytes have this sum.
bool same_in_child(const Gl& gl, unsigned long expected) {
  return succeeds_in_child([&] {
    if (draw_something(gl, 0.25f) != expected) return false;
    return succeeds_in_child([&] { return draw_something(gl, 0.25f) == expected; });
  });
}

} // namespace

TEST_CASE("The library can be loaded and unloaded a hundred times", "[abi]") {
  const std::string path = softgl_library().path;
  const unsigned long expected = draw_something(softgl_library(), 0.5f);
  CHECK(expected > 0);
  const auto load_and_unload = [&](int times) {
    for (int i = 0; i < times; ++i) {
      const Gl gl = load_gl("softgl", path);
      CHECK(draw_something(gl, 0.5f) == expected);
      void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_NOLOAD);
      REQUIRE(handle);
      dlclose(handle);
      dlclose(handle); // the one of load_gl
    }
  };
  load_and_unload(20);
  const Footprint before = footprint();
  load_and_unload(80);
  const Footprint after = footprint();
  CHECK(after.threads == before.threads);
  CHECK(after.mappings <= before.mappings + 8);
#ifndef SOFTGL_ADDRESS_SANITIZER                              // which keeps what is freed
  CHECK(after.resident_pages <= before.resident_pages + 256); // a leak of a window is 350 pages a time
#endif
}

TEST_CASE("A forked child draws the same picture", "[abi]") {
  const Gl& gl = softgl_library();
  const unsigned long expected = draw_something(gl, 0.25f);
  CHECK(same_in_child(gl, expected));
  // A copy of the library, whose threads have not started yet. Its children have children.
  const std::string copy = SOFTGL_TEST_OUTPUT "/libOSMesa_copy.so";
  std::filesystem::create_directories(SOFTGL_TEST_OUTPUT);
  std::filesystem::copy_file(gl.path, copy, std::filesystem::copy_options::overwrite_existing);
  const Gl fresh = load_gl("softgl", copy);
  CHECK(same_in_child(fresh, expected));
  CHECK(draw_something(fresh, 0.25f) == expected);
  CHECK(same_in_child(fresh, expected));
}

TEST_CASE("A context goes on in a forked child, and in its parent", "[abi]") {
  const Gl& gl = softgl_library();
  std::vector<unsigned char> buffer(size_t(kSize) * kSize * 4);
  void* context = gl.OSMesaCreateContext(kOSMesaRgba, nullptr);
  REQUIRE(context);
  REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, kSize, kSize));
  gl.ClearColor(0, 0, 1, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Rectf(-1, -1, 0, 0); // waits
  const auto is_right = [&] {
    gl.Rectf(0, 0, 1, 1);
    gl.Finish();
    const size_t quarter = kSize / 4, row = size_t(kSize);
    const auto red = [&](size_t x, size_t y) { return buffer[(y * row + x) * 4]; };
    return red(quarter, quarter) == 255 && red(3 * quarter, 3 * quarter) == 255 &&
           red(quarter, 3 * quarter) == 0;
  };
  CHECK(succeeds_in_child(is_right));
  CHECK(is_right());
  gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl.OSMesaDestroyContext(context);
}

TEST_CASE("Every thread has a current context of its own", "[abi]") {
  const Gl& gl = softgl_library();
  const unsigned long dark = draw_something(gl, 0.0f), bright = draw_something(gl, 1.0f);
  REQUIRE(dark != bright);
  int wrong[4] = {};
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&gl, &wrong, t, dark, bright] {
      for (int i = 0; i < 5; ++i) {
        if (gl.OSMesaGetCurrentContext() != nullptr) ++wrong[t];
        if (draw_something(gl, t % 2 ? 1.0f : 0.0f) != (t % 2 ? bright : dark)) ++wrong[t];
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (int t = 0; t < 4; ++t) CHECK(wrong[t] == 0);
}

TEST_CASE("Calls without a context do nothing", "[abi]") {
  const Gl& gl = softgl_library();
  std::thread([&gl] {
    gl.ClearColor(1, 1, 1, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Begin(GL_TRIANGLES);
    gl.Color3f(1, 0, 0);
    for (int i = 0; i < 100000; ++i) gl.Vertex3f(float(i), 0, 0);
    gl.End();
    gl.Enable(GL_LIGHTING);
    gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, nullptr);
    gl.NewList(1, GL_COMPILE);
    gl.EndList();
    gl.CallList(1);
    gl.Finish();
    GLint value = 77;
    gl.GetIntegerv(GL_MAX_LIGHTS, &value);
    unsigned char pixel[4] = {1, 2, 3, 4};
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    if (gl.GetError() != GL_NO_ERROR || gl.GetString(GL_VERSION) != nullptr || value != 77 || pixel[0] != 1)
      abort();
  }).join();
  SUCCEED();
}
