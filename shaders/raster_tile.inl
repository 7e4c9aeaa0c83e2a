// What a tile worker does with the segments of its list: primitives by 8x8 blocks, finished fragments one by one.
#pragma once

#include "fragment_interpolate.inl"
#include "fragment_merge.inl"
#include "raster_coverage.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Strips of one primitive on their way through the fragment program.
struct StripBatch {
  int32_t strips = 0;
  int32_t pixel[kLanes / kStripLanes]; // pixel_in_tile of the strip's first pixel
};

SOFTGL_INLINE FloatV row_of_eight(int i) { // x offsets of the lanes of vector i of a strip
  alignas(64) static const float offset[16] = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
  return load(offset + (i * kWidth & 7));
}
SOFTGL_INLINE FloatV row_number(int i) {
  alignas(64) static const float row[16] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
  return kWidth == 16 ? load(row) : splat(float(i * kWidth >> 3));
}

/// Merges the strips of `block` whose colours are final.
static void merge_strips(const RasterDraw& draw, const TileTarget& tile, FragmentBlock& block, const StripBatch& batch) {
  const FragmentProgram& program = *draw.program;
  const auto format = ColorFormat(program.key.color_format);
  MergeBlock m;
  m.lanes = block.lanes;
  memcpy(m.live, block.live, sizeof(uint32_t) * size_t(block.lanes));
  memcpy(m.depth, block.depth, sizeof(uint32_t) * size_t(block.lanes));
  if (tile.depth_stencil)
    for (int s = 0; s < batch.strips; ++s)
      memcpy(m.depth_stencil + s * kStripLanes, tile.depth_stencil + batch.pixel[s], kStripLanes * sizeof(uint32_t));
  if (format == ColorFormat::Rgba8 || format == ColorFormat::Rgb565) {
    for (int i = 0; i < block.lanes; i += kWidth)
      store(m.color + i, pack_color(load(block.color[0] + i), load(block.color[1] + i), load(block.color[2] + i), load(block.color[3] + i)));
    auto* words = static_cast<uint32_t*>(tile.color);
    auto* halves = static_cast<uint16_t*>(tile.color);
    for (int s = 0; s < batch.strips; ++s) {
      if (format == ColorFormat::Rgba8) memcpy(m.target + s * kStripLanes, words + batch.pixel[s], kStripLanes * sizeof(uint32_t));
      else for (int i = 0; i < kStripLanes; ++i) m.target[s * kStripLanes + i] = expand_565(halves[batch.pixel[s] + i]);
    }
    merge_8(program, m);
    for (int s = 0; s < batch.strips; ++s) {
      if (format == ColorFormat::Rgba8) memcpy(words + batch.pixel[s], m.target + s * kStripLanes, kStripLanes * sizeof(uint32_t));
      else for (int i = 0; i < kStripLanes; ++i) halves[batch.pixel[s] + i] = cut_565(m.target[s * kStripLanes + i]);
    }
  } else {
    merge_depth_stencil(program, m);
    for (int i = 0; i < block.lanes; ++i) {
      if (!m.live[i]) continue;
      const float color[4] = {block.color[0][i], block.color[1][i], block.color[2][i], block.color[3][i]};
      store_wide(program, format, color, tile.color, size_t(batch.pixel[i / kStripLanes] + i % kStripLanes));
    }
  }
  if (tile.depth_stencil && (program.key.depth_write || program.key.stencil))
    for (int s = 0; s < batch.strips; ++s)
      memcpy(tile.depth_stencil + batch.pixel[s], m.depth_stencil + s * kStripLanes, kStripLanes * sizeof(uint32_t));
}

static void run_strips(const RasterDraw& draw, const TileTarget& tile, const RasterPrimitive& p, FragmentBlock& block, StripBatch& batch) {
  block.lanes = batch.strips * kStripLanes;
  interpolate_block(draw, p, block);
  const FragmentProgram& program = *draw.program;
  for (int i = 0; i < program.step_count; ++i) program.step[i].stage(block, *program.constants, program.step[i].unit);
  merge_strips(draw, tile, block, batch);
  batch.strips = 0;
}

