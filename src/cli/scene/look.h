// How a picture looks beyond the model's own light: lines, points, background, ground.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "image/picture.h"

namespace softgl::cli {

struct Background {
  uint8_t color[3] = {0x2e, 0x33, 0x3a};
  bool transparent = false;
  std::optional<std::array<uint8_t, 3>> below; // a gradient from `color` at the top to this
  std::string file;                            // a picture that fills the frame
  std::shared_ptr<const Picture> picture;      // once it is read: RGB
};

enum class Edges { kNone, kAll, kSharp };

struct LineOptions {
  enum Style { kSurface, kWireframe, kPoints } style = kSurface;
  Edges edges = Edges::kNone;         // over the surface
  std::optional<double> edge_angle;   // degrees from which on an edge is sharp
  bool hidden = false;                // lines and points behind the surface are seen, too
  float width = 1.5f, point_size = 4; // in pixels of the finished picture
  std::optional<std::array<float, 3>> color;
};

} // namespace softgl::cli
