// Set-up of triangles in batches of up to 64: what the binner gives to the kernels and gets back.
#pragma once

#include "shaders/raster/raster_draw.h"

namespace softgl {

constexpr int kSetupBatch = 64;
// Pixels per side at most of a small triangle's box (small_box() says when it is less), and of a tiny one's.
constexpr int kSmallBox = 48, kTinyBox = 8;
// Where none is drawn as a small one: up to here triangles that cover nothing are dropped before their planes
// are made (7,000 of 14,000 with a seamless cube map in a picture of MuJoCo's figure).
constexpr int kSeenBox = 2;
// A batch is tiny when the boxes of its small triangles have fewer pixels each. Their fragments are shaded at
// once, each lane's planes made anew; with more it pays to make a triangle's planes once, in the tile.
// Measured on triangles of 1 to 4 pixels. Where vertices are shaded with the piece that reads them they would
// have to be kept for the tiles.
constexpr int kTinyPixels = 6, kTinyPixelsInOrder = 20;
constexpr int kMaxTinyFragments = kTinyPixelsInOrder * kSetupBatch;
constexpr int kMaxRuns = 4 * kSetupBatch; // each triangle in up to four tiles

struct TriangleInput {
  int32_t count;
  int32_t tiles_x;                              // of the surface
  int32_t tiny_pixels;                          // kTinyPixels or kTinyPixelsInOrder; 0: none is tiny
  bool shares_planes;                           // fragments of a tiny triangle may share planes
  const ShadedVertices::Slot* const* corner[3]; // [corner][triangle]
};

/// Triangles that survive culling.
struct TriangleOutput {
  // One bit a triangle.
  uint64_t small, large;
  uint64_t negative;  // area; corners 0 and 1 are exchanged
  bool shared_planes; // of tiny ones: their fragments have shared planes
  bool tiny;          // the small ones are finished fragments; else they go to their tiles as they are
  // Of small triangles: the tile of the box's first pixel; bit 0: the box reaches into the next column of
  // tiles, bit 1: into the next row.
  alignas(64) uint32_t tile[kSetupBatch], further[kSetupBatch];
  // Of tiny triangles: covered pixels of an 8x8 box (bit 8 * dy + dx) and its first pixel (y in the upper
  // half).
  alignas(64) uint32_t rows0to3[kSetupBatch], rows4to7[kSetupBatch], position[kSetupBatch];
  /// Fragments of one tile with no large triangle among them. They end where the next run begins.
  struct Run {
    uint32_t tile;
    int32_t first;
    uint8_t triangle; // the first fragment's
  };
  int32_t run_count;
  Run run[kMaxRuns + 1];
  // By fragment, in drawing order; room for a vector behind the last.
  alignas(64) uint16_t pixel[kMaxTinyFragments + 16]; // pixel_in_tile
  alignas(64) uint32_t depth[kMaxTinyFragments + 16], color[kMaxTinyFragments + 16];
  uint32_t live[kMaxTinyFragments + 16]; // 0: killed by the alpha test
};

} // namespace softgl
