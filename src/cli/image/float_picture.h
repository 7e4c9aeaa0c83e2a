// A picture of floats, and what becomes of it in files of whole numbers.
#pragma once

#include <string>
#include <vector>

#include "image/picture.h"

namespace softgl::cli {

struct FloatPicture {
  int width = 0, height = 0;
  int channels = 3;           // 1, 3: RGB, 4: RGBA with the color not multiplied by alpha
  GrowingArray<float> values; // rows from the top
  std::vector<PictureNote> notes;
};

// `samples`: RGBA rows from the top; as average_samples().
FloatPicture average_float_samples(const GrowingArray<float>& samples, int width, int height, int per_side,
                                   bool transparent);

// 0 to 1 as 8 or 16 bits; what is beyond is cut off.
Picture quantize(const FloatPicture& picture, int bits);

} // namespace softgl::cli