struct Yes { constexpr operator bool() const { return true; } };
struct No { constexpr operator bool() const { return false; } };

/// How the colour of a direct block reaches the surface.
enum class DirectColor { Store, Over, Any };

/// Planes of a primitive with the x part at the columns of a block: a + gx * px.
struct BlockPlane {
  FloatV column[kWidth < 8 ? 2 : 1];
  FloatV gy;
};
SOFTGL_INLINE BlockPlane block_plane(const Plane& p, int32_t x) {
  BlockPlane b;
  for (int i = 0; i < (kWidth < 8 ? 2 : 1); ++i) b.column[i] = splat(p.gx) * (splat(float(x)) + row_of_eight(i)) + splat(p.a);
  b.gy = splat(p.gy);
  return b;
}

/// A primitive whose fragments need no stage (RGBA8, no stencil): coverage, depth test, colour, blending, row by row.
template <bool DepthTest, DirectColor Color, int Edges>
static void direct_primitive(const RasterDraw& draw, const TileTarget& tile, const RasterPrimitive& p) {
  TileEdges edges;
  if (!clip_to_tile<Edges>(p, tile.x, tile.y, edges)) return;
  EdgeSteps<Edges> steps;
  if (!edges.inside) edge_steps<Edges>(edges, steps);
  const FragmentKey& key = draw.program->key;
  const float scale = depth_scale(key);
  const Compare function = Compare(key.depth_function);
  const bool less = function == Compare::Less;
  const IntV depth_mask = splat(key.depth_write ? 0xffffff : 0), color_mask = splat(int32_t(draw.color_mask));
  const bool flat = p.flat, divide = !p.flat && !p.w_is_one;
  const FloatV offset = splat(p.depth_offset);
  IntV constant_color = IntV{};
  if (flat) {
    const Plane* q = p.plane + kPlaneColor;
    constant_color = pack_color(splat(q[0].a), splat(q[1].a), splat(q[2].a), splat(q[3].a));
  }
  constexpr int kHalves = kWidth < 8 ? 2 : 1;       // vectors of a row
  constexpr int kRows = kWidth < 8 ? 1 : kWidth / 8; // rows of a vector
  for (int by = edges.y0 & ~7; by < edges.y1; by += 8) {
    const int first = edges.y0 > by ? (edges.y0 - by) & ~(kRows - 1) : 0, last = edges.y1 < by + 8 ? edges.y1 - by : 8;
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
      uint32_t* depth = tile.depth_stencil + pixel;

      // First all rows' coverage and depth without a branch (which rows live is hard to predict: measured), then the
      // colours of those that live.
      alignas(64) int32_t live_lanes[64];
      uint32_t live_vectors = 0;
      const uint64_t box = box_mask(edges, bx, by);
      const IntV columns[2] = {mask_of_bits(uint32_t(box >> (8 * first))), mask_of_bits(uint32_t(box >> (8 * first)) >> (kWidth & 7))};
      auto rows = [&](auto cut) __attribute__((always_inline)) {
        BlockPlane z;
        if constexpr (DepthTest) z = block_plane(p.plane[kPlaneZ], x);
        IntV v[Edges][kHalves] = {};
        if constexpr (cut)
          for (int i = 0; i < Edges; ++i)
            for (int h = 0; h < kHalves; ++h) v[i][h] = steps.column[i][h] + (e[i] + edges.b[i] * first);
        for (int row = first; row < last; row += kRows) {
          const FloatV py = kRows == 2 ? splat(float(y + row)) + row_number(0) : splat(float(y + row));
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
            if constexpr (DepthTest) {
              const IntV zi = depth_bits(z.gy * py + z.column[h] + offset, scale);
              const IntV stored = load(depth + at), old = stored & 0xffffff;
              live &= less ? zi < old : compare_words(function, zi, old);
              store(depth + at, choose(live & depth_mask, zi, stored));
            }
            store(live_lanes + at, live);
            live_vectors |= uint32_t(sign_bits(live) != 0) << (row * kHalves / kRows + h);
          }
        }
      };
      if (place == BlockPlace::Cut) rows(Yes{});
      else rows(No{});
      if (!live_vectors) continue;

      BlockPlane w, c[4];
      if (!flat) {
        w = block_plane(p.plane[kPlaneW], x);
        for (int k = 0; k < 4; ++k) c[k] = block_plane(p.plane[kPlaneColor + k], x);
      }
      do {
        const int i = __builtin_ctz(live_vectors), at = i * kWidth, h = kWidth < 8 ? i & 1 : 0;
        live_vectors &= live_vectors - 1;
        const IntV live = load(live_lanes + at);
        IntV source = constant_color;
        if (!flat) {
          const FloatV py = kRows == 2 ? splat(float(y + (at >> 3))) + row_number(0) : splat(float(y + (at >> 3)));
          FloatV a[4];
          for (int k = 0; k < 4; ++k) a[k] = c[k].gy * py + c[k].column[h];
          if (divide) {
            const FloatV r = splat(1.0f) / (w.gy * py + w.column[h]);
            for (int k = 0; k < 4; ++k) a[k] *= r;
          }
          source = pack_color(a[0], a[1], a[2], a[3]);
        }
        const IntV target = load(color + at);
        if constexpr (Color == DirectColor::Over) source = blend_over(source, target);
        if constexpr (Color == DirectColor::Any) {
          if (key.logic_op) source = logic_words(unsigned(key.blend_source_rgb), source, target);
          else source = blend_words(key, *draw.program->constants, source, target);
        }
        store(color + at, choose(live & color_mask, source, target));
      } while (live_vectors);
    }
  }
}

