#pragma once

#include "image/image_writer.h"

namespace softgl::cli {

GrowingArray<uint8_t> encode_png(const Picture& picture, PngEffort effort);

} // namespace softgl::cli
