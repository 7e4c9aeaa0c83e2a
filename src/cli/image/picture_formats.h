// A decoder for each kind of picture file; those of libraries are there if the build found the library.
#pragma once

#include <algorithm>

#include "image/picture_decoder.h"

namespace softgl::cli {

// Each as decode_picture(), for bytes of its kind.
std::string decode_with_stb(const SourceText& bytes, DecodedPicture& picture); // PNG, BMP, TGA
std::string decode_png(const SourceText& bytes, DecodedPicture& picture);
std::string decode_jpeg(const SourceText& bytes, DecodedPicture& picture);
std::string decode_gif(const SourceText& bytes, DecodedPicture& picture);
std::string decode_tiff(const SourceText& bytes, DecodedPicture& picture);
std::string decode_webp(const SourceText& bytes, DecodedPicture& picture);

// Texels up to which a picture is read, by its file's size: a megabyte may claim any number, and must not
// cost seconds. `whole`: it is in memory at once; else its rows are read one by one.
inline int64_t most_texels(const SourceText& bytes, bool whole) {
  const int64_t most = whole ? kMostTexels : 2 * kMostTexels, each = whole ? 64 : 128;
  return std::clamp(each * int64_t(bytes.size()), most, 4 * most);
}
inline constexpr const char* kTooManyTexels = "has too many pixels for the size of its file";

} // namespace softgl::cli
