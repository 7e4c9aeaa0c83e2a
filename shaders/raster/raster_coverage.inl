// Which pixels of an 8x8 block a primitive covers.
#pragma once

#include "shaders/common/simd.h"
#include "shaders/raster/raster_draw.h"

namespace softgl {
namespace SOFTGL_ISA {

/// A primitive's edges relative to one tile, in 32 bits: c is clamped to +-2^30, a and b stay below 2^23 and
/// a tile has 64 pixels, so no sum overflows and no sign is lost. Edges that a primitive does not have accept
/// everything.
struct TileEdges {
  int32_t c[4], a[4], b[4];           // at the tile's first pixel; inside iff c - a * dx + b * dy >= 0
  int32_t block_min[4], block_max[4]; // least and greatest change over an 8x8 block
  int32_t x0, y0, x1, y1;             // box inside the tile, half open
  bool inside;                        // all edges accept the whole tile
  int32_t least;                      // -1: no block counts as inside; else 0
};

SOFTGL_INLINE void set_edge(TileEdges& t, int i, int32_t c, int32_t a, int32_t b) {
  t.a[i] = a, t.b[i] = b, t.c[i] = c;
  t.block_min[i] = ((a > 0 ? -a : 0) + (b < 0 ? b : 0)) * 7;
  t.block_max[i] = ((a < 0 ? -a : 0) + (b > 0 ? b : 0)) * 7;
}

/// The part of a primitive's box inside the tile; false: there is none.
SOFTGL_INLINE bool clip_box(const RasterPrimitive& p, int32_t tile_x, int32_t tile_y, TileEdges& t) {
  t.x0 = p.x0 > tile_x ? p.x0 - tile_x : 0;
  t.y0 = p.y0 > tile_y ? p.y0 - tile_y : 0;
  t.x1 = p.x1 < tile_x + kTileSize ? p.x1 - tile_x : kTileSize;
  t.y1 = p.y1 < tile_y + kTileSize ? p.y1 - tile_y : kTileSize;
  return t.x0 < t.x1 && t.y0 < t.y1;
}

/// An edge's constant `c` at the first pixel of the tile.
SOFTGL_INLINE int32_t constant_in_tile(int64_t c, int32_t a, int32_t b, int32_t tile_x, int32_t tile_y) {
  c += int64_t(b) * tile_y - int64_t(a) * tile_x;
  return int32_t(c > (1 << 30) ? 1 << 30 : c < -(1 << 30) ? -(1 << 30) : c);
}

/// False: no pixel of the tile is covered. Looks at the first `Edges` edges.
template <int Edges> SOFTGL_INLINE bool clip_to_tile(const RasterDraw& draw, const RasterPrimitive& p,
                                                     int32_t tile_x, int32_t tile_y, TileEdges& t) {
  if (!clip_box(p, tile_x, tile_y, t)) return false;
  t.inside = draw.whole_blocks;
  t.least = draw.whole_blocks ? 0 : -1;
  for (int i = 0; i < Edges; ++i) {
    const int32_t a = p.a[i], b = p.b[i];
    set_edge(t, i, constant_in_tile(p.c[i], a, b, tile_x, tile_y), a, b);
    if (t.c[i] + t.block_max[i] * 9 < 0) return false;
    t.inside = t.inside && t.c[i] + t.block_min[i] * 9 >= 0;
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

/// Column steps of the edges: -a * dx for the lanes of a vector, plus b * dy where a vector holds two rows.
template <int Edges> struct EdgeSteps {
  IntV column[Edges][kWidth < 8 ? 2 : 1];
  IntV row[Edges];
};
template <int Edges> SOFTGL_INLINE void edge_steps(const RasterPrimitive& p, EdgeSteps<Edges>& s) {
  alignas(64) static const int32_t column[16] = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
  alignas(64) static const int32_t row[16] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
  for (int i = 0; i < Edges; ++i) {
    s.column[i][0] = multiply(splat(-p.a[i]), load(column));
    if constexpr (kWidth < 8) s.column[i][1] = multiply(splat(-p.a[i]), load(column + 4));
    if constexpr (kWidth == 16) s.column[i][0] += multiply(splat(p.b[i]), load(row));
    s.row[i] = splat(p.b[i] * (kWidth == 16 ? 2 : 1));
  }
}

/// How a block of the tile lies: outside, cut by edges or inside; `e` are the edges at its first pixel.
enum class BlockPlace { Outside, Cut, Inside };
template <int Edges>
SOFTGL_INLINE BlockPlace place_block(const TileEdges& t, int32_t x, int32_t y, int32_t e[4]) {
  int32_t least = t.least, greatest = 0; // only their signs matter
  for (int i = 0; i < Edges; ++i) {
    e[i] = t.c[i] - t.a[i] * x + t.b[i] * y;
    greatest |= e[i] + t.block_max[i];
    least |= e[i] + t.block_min[i];
  }
  return greatest < 0 ? BlockPlace::Outside : least < 0 ? BlockPlace::Cut : BlockPlace::Inside;
}

/// Coverage of the block at (x, y) of the tile.
template <int Edges>
SOFTGL_INLINE uint64_t block_coverage(const TileEdges& t, const EdgeSteps<Edges>& s, int32_t x, int32_t y) {
  int32_t e[4];
  const BlockPlace place = place_block<Edges>(t, x, y, e);
  if (place == BlockPlace::Outside) return 0;
  const uint64_t mask = box_mask(t, x, y);
  if (place == BlockPlace::Inside) return mask;
  uint64_t outside = 0;
  constexpr int kHalves = kWidth < 8 ? 2 : 1;
  IntV v[Edges][kHalves];
  for (int i = 0; i < Edges; ++i)
    for (int h = 0; h < kHalves; ++h) v[i][h] = s.column[i][h] + e[i];
  for (int row = 0; row < 64 / (kWidth * kHalves); ++row)
    for (int h = 0; h < kHalves; ++h) {
      IntV o = v[0][h];
      v[0][h] += s.row[0];
      for (int i = 1; i < Edges; ++i) {
        o |= v[i][h];
        v[i][h] += s.row[i];
      }
      outside |= uint64_t(sign_bits(o)) << (kWidth * (row * kHalves + h));
    }
  return mask & ~outside;
}

} // namespace SOFTGL_ISA
} // namespace softgl
