// A finished picture.
#pragma once

#include <cstdint>

#include "common/growing_array.h"

namespace softgl::cli {

struct Picture {
  int width = 0, height = 0;
  int channels = 3;             // 3: RGB, 4: RGBA with the color not multiplied by alpha
  GrowingArray<uint8_t> pixels; // rows from the top, without padding
};

} // namespace softgl::cli
