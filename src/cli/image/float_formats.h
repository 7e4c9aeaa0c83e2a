// Pictures of floats as files: PFM, and OpenEXR where the program was built with tinyexr.
#pragma once

#include <string>

#include "image/float_picture.h"

namespace softgl::cli {

bool is_float_format(const std::string& format); // pfm, exr
bool can_write_exr();

// PFM has one or three channels: alpha is left out, and notes. Throws ProgramError if the format is not built
// in.
GrowingArray<uint8_t> encode_floats(const FloatPicture& picture, const std::string& format);

} // namespace softgl::cli
