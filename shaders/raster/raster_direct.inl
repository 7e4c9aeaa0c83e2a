// Primitives whose fragments need no stage: coverage, depth test, color and blending of 8x8 blocks, straight
// to the tile.
#pragma once

#include "shaders/raster/raster_block.inl"

namespace softgl {
namespace SOFTGL_ISA {

struct Yes {
  constexpr operator bool() const { return true; }
};
struct No {
  constexpr operator bool() const { return false; }
};

/// How the color of a direct block reaches the surface. None: not at all, all of it is masked; its fragments
/// may be counted.
enum class DirectColor { Store, Over, Any, None };
/// What a direct block asks of the depth and stencil buffers.
enum class DirectTests { None, Depth, DepthAndStencil };

/// How many lanes live in the vectors whose bits are set.
SOFTGL_INLINE uint32_t count_lanes_of(const int32_t* live_lanes, uint32_t vectors) {
  uint32_t count = 0;
  for (; vectors; vectors &= vectors - 1)
    count += count_lanes(load(live_lanes + __builtin_ctz(vectors) * kWidth));
  return count;
}

/// A primitive whose fragments need no stage (RGBA8): coverage, tests, color, blending, row by row.
template <DirectTests Tests, DirectColor Color, int Edges>
static void direct_primitive(const RasterDraw& draw, const TileTarget& tile, const RasterPrimitive& p) {
  TileEdges edges;
  if (!clip_to_tile<Edges>(draw, p, tile.x, tile.y, edges)) return;
  EdgeSteps<Edges> steps;
  if (!edges.inside) edge_steps<Edges>(p, steps);
  const FragmentKey& key = draw.program->key;
  const Merger merger{*draw.program};
  constexpr bool kTests = Tests != DirectTests::None;
  const float scale = depth_scale(key);
  const Compare function = Compare(key.depth_function);
  const bool less = function == Compare::Less;
  const bool stores_blocks = draw.whole_blocks && draw.color_mask == ~uint32_t(0);
  const IntV depth_mask = splat(key.depth_write ? 0xffffff : 0), color_mask = splat(int32_t(draw.color_mask));
  const bool flat = draw.varying[0].flat, divide = !flat && !p.w_is_one; // the first varying is the color
  const FloatV offset = splat(p.depth_offset);
  IntV constant_color = IntV{};
  if (flat) {
    const Plane* q = p.plane + kPlaneColor;
    constant_color = pack_color(splat(q[0].a), splat(q[1].a), splat(q[2].a), splat(q[3].a));
  }
  constexpr int kHalves = kWidth < 8 ? 2 : 1;        // vectors of a row
  constexpr int kRows = kWidth < 8 ? 1 : kWidth / 8; // rows of a vector
  for (int by = edges.y0 & ~7; by < edges.y1; by += 8) {
    const int first = edges.y0 > by ? (edges.y0 - by) & ~(kRows - 1) : 0,
              last = edges.y1 < by + 8 ? edges.y1 - by : 8;
    for (int bx = edges.x0 & ~7; bx < edges.x1; bx += 8) {
      int32_t e[4] = {};
      BlockPlace place = BlockPlace::Inside;
      if (!edges.inside) {
        place = place_block<Edges>(edges, bx, by, e);
        if (place == BlockPlace::Outside) continue;
      }
      const int32_t x = tile.x + bx, y = tile.y + by;
      const int pixel = pixel_in_tile(bx, by);
      uint32_t* color = static_cast<uint32_t*>(tile.color) + pixel;
      uint32_t* depth = kTests ? tile.depth_stencil + pixel : nullptr;

      // First all rows' coverage and depth without a branch (which rows live is hard to predict: measured),
      // then the colors of those that live.
      alignas(64) int32_t live_lanes[64];
      uint32_t live_vectors = 0;
      IntV all = splat(-1); // of the lanes looked at
      const uint64_t box = box_mask(edges, bx, by);
      const IntV columns[2] = {mask_of_bits(uint32_t(box >> (8 * first))),
                               mask_of_bits(uint32_t(box >> (8 * first)) >> (kWidth & 7))};
      auto rows = [&](auto cut) __attribute__((always_inline)) {
        BlockPlane z;
        if constexpr (kTests) z = block_plane(p.plane[kPlaneZ], x);
        IntV v[Edges][kHalves] = {};
        if constexpr (cut)
          for (int i = 0; i < Edges; ++i)
            for (int h = 0; h < kHalves; ++h) v[i][h] = steps.column[i][h] + (e[i] + edges.b[i] * first);
        FloatV py = row_coordinates(y, first);
        for (int row = first; row < last; row += kRows, py += float(kRows)) {
          for (int h = 0; h < kHalves; ++h) {
            const int at = row * 8 + h * kWidth;
            IntV live = kRows == 2 ? mask_of_bits(uint32_t(box >> at)) : columns[h];
            if constexpr (cut) {
              IntV o = v[0][h];
              v[0][h] += steps.row[0];
              for (int i = 1; i < Edges; ++i) {
                o |= v[i][h];
                v[i][h] += steps.row[i];
              }
              live &= o >= 0;
            }
            if constexpr (Tests == DirectTests::DepthAndStencil)
              live =
                  merger.depth_stencil(live, depth_bits(z.gy * py + z.column[h] + offset, scale), depth + at);
            if constexpr (Tests == DirectTests::Depth) {
              const IntV zi = depth_bits(z.gy * py + z.column[h] + offset, scale);
              const IntV stored = load(depth + at), old = stored & 0xffffff;
              live &= less ? zi < old : compare_words(function, zi, old);
              store(depth + at, choose(live & depth_mask, zi, stored));
            }
            store(live_lanes + at, live);
            live_vectors |= uint32_t(sign_bits(live) != 0) << (row * kHalves / kRows + h);
            all &= live;
          }
        }
      };
      if (place == BlockPlace::Cut)
        rows(Yes{});
      else
        rows(No{});
      if (!live_vectors) continue;
      if constexpr (Color == DirectColor::None) {
        if (tile.samples) *tile.samples += count_lanes_of(live_lanes, live_vectors);
        continue;
      }

      BlockPlane w{}, c[4]{};
      if (!flat) {
        w = block_plane(p.plane[kPlaneW], x);
        for (int k = 0; k < 4; ++k) c[k] = block_plane(p.plane[kPlaneColor + k], x);
      }
      auto merged = [&](int at, int h, FloatV py) __attribute__((always_inline)) {
        IntV source = constant_color;
        if (!flat) {
          const FloatV r = divide ? splat(1.0f) / (w.gy * py + w.column[h]) : splat(1.0f);
          auto value = [&](int k) { return (c[k].gy * py + c[k].column[h]) * r; };
          const FloatV a[4] = {value(0), value(1), value(2), draw.opaque ? splat(1.0f) : value(3)};
          source = pack_color(a[0], a[1], a[2], a[3]);
        }
        if constexpr (Color == DirectColor::Over) source = blend_over(source, load(color + at));
        if constexpr (Color == DirectColor::Any) source = merger.blended(source, load(color + at));
        return source;
      };
      // Most blocks of large primitives are hit or missed as a whole.
      if (first == 0 && last == 8 && stores_blocks && sign_bits(all) == (uint64_t(1) << kWidth) - 1) {
        FloatV py = row_coordinates(y, 0);
        for (int at = 0; at < 64; py += float(kRows))
          for (int h = 0; h < kHalves; ++h, at += kWidth) store(color + at, merged(at, h, py));
        continue;
      }
      do {
        const int i = __builtin_ctz(live_vectors), at = i * kWidth, h = kWidth < 8 ? i & 1 : 0;
        live_vectors &= live_vectors - 1;
        const IntV live = load(live_lanes + at);
        store(color + at,
              choose(live & color_mask, merged(at, h, row_coordinates(y, at >> 3)), load(color + at)));
      } while (live_vectors);
    }
  }
}

template <DirectTests Tests, DirectColor Color>
static void direct_primitives(const TileTarget& tile, const RasterDraw& draw,
                              const RasterPrimitive* const* primitive, int32_t count) {
  for (int32_t i = 0; i < count; ++i) {
    prefetch(primitive, i, count);
    if (primitive[i]->edges == 3)
      direct_primitive<Tests, Color, 3>(draw, tile, *primitive[i]);
    else
      direct_primitive<Tests, Color, 4>(draw, tile, *primitive[i]);
  }
}

template <DirectTests Tests> static void direct_primitives(const TileTarget& tile, const RasterDraw& draw,
                                                           const RasterPrimitive* const* primitive,
                                                           int32_t count) {
  const FragmentKey& key = draw.program->key;
  if (draw.color_mask == 0)
    direct_primitives<Tests, DirectColor::None>(tile, draw, primitive, count);
  else if (is_over(key))
    direct_primitives<Tests, DirectColor::Over>(tile, draw, primitive, count);
  else if (key.blend || key.logic_op)
    direct_primitives<Tests, DirectColor::Any>(tile, draw, primitive, count);
  else
    direct_primitives<Tests, DirectColor::Store>(tile, draw, primitive, count);
}

} // namespace SOFTGL_ISA
} // namespace softgl
