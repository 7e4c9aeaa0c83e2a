// The image of a pixel rectangle (GL 1.5, 3.6.4 and 3.7), as its fragments find it.
#pragma once

#include <stdint.h>

namespace softgl {

struct PixelFloats {
  float rgba[4];
};

enum class PixelElement : uint8_t {
  Floats, // PixelFloats
  Bytes,  // r g b a, a word
  Depth,  // in the depth buffer's integers
  Bit,    // a byte: 0 kills the fragment
  Stencil // a byte
};

struct PixelImage {
  PixelElement kind;
  const void* element;
  // The element of pixel (x, y) of the window, y down, is number row[y - y0] + column[x - x0].
  int32_t x0, y0, columns, rows;
  const int32_t *column, *row;
};

} // namespace softgl
