#pragma once

#include <vector>

#include "image/image_writer.h"

namespace softgl::cli {

GrowingArray<uint8_t> encode_png(const Picture& picture, PngEffort effort);

// A frame of an animated PNG.
struct PngFrame {
  GrowingArray<uint8_t> start, packed; // signature and header of a file of this size; compressed rows
  uint32_t width = 0, height = 0;
};
PngFrame encode_png_frame(const Picture& picture, PngEffort effort);
// At least one frame, all of one kind; 1 to 100 a second, over and over.
GrowingArray<uint8_t> assemble_apng(const std::vector<PngFrame>& frames, int frames_per_second);

} // namespace softgl::cli
