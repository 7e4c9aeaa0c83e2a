#include "support/runner.h"
#include "test_paths.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace softgl::test {

uint64_t Picture::hash() const {
  uint64_t h = 0xcbf29ce484222325u;
  auto add = [&](uint64_t value, int bytes) {
    for (int i = 0; i < bytes; i++) h = (h ^ ((value >> (8 * i)) & 255)) * 0x100000001b3u;
  };
  add(uint64_t(width), 4), add(uint64_t(height), 4);
  for (uint8_t c : color) add(c, 1);
  for (uint32_t d : depth) add(d, 4);
  for (uint8_t s : stencil) add(s, 1);
  for (float f : floats) add(std::bit_cast<uint32_t>(f), 4);
  for (GLenum e : errors) add(e, 4);
  return h;
}

static void choose_size(const Scene& scene, uint64_t seed, int& width, int& height) {
  static constexpr int kSizes[8][2] = {{160, 120}, {128, 128}, {160, 120}, {97, 61},
                                       {200, 131}, {64, 64},   {131, 200}, {257, 80}};
  width = scene.random ? kSizes[seed % 8][0] : scene.width;
  height = scene.random ? kSizes[seed % 8][1] : scene.height;
}

namespace {
/// A context that goes before the buffer it draws to, also when a scene throws.
struct CurrentContext {
  const Gl& gl;
  void* context;
  ~CurrentContext() {
    gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    gl.OSMesaDestroyContext(context);
  }
};
} // namespace

namespace {

/// Renderbuffers for colors, depths and stencil values instead of the window.
void bind_framebuffer_object(const Gl& gl, int width, int height) {
  GLuint framebuffer = 0, renderbuffer[2] = {};
  gl.GenFramebuffers(1, &framebuffer);
  gl.GenRenderbuffers(2, renderbuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const GLenum format[2] = {GL_RGBA8, GL_DEPTH24_STENCIL8},
               attachment[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_STENCIL_ATTACHMENT};
  for (int i = 0; i < 2; i++) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer[i]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, format[i], width, height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment[i], GL_RENDERBUFFER, renderbuffer[i]);
  }
}

/// The renderbuffers' pixels in place of the window's.
void read_framebuffer_object(const Gl& gl, Picture& p) {
  const size_t pixels = size_t(p.width) * size_t(p.height);
  gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
  gl.PushAttrib(GL_PIXEL_MODE_BIT);
  for (GLenum pname :
       {GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS})
    gl.PixelStorei(pname, 0);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  for (GLenum pname : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE})
    gl.PixelTransferf(pname, 1);
  for (GLenum pname : {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS, GL_MAP_COLOR,
                       GL_MAP_STENCIL, GL_INDEX_SHIFT, GL_INDEX_OFFSET})
    gl.PixelTransferf(pname, 0);
  gl.ReadPixels(0, 0, p.width, p.height, GL_RGBA, GL_UNSIGNED_BYTE, p.color.data());
  std::vector<uint32_t> raw(pixels);
  gl.ReadPixels(0, 0, p.width, p.height, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, raw.data());
  p.depth.resize(pixels), p.stencil.resize(pixels);
  for (size_t i = 0; i < pixels; i++) p.depth[i] = raw[i] >> 8, p.stencil[i] = uint8_t(raw[i]);
  gl.PopAttrib();
  gl.PopClientAttrib();
}

} // namespace

