// Contexts whose image has several samples a pixel (SOFTGL_SAMPLES).
#include <catch2/catch.hpp>
#include <softgl/softgl.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "support/gl.h"

using namespace softgl::test;

namespace {

constexpr int kWidth = 70, kHeight = 40; // two tiles
constexpr GLenum kRgba = GL_RGBA, kDepthBits = 0x30, kStencilBits = 0x31, kAccumulationBits = 0x32;

struct Window {
  const Gl& gl = softgl_library();
  void* context;
  GLenum type;
  std::vector<uint8_t> buffer;
  explicit Window(int samples, GLenum buffer_type = GL_UNSIGNED_BYTE)
      : type(buffer_type), buffer(size_t(kWidth) * kHeight * 16) {
    const int attributes[] = {0x22, int(kRgba),     kDepthBits, 24, kStencilBits, 8, kAccumulationBits,
                              16,   SOFTGL_SAMPLES, samples,    0};
    context = gl.OSMesaCreateContextAttribs(attributes, nullptr);
    if (context) REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), type, kWidth, kHeight));
  }
  ~Window() {
    gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    if (context) gl.OSMesaDestroyContext(context);
  }
  Window(const Window&) = delete;
  /// A white slope on black, whose edges cut pixels in all ways.
  void draw() const {
    gl.ClearColor(0, 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Enable(GL_DEPTH_TEST);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex2f(-0.9f, -0.8f), gl.Vertex2f(0.95f, -0.3f), gl.Vertex2f(0.1f, 0.9f);
    gl.End();
  }
  std::vector<uint8_t> read() const {
    std::vector<uint8_t> pixels(size_t(kWidth) * kHeight * 4);
    gl.ReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  }
  static int grays(const std::vector<uint8_t>& pixels) {
    int count = 0;
    for (size_t i = 0; i < pixels.size(); i += 4) count += pixels[i] != 0 && pixels[i] != 255;
    return count;
  }
  GLint get(GLenum pname) const {
    GLint value = -1;
    gl.GetIntegerv(pname, &value);
    return value;
  }
};

} // namespace

TEST_CASE("The picture of a context with samples has smooth edges", "[abi][multisample]") {
  std::vector<uint8_t> seen;
  {
    const Window window(4);
    REQUIRE(window.context);
    CHECK(window.get(GL_SAMPLES) == 4);
    CHECK(window.get(GL_SAMPLE_BUFFERS) == 1);
    window.draw();
    seen = window.read();
    CHECK(Window::grays(seen) > 50);
    window.gl.Finish();
    CHECK(std::equal(seen.begin(), seen.end(), window.buffer.begin()));
    // What is drawn later is read and shown, too.
    window.gl.Disable(GL_MULTISAMPLE);
    window.draw();
    CHECK(Window::grays(window.read()) == 0);
    window.gl.Finish();
    CHECK(std::equal(seen.begin(), seen.end(), window.buffer.begin()) == false);
    // Read back and drawn again, and copied in place, it stays what it is.
    window.gl.Enable(GL_MULTISAMPLE);
    window.gl.Disable(GL_DEPTH_TEST);
    window.gl.WindowPos2i(0, 0);
    window.gl.DrawPixels(kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, seen.data());
    CHECK(window.read() == seen);
    window.gl.CopyPixels(0, 0, kWidth, kHeight, GL_COLOR);
    CHECK(window.read() == seen);
    GLuint depth[2] = {};
    window.gl.Clear(GL_DEPTH_BUFFER_BIT);
    window.gl.ReadPixels(0, 0, 2, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth);
    CHECK((depth[0] == ~0u && depth[1] == ~0u));
    window.gl.Accum(GL_LOAD, 1);
    window.gl.Clear(GL_COLOR_BUFFER_BIT);
    window.gl.Accum(GL_RETURN, 1);
    CHECK(window.read() == seen);
    // Another size.
    std::vector<uint8_t> small(4 * 4 * 4, 1);
    REQUIRE(window.gl.OSMesaMakeCurrent(window.context, small.data(), GL_UNSIGNED_BYTE, 4, 4));
    window.gl.Clear(GL_COLOR_BUFFER_BIT);
    window.gl.Finish();
    CHECK((small[0] == 0 && small[63] == 255));
    CHECK(window.gl.GetError() == GL_NO_ERROR);
  }
  setenv("SOFTGL_SAMPLES", "4", 1);
  void* context = softgl_library().OSMesaCreateContextExt(kRgba, 24, 8, 0, nullptr);
  unsetenv("SOFTGL_SAMPLES");
  std::vector<uint8_t> buffer(seen.size());
  REQUIRE(softgl_library().OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, kWidth, kHeight));
  GLint samples = 0;
  softgl_library().GetIntegerv(GL_SAMPLES, &samples);
  CHECK(samples == 4);
  softgl_library().OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
  softgl_library().OSMesaDestroyContext(context);
}

TEST_CASE("Pictures of all types are averaged", "[abi][multisample]") {
  std::vector<uint8_t> bytes;
  for (GLenum type : {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT}) {
    const Window window(4, type);
    REQUIRE(window.context);
    window.draw();
    window.gl.Finish();
    const std::vector<uint8_t> pixels = window.read();
    if (bytes.empty()) bytes = pixels;
    int far = 0;
    for (size_t i = 0; i < bytes.size(); ++i) far += std::abs(int(bytes[i]) - int(pixels[i])) > 1;
    CHECK(far == 0);
    CHECK(Window::grays(pixels) > 50);
  }
}

TEST_CASE("Contexts have one sample or four", "[abi][multisample]") {
  CHECK(Window(0).get(GL_SAMPLES) == 0);
  for (int wrong : {-1, 1, 2, 5, 16}) CHECK(Window(wrong).context == nullptr);
}
