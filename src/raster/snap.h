// Window coordinates in 1/256 of a pixel.
#pragma once

#include <cstdint>

namespace softgl {

/// To nearest, halves away from 0, as OSMesa 22.3.6 snaps the corners of lines and points.
inline int32_t snap(float x) {
  const float f = 256.0f * x;
  return static_cast<int32_t>(f >= 0.0f ? f + 0.5f : f - 0.5f);
}

} // namespace softgl