/// A primitive whose fragments go through the stages of its program.
template <bool Depth>
static void staged_primitive(const RasterDraw& draw, const TileTarget& tile, const RasterPrimitive& p, FragmentBlock& block) {
  TileEdges edges;
  if (!clip_to_tile<4>(p, tile.x, tile.y, edges)) return;
  const FragmentKey& key = draw.program->key;
  const Compare function = Compare(key.depth_function);
  const float scale = depth_scale(key);
  const bool early = Depth && !key.stencil;
  EdgeSteps<4> steps;
  if (!edges.inside) edge_steps<4>(edges, steps);
  StripBatch batch;
  for (int by = edges.y0 & ~7; by < edges.y1; by += 8) {
    for (int bx = edges.x0 & ~7; bx < edges.x1; bx += 8) {
      uint64_t covered = edges.inside ? box_mask(edges, bx, by) : block_coverage<4>(edges, steps, bx, by);
      const int pixel = pixel_in_tile(bx, by);
      for (int s = 0; covered; ++s, covered >>= kStripLanes) {
        const uint32_t mask = uint32_t(covered) & 0xffff;
        if (!mask) continue;
        const int32_t x = tile.x + bx, y = tile.y + by + 2 * s;
        const int lane = batch.strips * kStripLanes;
        uint32_t any = 0;
        for (int i = 0; i < kStripLanes / kWidth; ++i) {
          IntV live = mask_of_bits(mask >> (i * kWidth));
          const FloatV px = splat(float(x)) + row_of_eight(i), py = splat(float(y)) + row_number(i);
          if constexpr (Depth) {
            const IntV zi = depth_bits(at(p.plane[kPlaneZ], px, py) + p.depth_offset, scale);
            store(block.depth + lane + i * kWidth, zi);
            if (early) live &= compare_words(function, zi, load(tile.depth_stencil + pixel + s * kStripLanes + i * kWidth) & 0xffffff);
          }
          store(block.live + lane + i * kWidth, live);
          store(block.x + lane + i * kWidth, round_to_int(px));
          store(block.y + lane + i * kWidth, round_to_int(py));
          any |= sign_bits(live);
        }
        if (!any) continue;
        batch.pixel[batch.strips++] = pixel + s * kStripLanes;
        if (batch.strips == kLanes / kStripLanes) run_strips(draw, tile, p, block, batch);
      }
    }
  }
  if (batch.strips) run_strips(draw, tile, p, block, batch);
}

