// Takes the rows of a picture one by one, and makes it smaller by a power of two where it is too large.
#pragma once

#include <vector>

#include "image/picture_decoder.h"

namespace softgl::cli {

// The smallest power of two by which both sides are divided to have at most kMostTexels.
int reduction_of(int64_t width, int64_t height);

class PictureRows {
public:
  // `picture` gets the size and the texels; the file's size is the caller's.
  PictureRows(DecodedPicture& picture, int width, int height);
  // A place for the next row from the top, RGBA, which is written before add_written() is called.
  uint8_t* next_row();
  void add_written();

private:
  void emit();

  DecodedPicture& picture_;
  const int width_, factor_;
  int rows_left_, rows_ = 0; // to come; in the sums
  std::vector<uint32_t> sums_;
  std::vector<uint8_t> row_;
};

} // namespace softgl::cli
