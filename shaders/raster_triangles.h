// Set-up of triangles in batches of up to 64: what the binner gives to the kernels and gets back.
#pragma once

#include "raster_draw.h"

namespace softgl {

constexpr int kSetupBatch = 64;
constexpr int kSmallBox = 8; // pixels per side at most of a small triangle's box
// Boxes with more pixels go to the tiles (measured on 10-pixel triangles, see kSmallArea's users).
constexpr int kSmallArea = 40;
constexpr int kMaxSmallFragments = kSetupBatch * kSmallArea;

struct TriangleInput {
  int32_t count;
  int32_t tiles_x; // of the surface
  const ShadedVertices::Slot* const* corner[3]; // [corner][triangle]
};

/// Triangles that survive culling, in the order of their numbers: finished fragments of the small ones, numbers of the
/// large ones.
struct TriangleOutput {
  int32_t fragment_count;
  int32_t large_count;
  alignas(64) int32_t x[kMaxSmallFragments + 16], y[kMaxSmallFragments + 16]; // window position of a fragment
  uint8_t triangle[kMaxSmallFragments + 16];                                 // its triangle
  alignas(64) uint32_t tile[kMaxSmallFragments + 16], pixel[kMaxSmallFragments + 16]; // tile number, pixel_in_tile
  alignas(64) uint32_t depth[kMaxSmallFragments + 16], color[kMaxSmallFragments + 16];
  uint32_t live[kMaxSmallFragments + 16];   // 0: killed by the alpha test
  uint8_t large[kSetupBatch];
  // By triangle, set for those that survive: corners (0 and 1 exchanged where the area is negative) and facing.
  const float* corner[kSetupBatch][3];
  bool back[kSetupBatch];
};

} // namespace softgl