/// The records of a tile's primitives were written by another phase and lie in no near cache.
SOFTGL_INLINE void prefetch(const RasterPrimitive* const* primitive, int32_t i, int32_t count) {
  if (i + 4 >= count) return;
  const char* p = reinterpret_cast<const char*>(primitive[i + 4]);
  __builtin_prefetch(p), __builtin_prefetch(p + 64), __builtin_prefetch(p + 128);
}

/// Primitives at most so wide and high are shaded with lane = fragment, packed densely: measured on 10-pixel textured
/// triangles, strips leave five of six lanes dead.
constexpr int kDenseBox = 16;

/// Fragments of several small primitives of one draw, no two on the same pixel, on their way through the program.
struct DenseBatch {
  int32_t lanes = 0;
  uint32_t pixel[kLanes];
  const RasterPrimitive* primitive[kLanes];
  uint64_t used[kTilePixels / 64] = {}; // pixels of the batch, by 8x8 block
};

static void merge_fragments(const TileTarget& tile, const FragmentProgram& program, const uint32_t* pixel, int32_t count, MergeBlock& m);

static void run_dense(const RasterDraw& draw, const TileTarget& tile, FragmentBlock& block, DenseBatch& batch) {
  const int32_t count = batch.lanes;
  if (count == 0) return;
  block.lanes = (count + kStripLanes - 1) & ~(kStripLanes - 1);
  for (int i = 0; i < block.lanes; ++i) block.live[i] = i < count ? ~uint32_t(0) : 0;
  for (int i = count; i < block.lanes; ++i) { // dead lanes repeat the first
    block.x[i] = block.x[0], block.y[i] = block.y[0], block.depth[i] = 0;
    batch.primitive[i] = batch.primitive[0];
  }
  interpolate_lanes(draw, batch.primitive, block);
  const FragmentProgram& program = *draw.program;
  for (int i = 0; i < program.step_count; ++i) program.step[i].stage(block, *program.constants, program.step[i].unit);
  MergeBlock m;
  for (int i = 0; i < block.lanes; i += kWidth) {
    store(m.color + i, pack_color(load(block.color[0] + i), load(block.color[1] + i), load(block.color[2] + i), load(block.color[3] + i)));
    store(m.depth + i, load(block.depth + i));
    store(m.live + i, load(block.live + i));
  }
  merge_fragments(tile, program, batch.pixel, count, m);
  batch.lanes = 0;
  memset(batch.used, 0, sizeof batch.used);
}

