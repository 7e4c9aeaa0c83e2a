// Animated GIF, through giflib where the program was built with it.
#pragma once

#include <vector>

#include "image/picture.h"

namespace softgl::cli {

bool can_write_gif();

// A frame in at most 256 colors of its own, of which one is transparent if the picture has alpha.
struct GifFrame {
  int width = 0, height = 0;
  bool transparent = false;      // index 255
  GrowingArray<uint8_t> palette; // RGB of 256
  GrowingArray<uint8_t> indices; // rows from the top
};
GifFrame encode_gif_frame(const Picture& picture);

// At least one frame, all of one size; 1 to 100 a second, over and over.
GrowingArray<uint8_t> assemble_gif(const std::vector<GifFrame>& frames, int frames_per_second);

} // namespace softgl::cli