Picture draw(const Gl& gl, const Scene& scene, uint64_t seed) {
  Picture p;
  choose_size(scene, seed, p.width, p.height);
  void* context = gl.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, scene.accumulation ? 16 : 0, nullptr);
  if (!context) throw std::runtime_error(gl.name + ": OSMesaCreateContextExt failed");
  const size_t pixels = size_t(p.width) * p.height;
  p.color.assign(pixels * 4, 0);
  if (scene.floats) p.floats.assign(pixels * 4, 0);
  const CurrentContext current{gl, context};
  void* colors = scene.floats ? static_cast<void*>(p.floats.data()) : p.color.data();
  if (!gl.OSMesaMakeCurrent(context, colors, scene.floats ? GL_FLOAT : GL_UNSIGNED_BYTE, p.width, p.height))
    throw std::runtime_error(gl.name + ": OSMesaMakeCurrent failed");
  uint64_t name = 0xcbf29ce484222325u; // every family draws something else for one seed
  for (char c : scene.numbers.empty() ? scene.name : scene.numbers)
    name = (name ^ uint8_t(c)) * 0x100000001b3u;
  Random random(seed * 1000003u + name);
  Stage stage{gl, random, p.width, p.height};
  if (scene.framebuffer_object) bind_framebuffer_object(gl, p.width, p.height);
  scene.draw(stage);
  for (int i = 0; i < 100; i++) {
    GLenum error = gl.GetError();
    if (!error) break;
    p.errors.push_back(error);
  }
  gl.Finish();
  if (scene.framebuffer_object) {
    read_framebuffer_object(gl, p);
    return p;
  }
  for (size_t i = 0; i < p.floats.size(); i++)
    p.color[i] = p.floats[i] > 0 ? uint8_t(std::min(p.floats[i], 1.0f) * 255 + 0.5f) : 0;
  GLint w = 0, h = 0, bytes = 0;
  void* buffer = nullptr;
  if (gl.OSMesaGetDepthBuffer(context, &w, &h, &bytes, &buffer) && bytes == 4 && w == p.width &&
      h == p.height) {
    std::vector<uint32_t> raw(pixels);
    std::memcpy(raw.data(), buffer, pixels * 4);
    p.depth.resize(pixels), p.stencil.resize(pixels);
    for (size_t i = 0; i < pixels; i++) p.depth[i] = raw[i] & 0xffffff, p.stencil[i] = uint8_t(raw[i] >> 24);
  }
  return p;
}

Difference compare(const Picture& ours, const Picture& theirs) {
  Difference d;
  char line[400];
  if (ours.width != theirs.width || ours.height != theirs.height ||
      ours.depth.size() != theirs.depth.size() || ours.floats.size() != theirs.floats.size()) {
    d.size = true;
    d.text = "no depth buffer, or another size";
    return d;
  }
  d.errors = ours.errors != theirs.errors;
  for (int y = 0; y < ours.height; y++)
    for (int x = 0; x < ours.width; x++) {
      const size_t i = size_t(y) * ours.width + x;
      bool differs = false;
      for (size_t c = 4 * i; c < 4 * i + 4; c++)
        if (ours.color[c] != theirs.color[c]) {
          differs = true, d.color_bytes++;
          d.max_color = std::max(d.max_color, std::abs(ours.color[c] - theirs.color[c]));
        }
      for (size_t c = 4 * i; c < 4 * i + 4 && !ours.floats.empty(); c++)
        if (std::bit_cast<uint32_t>(ours.floats[c]) != std::bit_cast<uint32_t>(theirs.floats[c]))
          differs = true, d.floats++;
      if (ours.depth.size() && ours.depth[i] != theirs.depth[i]) differs = true, d.depth_values++;
      if (ours.stencil.size() && ours.stencil[i] != theirs.stencil[i]) differs = true, d.stencil_values++;
      if (differs && d.x < 0) d.x = x, d.y = y;
    }
  if (d.x >= 0) {
    const size_t i = size_t(d.y) * ours.width + d.x;
    std::snprintf(line, sizeof line,
                  "%zu color bytes (largest by %d), %zu depths, %zu stencils differ; first at (%d,%d): ours "
                  "%02x%02x%02x%02x z %06x, "
                  "theirs %02x%02x%02x%02x z %06x",
                  d.color_bytes, d.max_color, d.depth_values, d.stencil_values, d.x, d.y, ours.color[4 * i],
                  ours.color[4 * i + 1], ours.color[4 * i + 2], ours.color[4 * i + 3],
                  ours.depth.empty() ? 0 : ours.depth[i], theirs.color[4 * i], theirs.color[4 * i + 1],
                  theirs.color[4 * i + 2], theirs.color[4 * i + 3],
                  theirs.depth.empty() ? 0 : theirs.depth[i]);
    d.text = line;
  }
  if (d.floats) {
    const float* a = &ours.floats[4 * (size_t(d.y) * ours.width + d.x)];
    const float* b = &theirs.floats[4 * (size_t(d.y) * ours.width + d.x)];
    std::snprintf(line, sizeof line, "; %zu floats: ours %.9g %.9g %.9g %.9g, theirs %.9g %.9g %.9g %.9g",
                  d.floats, double(a[0]), double(a[1]), double(a[2]), double(a[3]), double(b[0]),
                  double(b[1]), double(b[2]), double(b[3]));
    d.text += line;
  }
  if (d.errors) {
    auto list = [](const std::vector<GLenum>& errors) {
      std::string s;
      char hex[16];
      for (GLenum e : errors) std::snprintf(hex, sizeof hex, " %04x", e), s += hex;
      return s.empty() ? std::string(" none") : s;
    };
    d.text += (d.text.empty() ? "GL errors: ours" : "; GL errors: ours") + list(ours.errors) + ", theirs" +
              list(theirs.errors);
  }
  return d;
}