template <bool Depth>
static void dense_primitive(const RasterDraw& draw, const TileTarget& tile, const RasterPrimitive& p, FragmentBlock& block, DenseBatch& batch) {
  TileEdges edges;
  if (!clip_to_tile<4>(p, tile.x, tile.y, edges)) return;
  const FragmentKey& key = draw.program->key;
  const Compare function = Compare(key.depth_function);
  const float scale = depth_scale(key);
  const bool early = Depth && !key.stencil;
  EdgeSteps<4> steps;
  if (!edges.inside) edge_steps<4>(edges, steps);
  for (int by = edges.y0 & ~7; by < edges.y1; by += 8)
    for (int bx = edges.x0 & ~7; bx < edges.x1; bx += 8) {
      uint64_t live = edges.inside ? box_mask(edges, bx, by) : block_coverage<4>(edges, steps, bx, by);
      if (!live) continue;
      const int first = pixel_in_tile(bx, by);
      uint64_t& used = batch.used[first >> 6];
      if (used & live) run_dense(draw, tile, block, batch);
      alignas(64) uint32_t depth[64];
      if constexpr (Depth) {
        const BlockPlane z = block_plane(p.plane[kPlaneZ], tile.x + bx);
        for (int i = 0; i < 64 / kWidth; ++i) {
          constexpr uint64_t kAll = (uint64_t(1) << (kWidth - 1) << 1) - 1;
          if (!(live >> (i * kWidth) & kAll)) continue;
          const FloatV py = kWidth == 16 ? splat(float(tile.y + by + 2 * i)) + row_number(0) : splat(float(tile.y + by + (i * kWidth >> 3)));
          const IntV zi = depth_bits(z.gy * py + z.column[kWidth < 8 ? i & 1 : 0] + p.depth_offset, scale);
          store(depth + i * kWidth, zi);
          if (early) {
            const IntV passes = compare_words(function, zi, load(tile.depth_stencil + first + i * kWidth) & 0xffffff);
            live &= ~(uint64_t(~sign_bits(passes) & uint32_t(kAll)) << (i * kWidth));
          }
        }
      }
      used |= live;
      for (; live; live &= live - 1) {
        const int bit = __builtin_ctzll(live), lane = batch.lanes++;
        block.x[lane] = tile.x + bx + (bit & 7);
        block.y[lane] = tile.y + by + (bit >> 3);
        if constexpr (Depth) block.depth[lane] = depth[bit];
        batch.pixel[lane] = uint32_t(first + bit);
        batch.primitive[lane] = &p;
        if (batch.lanes == kLanes) {
          run_dense(draw, tile, block, batch);
          used |= live & (live - 1); // what follows of this block
        }
      }
    }
}

template <bool Depth>
static void staged_primitives(const TileTarget& tile, const RasterDraw& draw, const RasterPrimitive* const* primitive, int32_t count, FragmentBlock& block) {
  const bool narrow = draw.small; // formats whose fragments are words
  DenseBatch batch;
  for (int32_t i = 0; i < count; ++i) {
    const RasterPrimitive& p = *primitive[i];
    prefetch(primitive, i, count);
    if (narrow && p.x1 - p.x0 <= kDenseBox && p.y1 - p.y0 <= kDenseBox) {
      dense_primitive<Depth>(draw, tile, p, block, batch);
    } else {
      run_dense(draw, tile, block, batch);
      staged_primitive<Depth>(draw, tile, p, block);
    }
  }
  run_dense(draw, tile, block, batch);
}

template <bool DepthTest, DirectColor Color>
static void direct_primitives(const TileTarget& tile, const RasterDraw& draw, const RasterPrimitive* const* primitive, int32_t count) {
  for (int32_t i = 0; i < count; ++i) {
    prefetch(primitive, i, count);
    if (primitive[i]->edges == 3) direct_primitive<DepthTest, Color, 3>(draw, tile, *primitive[i]);
    else direct_primitive<DepthTest, Color, 4>(draw, tile, *primitive[i]);
  }
}

template <bool DepthTest> static void direct_primitives(const TileTarget& tile, const RasterDraw& draw, const RasterPrimitive* const* primitive, int32_t count) {
  const FragmentKey& key = draw.program->key;
  if (is_over(key)) direct_primitives<DepthTest, DirectColor::Over>(tile, draw, primitive, count);
  else if (key.blend || key.logic_op) direct_primitives<DepthTest, DirectColor::Any>(tile, draw, primitive, count);
  else direct_primitives<DepthTest, DirectColor::Store>(tile, draw, primitive, count);
}

