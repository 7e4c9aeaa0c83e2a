// The accumulation buffer (GL 1.5, 4.2.4): four signed numbers of 16 bits a pixel, 32767 for 1.
#pragma once

#include <cstdint>

#include "shaders/common/surface.h"

namespace softgl {

enum class AccumulationOperation : uint8_t { Accumulate, Load, Return, Multiply, Add, Clear };

struct Accumulation {
  AccumulationOperation operation;
  float value;            // of glAccum
  int16_t clear_value[4]; // Clear: red, green, blue, alpha
  bool color_mask[4];     // Return: which components of the color buffer are written
  int32_t x0, y0, x1, y1; // window, y down, half open; inside the surface
};

/// Numbers of the accumulation buffer of a surface, tile behind tile, each as its pixels lie.
constexpr size_t accumulation_numbers(const Surface& s) {
  return size_t(s.tiles_x) * size_t(s.tiles_y) * kTilePixels * 4;
}

/// Does it for the pixels of one tile, whose colors do not wait (TileWords). `numbers`: the whole buffer.
/// Beyond [-1, 1], where GL 1.5 leaves the result undefined, numbers wrap around as OSMesa's do.
void accumulate_tile(const Surface& surface, int16_t* numbers, const Accumulation& accumulation,
                     uint32_t tile);

} // namespace softgl
