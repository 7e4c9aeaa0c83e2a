// Draws scenes with a library and compares what two libraries have drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "support/scene.h"

namespace softgl::test {

/// What a scene left: colors as in the caller's buffer, depth values (24 bits), the GL errors it raised.
struct Picture {
  int width = 0, height = 0;
  std::vector<uint8_t> color;  // RGBA, row 0 at the bottom
  std::vector<float> floats;   // the same of a scene that is drawn to floats; color has them rounded
  std::vector<uint32_t> depth; // 0 .. 2^24-1, row 0 at the bottom
  std::vector<uint8_t> stencil;
  std::vector<GLenum> errors;

  /// FNV-1a over size, colors, depths, stencils, floats and errors.
  uint64_t hash() const;
};

/// Draws in a context of its own. Throws std::runtime_error when the library makes no context.
Picture draw(const Gl& gl, const Scene& scene, uint64_t seed);

/// How two pictures of one scene differ.
struct Difference {
  size_t color_bytes = 0, floats = 0, depth_values = 0, stencil_values = 0;
  int max_color = 0; // largest difference of a color byte
  bool errors = false, size = false;
  int x = -1, y = -1; // the first pixel that differs (y up)
  bool any() const { return color_bytes || floats || depth_values || stencil_values || errors || size; }
  std::string text; // one line for people
};
Difference compare(const Picture& ours, const Picture& theirs);

/// Draws with softgl and OSMesa; on a difference writes PNG files to the output folder and returns a message
/// with the command that repeats it. Empty: same bytes.
std::string check_against_osmesa(const Scene& scene, uint64_t seed);

/// PNG with row 0 at the bottom, opaque: alpha is compared, not shown.
std::vector<uint8_t> encode_png(int width, int height, std::vector<uint8_t> rgba);
void write_png(const std::string& path, int width, int height, const std::vector<uint8_t>& rgba);
/// Ours, theirs, and the amplified difference of colors; depths alike.
void write_difference(const std::string& stem, const Picture& ours, const Picture& theirs);

} // namespace softgl::test