std::vector<uint8_t> encode_png(int width, int height, std::vector<uint8_t> rgba) {
  for (size_t i = 3; i < rgba.size(); i += 4) rgba[i] = 255;
  std::vector<uint8_t> png;
  stbi_flip_vertically_on_write(1);
  stbi_write_png_to_func(
      [](void* to, void* data, int size) {
        const auto* first = static_cast<const uint8_t*>(data);
        auto* bytes = static_cast<std::vector<uint8_t>*>(to);
        bytes->insert(bytes->end(), first, first + size);
      },
      &png, width, height, 4, rgba.data(), 4 * width);
  return png;
}

void write_png(const std::string& path, int width, int height, const std::vector<uint8_t>& rgba) {
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  const std::vector<uint8_t> png = encode_png(width, height, rgba);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
}

void write_difference(const std::string& stem, const Picture& ours, const Picture& theirs) {
  write_png(stem + ".ours.png", ours.width, ours.height, ours.color);
  write_png(stem + ".theirs.png", theirs.width, theirs.height, theirs.color);
  if (ours.color.size() != theirs.color.size()) return;
  std::vector<uint8_t> difference(ours.color.size());
  for (size_t i = 0; i < difference.size(); i++)
    difference[i] = ours.color[i] == theirs.color[i]
                        ? 0
                        : uint8_t(std::min(255, 95 + 16 * std::abs(ours.color[i] - theirs.color[i])));
  // A pixel whose alpha or depth alone differs is grey.
  for (size_t i = 0; i < difference.size() / 4; i++) {
    const bool depth = ours.depth.size() > i && theirs.depth.size() > i && ours.depth[i] != theirs.depth[i];
    if (!difference[4 * i] && !difference[4 * i + 1] && !difference[4 * i + 2] &&
        (difference[4 * i + 3] || depth))
      difference[4 * i] = difference[4 * i + 1] = difference[4 * i + 2] = 128;
  }
  write_png(stem + ".difference.png", ours.width, ours.height, difference);
}

std::string check_against_osmesa(const Scene& scene, uint64_t seed) {
  const Picture ours = draw(softgl_library(), scene, seed), theirs = draw(osmesa_library(), scene, seed);
  const Difference d = compare(ours, theirs);
  if (!d.any()) return {};
  const std::string stem = std::string(SOFTGL_TEST_OUTPUT) + "/" + scene.name + "-" + std::to_string(seed);
  if (!d.size) write_difference(stem, ours, theirs);
  return d.text + "\n  pictures: " + stem +
         ".{ours,theirs,difference}.png\n  again: " + SOFTGL_TEST_BINARY_DIR +
         "/softgl_conformance --family " + scene.name + " --seed " + std::to_string(seed) +
         (scene.floats ? " --floats" : "") + " --minimize";
}

} // namespace softgl::test
