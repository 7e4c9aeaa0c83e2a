#pragma once

#include "image_writer.h"

namespace softgl::cli {

GrowingArray<uint8_t> encode_png(const Picture& picture, PngEffort effort);

} // namespace softgl::cli
