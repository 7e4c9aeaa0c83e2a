// How alike two pictures look.
#pragma once

#include "image/picture_reader.h"

namespace softgl::cli {

// The structural similarity of the brightness around each pixel, from -1 to 1; 1: the same. Z. Wang, A. C.
// Bovik, H. R. Sheikh, E. P. Simoncelli: "Image Quality Assessment: From Error Visibility to Structural
// Similarity", IEEE Transactions on Image Processing 13(4), 2004, with the Gaussian window of 11 x 11 pixels
// (sigma 1.5), K1 = 0.01 and K2 = 0.03 of that paper. At the frame the window is cut off and its weights are
// raised to a sum of 1. Pictures with alpha are laid over white. Both have one size.
GrowingArray<float> structural_similarity(const PictureSamples& a, const PictureSamples& b);

} // namespace softgl::cli
