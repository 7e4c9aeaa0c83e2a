// A decoder for each kind of picture file; those of libraries are there if the build found the library.
#pragma once

#include "image/picture_decoder.h"

namespace softgl::cli {

// Each as decode_picture(), for bytes of its kind.
std::string decode_with_stb(const SourceText& bytes, DecodedPicture& picture); // PNG, JPEG, BMP, TGA
std::string decode_png(const SourceText& bytes, DecodedPicture& picture);
std::string decode_jpeg(const SourceText& bytes, DecodedPicture& picture);
std::string decode_gif(const SourceText& bytes, DecodedPicture& picture);
std::string decode_tiff(const SourceText& bytes, DecodedPicture& picture);
std::string decode_webp(const SourceText& bytes, DecodedPicture& picture);

// Rows are read one by one up to this many texels; more are refused.
inline constexpr int64_t kMostFileTexels = int64_t(1) << 29;
inline constexpr const char* kTooManyTexels = "has too many pixels";

} // namespace softgl::cli
