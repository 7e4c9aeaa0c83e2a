// Primitives whose fragments go through the stages of their program: strips of wide ones, densely packed
// lanes of small ones.
#pragma once

#include "shaders/raster/raster_block.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Strips of one primitive on their way through the fragment program.
struct StripBatch {
  int32_t strips = 0;
  int32_t pixel[kLanes / kStripLanes]; // pixel_in_tile of the strip's first pixel
};

/// Merges a strip of `block` whose colors are final, lanes from `first` on, with the pixels from `pixel` on.
/// `live` and `depth` are the strip's.
SOFTGL_INLINE void merge_strip(const Merger& merger, const TileTarget& tile, const FragmentBlock& block,
                               int first, int pixel, uint32_t* live, const uint32_t* depth) {
  const auto format = ColorFormat(merger.key.color_format);
  if (tile.depth_stencil)
    for (int i = 0; i < kStripLanes; i += kWidth)
      store(live + i,
            merger.depth_stencil(load(live + i), load(depth + i), tile.depth_stencil + (pixel + i)));
  if (tile.samples)
    for (int i = 0; i < kStripLanes; i += kWidth) *tile.samples += count_lanes(load(live + i));
  if (format == ColorFormat::Rgb565 || (format == ColorFormat::Rgba8 && !merger.key.encoded)) {
    uint32_t expanded[kStripLanes];
    uint32_t* words = format == ColorFormat::Rgba8 ? static_cast<uint32_t*>(tile.color) + pixel : expanded;
    uint16_t* halves = static_cast<uint16_t*>(tile.color) + pixel;
    if (format == ColorFormat::Rgb565)
      for (int i = 0; i < kStripLanes; ++i) expanded[i] = expand_565(halves[i]);
    for (int i = 0; i < kStripLanes; i += kWidth)
      merger.color(load(live + i),
                   pack_color(load(block.color[0] + first + i), load(block.color[1] + first + i),
                              load(block.color[2] + first + i), load(block.color[3] + first + i)),
                   words + i);
    if (format == ColorFormat::Rgb565)
      for (int i = 0; i < kStripLanes; ++i) halves[i] = cut_565(expanded[i]);
    return;
  }
  for (int i = 0; i < kStripLanes; ++i) {
    if (!live[i]) continue;
    const float color[4] = {block.color[0][first + i], block.color[1][first + i], block.color[2][first + i],
                            block.color[3][first + i]};
    store_encoded(merger.program, color, tile.color, size_t(pixel + i));
  }
}

/// Merges the strips of `block` whose colors are final.
static void merge_strips(const RasterDraw& draw, const TileTarget& tile, FragmentBlock& block,
                         const StripBatch& batch) {
  const Merger merger{*draw.program};
  for (int s = 0; s < batch.strips; ++s) {
    const int first = s * kStripLanes;
    merge_strip(merger, tile, block, first, batch.pixel[s], block.live + first, block.depth + first);
  }
}

static void run_strips(const RasterDraw& draw, const TileTarget& tile, const RasterPrimitive& p,
                       FragmentBlock& block, StripBatch& batch) {
  block.lanes = batch.strips * kStripLanes;
  interpolate_block(draw, p, block);
  const FragmentProgram& program = *draw.program;
  for (int i = 0; i < program.step_count; ++i)
    program.step[i].stage(block, *program.constants, program.step[i].unit);
  merge_strips(draw, tile, block, batch);
  batch.strips = 0;
}

/// Merges `count` fragments that share no pixel; depth, color and live of m are set.
static void merge_fragments(const TileTarget& tile, const FragmentProgram& program, const uint32_t* pixel,
                            int32_t count, MergeBlock& m) {
  const bool words = ColorFormat(program.key.color_format) == ColorFormat::Rgba8;
  auto* color = static_cast<uint32_t*>(tile.color);
  auto* halves = static_cast<uint16_t*>(tile.color);
  m.lanes = (count + 15) & ~15;
  for (int32_t i = 0; i < count; ++i) m.target[i] = words ? color[pixel[i]] : expand_565(halves[pixel[i]]);
  if (tile.depth_stencil)
    for (int32_t i = 0; i < count; ++i) m.depth_stencil[i] = tile.depth_stencil[pixel[i]];
  for (int32_t i = count; i < m.lanes; ++i)
    m.live[i] = m.color[i] = m.target[i] = m.depth[i] = m.depth_stencil[i] = 0;
  const Merger merger{program};
  for (int i = 0; i < m.lanes; i += kWidth) {
    const IntV live = merger.depth_stencil(load(m.live + i), load(m.depth + i), m.depth_stencil + i);
    if (tile.samples) *tile.samples += count_lanes(live);
    merger.color(live, load(m.color + i), m.target + i);
  }
  for (int32_t i = 0; i < count; ++i) {
    if (words)
      color[pixel[i]] = m.target[i];
    else
      halves[pixel[i]] = cut_565(m.target[i]);
  }
  if (tile.depth_stencil && (program.key.depth_write || program.key.stencil))
    for (int32_t i = 0; i < count; ++i) tile.depth_stencil[pixel[i]] = m.depth_stencil[i];
}

