// Picture files of any known kind as RGBA.
#pragma once

#include <cstdint>
#include <string>

#include "common/growing_array.h"
#include "common/source_text.h"

namespace softgl::cli {

// A picture of more texels is made smaller while it is read: a small file may claim any size.
inline constexpr int64_t kMostTexels = int64_t(1) << 26;

struct DecodedPicture {
  int width = 0, height = 0;
  int file_width = 0, file_height = 0; // as the file says; larger if it was made smaller
  GrowingArray<uint8_t> rgba;          // rows from the top
};

// Empty: it worked; else why not, as half a sentence. Throws std::bad_alloc if memory ends.
std::string decode_picture(const SourceText& bytes, DecodedPicture& picture);

} // namespace softgl::cli
