#include "image/picture_rows.h"

#include <algorithm>

namespace softgl::cli {

int reduction_of(int64_t width, int64_t height) {
  int factor = 1;
  while (((width + factor - 1) / factor) * ((height + factor - 1) / factor) > kMostTexels) factor *= 2;
  return factor;
}

PictureRows::PictureRows(DecodedPicture& picture, int width, int height)
    : picture_(picture), width_(width), factor_(reduction_of(width, height)), rows_left_(height) {
  picture.width = (width + factor_ - 1) / factor_;
  picture.height = (height + factor_ - 1) / factor_;
  picture.rgba.room(size_t(4) * size_t(picture.width) * size_t(picture.height));
  if (factor_ == 1) return;
  sums_.assign(size_t(4) * size_t(picture.width), 0);
  row_.resize(size_t(4) * size_t(width));
}

uint8_t* PictureRows::next_row() {
  return factor_ == 1 ? picture_.rgba.room(size_t(4) * size_t(width_)) : row_.data();
}

void PictureRows::add_written() {
  if (factor_ == 1) {
    picture_.rgba.commit(size_t(4) * size_t(width_));
    return;
  }
  const uint8_t* texel = row_.data();
  uint32_t* sum = sums_.data();
  for (int x = 0; x < width_; x += factor_, sum += 4)
    for (int i = std::min(factor_, width_ - x); i > 0; --i, texel += 4)
      for (size_t c = 0; c < 4; ++c) sum[c] += texel[c];
  ++rows_;
  --rows_left_;
  if (rows_ == factor_ || rows_left_ == 0) emit();
}

void PictureRows::emit() {
  const int last_columns = width_ - (picture_.width - 1) * factor_;
  for (int x = 0; x < picture_.width; ++x) {
    const uint32_t count = uint32_t(rows_) * uint32_t(x + 1 < picture_.width ? factor_ : last_columns);
    for (size_t c = 0; c < 4; ++c)
      picture_.rgba.append(uint8_t((sums_[4 * size_t(x) + c] + count / 2) / count));
  }
  std::fill(sums_.begin(), sums_.end(), 0u);
  rows_ = 0;
}

} // namespace softgl::cli
