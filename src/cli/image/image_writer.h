// Pictures as files.
#pragma once

#include <string>

#include "image/picture.h"

namespace softgl::cli {

enum class PngEffort { kFast, kDefault, kSmall };

// Known: png, ppm, pam, jpg, jpeg, bmp, tga, raw (the pixels alone), and the animations gif and apng. Taken
// from the file name's end; "" if it has none of these.
std::string image_format_of(const std::string& path);
bool is_image_format(const std::string& format);
bool has_alpha(const std::string& format); // png, pam, tga
bool is_animation(const std::string& format);

// Bytes of the picture in the format, which is no animation. Formats without alpha get the picture over
// white.
GrowingArray<uint8_t> encode_image(const Picture& picture, const std::string& format, PngEffort effort);

Picture over_white(const Picture& picture); // RGB of an RGBA picture

// To a file, or to standard output for "-". A file is written under another name beside it and then renamed:
// it is the old one or the new one, whole, at any time. Throws ProgramError (kCannotWrite).
void write_file(const std::string& path, const GrowingArray<uint8_t>& bytes);

} // namespace softgl::cli
