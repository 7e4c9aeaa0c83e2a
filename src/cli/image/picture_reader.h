// Picture files as numbers, for comparing them.
#pragma once

#include <cstdint>
#include <string>

#include "common/growing_array.h"

namespace softgl::cli {

struct PictureSamples {
  int width = 0, height = 0;
  bool alpha = false;         // some pixel is not opaque
  GrowingArray<float> values; // RGBA rows from the top, 255 is full; files of more than 8 bits give fractions
};

inline constexpr int64_t kMostPixels = int64_t(1) << 28; // of a file: 16384 x 16384

// PNG, JPEG (if the build has its library), BMP, TGA, PPM, PGM and PFM, of 8 or 16 bits a channel or of
// floats. Throws ProgramError (kCannotRead).
PictureSamples read_picture(const std::string& path);

// Whether the file name's end is that of a format that read_picture() knows.
bool is_readable_picture(const std::string& path);

} // namespace softgl::cli
