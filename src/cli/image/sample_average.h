// From samples to pixels.
#pragma once

#include "image/picture.h"

namespace softgl::cli {

// `samples`: RGBA rows from the top, `per_side` x `per_side` for each pixel. Opaque: RGB, the mean of the
// samples. With `transparent` the samples are colors multiplied by their alpha; the picture's are not. The
// picture takes the memory.
Picture average_samples(GrowingArray<uint8_t> samples, int width, int height, int per_side, bool transparent);

} // namespace softgl::cli
