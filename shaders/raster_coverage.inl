// Which pixels of an 8x8 block a primitive covers.
#pragma once

#include "raster_draw.h"
#include "simd.h"

namespace softgl {
namespace SOFTGL_ISA {

/// A primitive's edges relative to one tile, in 32 bits: c is clamped to +-2^30, a and b stay below 2^23 and a tile has
/// 64 pixels, so no sum overflows and no sign is lost.
struct TileEdges {
  int32_t count;
  int32_t c[4], a[4], b[4];          // at the tile's first pixel; inside iff c - a * dx + b * dy >= 0
  int32_t block_min[4], block_max[4]; // least and greatest change over an 8x8 block
  int32_t x0, y0, x1, y1;            // box inside the tile, half open
  bool inside;                       // all edges accept the whole tile
};

/// False: no pixel of the tile is covered.
static inline bool clip_to_tile(const RasterPrimitive& p, int32_t tile_x, int32_t tile_y, TileEdges& t) {
  t.count = p.edges;
  t.x0 = p.x0 > tile_x ? p.x0 - tile_x : 0;
  t.y0 = p.y0 > tile_y ? p.y0 - tile_y : 0;
  t.x1 = p.x1 < tile_x + kTileSize ? p.x1 - tile_x : kTileSize;
  t.y1 = p.y1 < tile_y + kTileSize ? p.y1 - tile_y : kTileSize;
  if (t.x0 >= t.x1 || t.y0 >= t.y1) return false;
  t.inside = true;
  for (int i = 0; i < t.count; ++i) {
    const int32_t a = p.a[i], b = p.b[i];
    int64_t c = p.c[i] - int64_t(a) * tile_x + int64_t(b) * tile_y;
    c = c > (1 << 30) ? 1 << 30 : c < -(1 << 30) ? -(1 << 30) : c;
    t.a[i] = a, t.b[i] = b, t.c[i] = int32_t(c);
    const int32_t lo = (a > 0 ? -a : 0) + (b < 0 ? b : 0), hi = (a < 0 ? -a : 0) + (b > 0 ? b : 0);
    t.block_min[i] = lo * 7, t.block_max[i] = hi * 7;
    if (int32_t(c) + hi * 63 < 0) return false;
    t.inside = t.inside && int32_t(c) + lo * 63 >= 0;
  }
  return true;
}

/// The pixels (bit 8 * dy + dx) of the block whose first pixel is (x, y) in the tile.
SOFTGL_INLINE uint64_t box_mask(const TileEdges& t, int32_t x, int32_t y) {
  const int32_t left = t.x0 - x, right = t.x1 - x, top = t.y0 - y, bottom = t.y1 - y;
  if (left <= 0 && right >= 8 && top <= 0 && bottom >= 8) return ~uint64_t(0);
  uint64_t columns = 0xff;
  if (left > 0) columns &= 0xffu << left;
  if (right < 8) columns &= 0xffu >> (8 - right);
  uint64_t mask = columns * 0x0101010101010101u;
  if (top > 0) mask &= ~uint64_t(0) << (8 * top);
  if (bottom < 8) mask &= ~uint64_t(0) >> (8 * (8 - bottom));
  return mask;
}

/// Column steps of the edges: -a * dx for the lanes of a vector, plus b * dy where a vector holds several rows.
struct EdgeSteps {
  IntV column[4][kWidth < 8 ? 2 : 1];
  IntV row[4];
};
SOFTGL_INLINE void edge_steps(const TileEdges& t, EdgeSteps& s) {
  for (int i = 0; i < t.count; ++i) {
    alignas(64) int32_t step[16];
    for (int k = 0; k < 16; ++k) step[k] = -t.a[i] * (k & 7) + t.b[i] * (k >> 3);
    s.column[i][0] = load(step);
    if constexpr (kWidth < 8) s.column[i][1] = load(step + 4);
    s.row[i] = splat(t.b[i] * (kWidth == 16 ? 2 : 1));
  }
}

/// Coverage of the block at (x, y) of the tile.
SOFTGL_INLINE uint64_t block_coverage(const TileEdges& t, const EdgeSteps& s, int32_t x, int32_t y) {
  int32_t e[4];
  bool inside = true;
  for (int i = 0; i < t.count; ++i) {
    e[i] = t.c[i] - t.a[i] * x + t.b[i] * y;
    if (e[i] + t.block_max[i] < 0) return 0;
    inside = inside && e[i] + t.block_min[i] >= 0;
  }
  uint64_t mask = box_mask(t, x, y);
  if (inside) return mask;
  uint64_t outside = 0;
  if constexpr (kWidth < 8) {
    IntV v[4][2];
    for (int i = 0; i < t.count; ++i) v[i][0] = s.column[i][0] + e[i], v[i][1] = s.column[i][1] + e[i];
    for (int row = 0; row < 8; ++row) {
      IntV o0 = v[0][0], o1 = v[0][1];
      v[0][0] += s.row[0], v[0][1] += s.row[0];
      for (int i = 1; i < t.count; ++i) {
        o0 |= v[i][0], o1 |= v[i][1];
        v[i][0] += s.row[i], v[i][1] += s.row[i];
      }
      outside |= uint64_t(sign_bits(o0) | sign_bits(o1) << 4) << (8 * row);
    }
  } else {
    IntV v[4];
    for (int i = 0; i < t.count; ++i) v[i] = s.column[i][0] + e[i];
    for (int row = 0; row < 64 / kWidth; ++row) {
      IntV o = v[0];
      v[0] += s.row[0];
      for (int i = 1; i < t.count; ++i) {
        o |= v[i];
        v[i] += s.row[i];
      }
      outside |= uint64_t(sign_bits(o)) << (kWidth * row);
    }
  }
  return mask & ~outside;
}

} // namespace SOFTGL_ISA
} // namespace softgl
