// A finished picture.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/growing_array.h"

namespace softgl::cli {

// Something worth knowing about the picture, for formats that keep such: both ASCII.
struct PictureNote {
  std::string name, text;
};

struct Picture {
  int width = 0, height = 0;
  int channels = 3;             // 1: gray, 3: RGB, 4: RGBA with the color not multiplied by alpha
  int bits = 8;                 // of a channel; 16: the high byte first
  GrowingArray<uint8_t> pixels; // rows from the top, without padding
  std::vector<PictureNote> notes;
};

} // namespace softgl::cli
