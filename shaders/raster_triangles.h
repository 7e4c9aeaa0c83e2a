// Set-up of triangles in batches of up to 64: what the binner gives to the kernels and gets back.
#pragma once

#include "raster_draw.h"

namespace softgl {

constexpr int kSetupBatch = 64;
// Pixels per side at most of a small triangle's box. Coverage is found for all boxes of up to 8 at once, lane = triangle;
// larger ones are cut in blocks of 8 by 8.
constexpr int kSmallBox = 16, kBlockBox = 8;
constexpr int kMaxSmallFragments = kSetupBatch * kSmallBox * kSmallBox;
constexpr int kMaxRuns = 16 * kSetupBatch; // four blocks of a box, each in up to four tiles

struct TriangleInput {
  int32_t count;
  int32_t tiles_x; // of the surface
  const ShadedVertices::Slot* const* corner[3]; // [corner][triangle]
};

/// Triangles that survive culling: the small ones' finished fragments in drawing order, the large ones' numbers.
struct TriangleOutput {
  // One bit a triangle.
  uint64_t small, large;
  uint64_t cut; // small ones whose box is cut in blocks
  uint64_t negative; // area; corners 0 and 1 are exchanged
  // Small triangles: covered pixels of an 8x8 box (bit 8 * dy + dx), its first pixel (y in the upper half) and that
  // pixel's tile.
  alignas(64) uint32_t rows0to3[kSetupBatch], rows4to7[kSetupBatch], position[kSetupBatch], tile[kSetupBatch];
  // Where the box is cut: its edges (a and b by whole pixels) and last column and row instead of the pixels.
  alignas(64) int32_t edge_c[3][kSetupBatch], edge_a[3][kSetupBatch], edge_b[3][kSetupBatch], last_column[kSetupBatch], last_row[kSetupBatch];
  /// Fragments of one tile with no large triangle among them. They end where the next run begins.
  struct Run {
    uint32_t tile;
    int32_t first;
    uint8_t triangle; // the first fragment's
  };
  int32_t run_count;
  Run run[kMaxRuns + 1];
  // By fragment; room for a vector behind the last.
  alignas(64) uint16_t pixel[kMaxSmallFragments + 16]; // pixel_in_tile
  alignas(64) uint32_t depth[kMaxSmallFragments + 16], color[kMaxSmallFragments + 16];
  uint32_t live[kMaxSmallFragments + 16]; // 0: killed by the alpha test
};

} // namespace softgl
