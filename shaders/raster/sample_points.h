// Where the samples of a pixel lie (GL 1.5, 3.2.1).
#pragma once

#include "shaders/common/surface.h"

namespace softgl {

/// Sample points in 1/256 of a pixel, from the corner of its first row and column (those of OSMesa 22.3.6).
constexpr int kSampleX[kSamples] = {96, 224, 32, 160}, kSampleY[kSamples] = {32, 96, 160, 224};

} // namespace softgl
