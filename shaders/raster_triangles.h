// Set-up of triangles in batches of up to 64: what the binner gives to the kernels and gets back.
#pragma once

#include "raster_draw.h"

namespace softgl {

constexpr int kSetupBatch = 64;
constexpr int kSmallBox = 4;                                   // pixels per side; measured, 8x4 gains nothing
constexpr int kMaxSmallFragments = kSetupBatch * kSmallBox * kSmallBox;

struct TriangleInput {
  int32_t count;
  const ShadedVertices::Slot* const* corner[3]; // [corner][triangle]
};

/// Triangles that survive culling, in the order of their numbers: finished fragments of the small ones, numbers of the
/// large ones.
struct TriangleOutput {
  int32_t fragment_count;
  int32_t large_count;
  alignas(64) int32_t x[kMaxSmallFragments + 16], y[kMaxSmallFragments + 16]; // window position of a fragment
  uint8_t triangle[kMaxSmallFragments + 16];                                 // its triangle
  alignas(64) uint32_t depth[kMaxSmallFragments + 16], color[kMaxSmallFragments + 16];
  uint32_t live[kMaxSmallFragments + 16];   // 0: killed by the alpha test
  uint8_t large[kSetupBatch];
  bool negative[kSetupBatch]; // by triangle: area < 0, so corners 0 and 1 change places
};

} // namespace softgl
