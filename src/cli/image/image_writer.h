// Pictures as files.
#pragma once

#include <string>
#include <vector>

#include "image/picture.h"

namespace softgl::cli {

enum class PngEffort { kFast, kDefault, kSmall };

// Known: png, ppm, pam, jpg, jpeg, bmp, tga, raw (the pixels alone), pfm and exr (floats), and the
// animations gif and apng. Taken
// from the file name's end; "" if it has none of these.
std::string image_format_of(const std::string& path);
std::vector<std::string> image_formats();
bool is_image_format(const std::string& format);
bool has_alpha(const std::string& format); // png, pam, tga
bool is_animation(const std::string& format);

// Bytes of the picture in the format, which has no floats and is no
// animation. PNG alone has 16 bits. Formats without alpha get the picture over
// white.
GrowingArray<uint8_t> encode_image(const Picture& picture, const std::string& format, PngEffort effort);

Picture as_rgb(const Picture& picture); // of 8 bits; alpha is laid over white

} // namespace softgl::cli
