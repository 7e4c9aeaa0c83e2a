#include "image/sample_average.h"

#include <algorithm>

namespace softgl::cli {

Picture average_samples(GrowingArray<uint8_t> samples, int width, int height, int per_side,
                        bool transparent) {
  Picture picture;
  picture.width = width;
  picture.height = height;
  picture.channels = transparent ? 4 : 3;
  const auto columns = size_t(width), rows = size_t(height);
  const auto side = size_t(per_side), stride = columns * side * 4;
  const auto channels = size_t(picture.channels);
  const auto count = static_cast<unsigned>(per_side * per_side);
  const uint8_t* in = samples.data();
  uint8_t* out = samples.data(); // never ahead of what is still to be read
  if (per_side == 1 && !transparent) {
    for (size_t i = 0; i < columns * rows; ++i, in += 4, out += 3) {
      const uint8_t r = in[0], g = in[1], b = in[2];
      out[0] = r;
      out[1] = g;
      out[2] = b;
    }
  } else {
    for (size_t y = 0; y < rows; ++y) {
      const uint8_t* first = in + y * side * stride;
      for (size_t x = 0; x < columns; ++x, out += channels) {
        unsigned sum[4] = {0, 0, 0, 0};
        for (size_t j = 0; j < side; ++j) {
          const uint8_t* p = first + j * stride + x * side * 4;
          for (size_t i = 0; i < 4 * side; i += 4)
            for (size_t c = 0; c < 4; ++c) sum[c] += p[i + c];
        }
        if (!transparent) {
          for (size_t c = 0; c < 3; ++c) out[c] = uint8_t((sum[c] + count / 2) / count);
        } else if (sum[3] == 0) {
          out[0] = out[1] = out[2] = out[3] = 0;
        } else {
          for (size_t c = 0; c < 3; ++c)
            out[c] = uint8_t(std::min(255u, (sum[c] * 255 + sum[3] / 2) / sum[3]));
          out[3] = uint8_t((sum[3] + count / 2) / count);
        }
      }
    }
  }
  samples.truncate(columns * rows * channels);
  picture.pixels = std::move(samples);
  return picture;
}

} // namespace softgl::cli