/// Draws primitives into a tile, in order.
static void tile_primitives(const TileTarget& tile, const RasterDraw& draw, const RasterPrimitive* const* primitive, int32_t count,
                            FragmentBlock& block) {
  const FragmentKey& key = draw.program->key;
  const bool depth = tile.depth_stencil && (Compare(key.depth_function) != Compare::Always || key.depth_write || key.stencil);
  if (draw.direct) {
    if (depth) direct_primitives<true>(tile, draw, primitive, count);
    else direct_primitives<false>(tile, draw, primitive, count);
    return;
  }
  if (depth) staged_primitives<true>(tile, draw, primitive, count, block);
  else staged_primitives<false>(tile, draw, primitive, count, block);
}

/// Merges `count` fragments that share no pixel; depth, colour and live of m are set.
static void merge_fragments(const TileTarget& tile, const FragmentProgram& program, const uint32_t* pixel, int32_t count, MergeBlock& m) {
  const bool words = ColorFormat(program.key.color_format) == ColorFormat::Rgba8;
  auto* color = static_cast<uint32_t*>(tile.color);
  auto* halves = static_cast<uint16_t*>(tile.color);
  m.lanes = (count + 15) & ~15;
  for (int32_t i = 0; i < count; ++i) m.target[i] = words ? color[pixel[i]] : expand_565(halves[pixel[i]]);
  if (tile.depth_stencil)
    for (int32_t i = 0; i < count; ++i) m.depth_stencil[i] = tile.depth_stencil[pixel[i]];
  for (int32_t i = count; i < m.lanes; ++i) m.live[i] = m.color[i] = m.target[i] = m.depth[i] = m.depth_stencil[i] = 0;
  merge_8(program, m);
  for (int32_t i = 0; i < count; ++i) {
    if (words) color[pixel[i]] = m.target[i];
    else halves[pixel[i]] = cut_565(m.target[i]);
  }
  if (tile.depth_stencil && (program.key.depth_write || program.key.stencil))
    for (int32_t i = 0; i < count; ++i) tile.depth_stencil[pixel[i]] = m.depth_stencil[i];
}

/// Merges finished fragments into a tile, in order.
static void tile_fragments(const TileTarget& tile, const RasterDraw& draw, const SmallFragment* fragment, int32_t count) {
  const FragmentProgram& program = *draw.program;
  const FragmentKey& key = program.key;
  if (draw.direct && !key.blend && !key.logic_op && Compare(key.depth_function) == Compare::Less && key.depth_write) {
    auto* color = static_cast<uint32_t*>(tile.color);
    uint32_t* depth = tile.depth_stencil;
    const uint32_t mask = draw.color_mask;
    for (int32_t i = 0; i < count; ++i) {
      const SmallFragment f = fragment[i];
      // Without a branch: which fragments pass is hard to predict.
      const uint32_t stored = depth[f.pixel], old = color[f.pixel];
      const uint32_t passes = f.depth < (stored & 0xffffff) ? ~uint32_t(0) : 0, depth_bits = passes & 0xffffff, color_bits = passes & mask;
      depth[f.pixel] = (stored & ~depth_bits) | (f.depth & depth_bits);
      color[f.pixel] = (old & ~color_bits) | (f.color & color_bits);
    }
    return;
  }
  uint64_t used[kTilePixels / 64] = {}; // pixels of the batch being gathered
  uint32_t pixel[kLanes];
  MergeBlock m;
  int32_t n = 0;
  auto finish = [&] {
    merge_fragments(tile, program, pixel, n, m);
    for (int32_t i = 0; i < n; ++i) used[pixel[i] >> 6] = 0;
    n = 0;
  };
  for (int32_t i = 0; i < count; ++i) {
    const SmallFragment& f = fragment[i];
    const uint64_t bit = uint64_t(1) << (f.pixel & 63);
    if (n == kLanes || (used[f.pixel >> 6] & bit)) finish();
    used[f.pixel >> 6] |= bit;
    pixel[n] = f.pixel, m.depth[n] = f.depth, m.color[n] = f.color, m.live[n] = ~uint32_t(0);
    ++n;
  }
  if (n) finish();
}

} // namespace SOFTGL_ISA
} // namespace softgl
