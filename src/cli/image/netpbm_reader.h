// Pictures of the PGM, PPM and PFM formats, of 8 and 16 bits and of floats.
#pragma once

#include <string_view>

#include "image/picture_reader.h"

namespace softgl::cli {

// False: `bytes` are none, or a damaged one. Values are scaled so that the file's largest is 255; in PFM 1
// is.
bool read_netpbm(std::string_view bytes, PictureSamples& picture);

} // namespace softgl::cli
