#include "image/float_picture.h"

#include <algorithm>

namespace softgl::cli {

FloatPicture average_float_samples(const GrowingArray<float>& samples, int width, int height, int per_side,
                                   bool transparent) {
  FloatPicture picture;
  picture.width = width;
  picture.height = height;
  picture.channels = transparent ? 4 : 3;
  const auto columns = size_t(width), rows = size_t(height), side = size_t(per_side);
  float* out = picture.values.extend(columns * rows * size_t(picture.channels));
  for (size_t y = 0; y < rows; ++y)
    for (size_t x = 0; x < columns; ++x, out += picture.channels) {
      float sum[4] = {0, 0, 0, 0};
      for (size_t j = 0; j < side; ++j)
        for (size_t i = 0; i < side; ++i) {
          const float* p = &samples[4 * ((y * side + j) * columns * side + x * side + i)];
          for (size_t c = 0; c < 4; ++c) sum[c] += p[c];
        }
      const auto count = float(side * side);
      for (size_t c = 0; c < 3; ++c)
        out[c] = transparent ? (sum[3] > 0 ? sum[c] / sum[3] : 0) : sum[c] / count;
      if (transparent) out[3] = sum[3] / count;
    }
  return picture;
}

Picture quantize(const FloatPicture& picture, int bits) {
  Picture result;
  result.width = picture.width;
  result.height = picture.height;
  result.channels = picture.channels;
  result.bits = bits;
  result.notes = picture.notes;
  const float largest = bits == 16 ? 65535 : 255;
  uint8_t* out = result.pixels.extend(picture.values.size() * size_t(bits / 8));
  for (size_t i = 0; i < picture.values.size(); ++i) {
    const float value = picture.values[i];
    const auto whole = unsigned((value > 0 ? std::min(value, 1.0f) : 0) * largest + 0.5f); // NaN is 0
    if (bits == 16) *out++ = uint8_t(whole >> 8);
    *out++ = uint8_t(whole);
  }
  return result;
}

} // namespace softgl::cli
