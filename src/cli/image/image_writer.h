// Pictures as files.
#pragma once

#include <string>

#include "image/picture.h"

namespace softgl::cli {

enum class PngEffort { kFast, kDefault, kSmall };

// Known: png, ppm, pam, jpg, jpeg, bmp, tga. Taken from the file name's end; "" if it has none of these.
std::string image_format_of(const std::string& path);
bool is_image_format(const std::string& format);
bool has_alpha(const std::string& format); // png, pam, tga

// Bytes of the picture in the format. Formats without alpha get the picture over white.
GrowingArray<uint8_t> encode_image(const Picture& picture, const std::string& format, PngEffort effort);

// To a file, or to standard output for "-". Throws ProgramError (kCannotWrite); leaves no half-written file.
void write_file(const std::string& path, const GrowingArray<uint8_t>& bytes);

} // namespace softgl::cli