/// A primitive whose fragments go through the stages of its program.
template <bool Depth> static void staged_primitive(const RasterDraw& draw, const TileTarget& tile,
                                                   const RasterPrimitive& p, FragmentBlock& block) {
  TileEdges edges;
  if (!clip_to_tile<4>(draw, p, tile.x, tile.y, edges)) return;
  const FragmentKey& key = draw.program->key;
  const Compare function = Compare(key.depth_function);
  const float scale = depth_scale(key);
  const bool early = Depth && draw.early_depth, floats = DepthFormat(key.depth_format) == DepthFormat::Z32F;
  const uint64_t* stipple =
      p.edges == 3 ? draw.raster->stipple : nullptr; // triangles only: not lines and points
  EdgeSteps<4> steps;
  if (!edges.inside) edge_steps<4>(edges, steps);
  StripBatch batch;
  for (int by = edges.y0 & ~7; by < edges.y1; by += 8) {
    for (int bx = edges.x0 & ~7; bx < edges.x1; bx += 8) {
      uint64_t covered = edges.inside ? box_mask(edges, bx, by) : block_coverage<4>(edges, steps, bx, by);
      if (stipple) covered &= stipple[(by >> 1 & 12) | (bx >> 3 & 3)]; // tiles begin at multiples of 32
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
            const FloatV z = at(p.plane[kPlaneZ], px, py) + p.depth_offset;
            const IntV zi = floats ? depth_float(z) : depth_bits(z, scale);
            store(block.depth + lane + i * kWidth, zi);
            if (early)
              live &= compare_words(
                  function, zi, load(tile.depth_stencil + pixel + s * kStripLanes + i * kWidth) & 0xffffff);
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

/// Primitives at most so wide and high are shaded with lane = fragment, packed densely: measured on 10-pixel
/// textured triangles, strips leave five of six lanes dead.
constexpr int kDenseBox = 16;

/// Fragments of several small primitives of one draw, no two on the same pixel, on their way through the
/// program.
struct DenseBatch {
  int32_t lanes = 0;
  uint32_t pixel[kLanes];
  const RasterPrimitive* primitive[kLanes];
  uint64_t used[kTilePixels / 64] = {}; // pixels of the batch, by 8x8 block
};

static void run_dense(const RasterDraw& draw, const TileTarget& tile, FragmentBlock& block,
                      DenseBatch& batch) {
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
  for (int i = 0; i < program.step_count; ++i)
    program.step[i].stage(block, *program.constants, program.step[i].unit);
  MergeBlock m;
  for (int i = 0; i < block.lanes; i += kWidth) {
    store(m.color + i, pack_color(load(block.color[0] + i), load(block.color[1] + i),
                                  load(block.color[2] + i), load(block.color[3] + i)));
    store(m.depth + i, load(block.depth + i));
    store(m.live + i, load(block.live + i));
  }
  merge_fragments(tile, program, batch.pixel, count, m);
  batch.lanes = 0;
  memset(batch.used, 0, sizeof batch.used);
}

template <bool Depth> static void dense_primitive(const RasterDraw& draw, const TileTarget& tile,
                                                  const RasterPrimitive& p, FragmentBlock& block,
                                                  DenseBatch& batch) {
  TileEdges edges;
  if (!clip_to_tile<4>(draw, p, tile.x, tile.y, edges)) return;
  const FragmentKey& key = draw.program->key;
  const Compare function = Compare(key.depth_function);
  const float scale = depth_scale(key);
  const bool early = Depth && draw.early_depth;
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
          const FloatV py = kWidth == 16 ? splat(float(tile.y + by + 2 * i)) + row_number(0)
                                         : splat(float(tile.y + by + (i * kWidth >> 3)));
          const IntV zi = depth_bits(z.gy * py + z.column[kWidth < 8 ? i & 1 : 0] + p.depth_offset, scale);
          store(depth + i * kWidth, zi);
          if (early) {
            const IntV passes =
                compare_words(function, zi, load(tile.depth_stencil + first + i * kWidth) & 0xffffff);
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

template <bool Depth> static void staged_primitives(const TileTarget& tile, const RasterDraw& draw,
                                                    const RasterPrimitive* const* primitive, int32_t count,
                                                    FragmentBlock& block) {
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

} // namespace SOFTGL_ISA
} // namespace softgl
