// Primitives whose fragments go through the stages of their program: strips of wide ones, densely packed
// lanes or quads of small ones.
#pragma once

#include "shaders/raster/raster_packed.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Strips of primitives of one draw, in order, on their way through the fragment program.
struct StripBatch {
  static constexpr int kMost = kLanes / kStripLanes;
  int32_t strips = 0;
  bool changes = false; // as of test_block(), of any of them
  int32_t pixel[kMost]; // pixel_in_tile of the strip's first pixel
  const RasterPrimitive* primitive[kMost];

  SOFTGL_MEMBER bool full() const { return strips == kMost; }
  SOFTGL_MEMBER void add(const RasterPrimitive& p, int32_t first_pixel, bool strip_changes) {
    pixel[strips] = first_pixel, primitive[strips++] = &p, changes |= strip_changes;
  }
  SOFTGL_MEMBER void clear() { strips = 0, changes = false; }
};

/// Fills the inputs of a block's strips.
template <bool FromCorner = false>
static void interpolate_strips(const RasterDraw& draw, const StripBatch& batch, FragmentBlock& block) {
  block.lanes = batch.strips * kStripLanes;
  for (int first = 0; first < batch.strips;) {
    const RasterPrimitive* p = batch.primitive[first];
    int end = first + 1;
    while (end < batch.strips && batch.primitive[end] == p) ++end;
    interpolate_block<FromCorner>(draw, *p, first * kStripLanes, end * kStripLanes, block);
    first = end;
  }
}

/// A block's final colors as RGBA8 words; nothing where the surface does not keep words.
static void pack_block(const RasterDraw& draw, const FragmentBlock& block, uint32_t* words) {
  const auto format = ColorFormat(draw.program->key.color_format);
  if (format != ColorFormat::Rgba8 && format != ColorFormat::Rgb565) return;
  for (int i = 0; i < block.lanes; i += kWidth)
    store(words + i, pack_color(load(block.color[0] + i), load(block.color[1] + i), load(block.color[2] + i),
                                load(block.color[3] + i)));
}

/// Merges colors of a strip of `block`, lanes from `first` on where `live` is set, with the pixels from
/// `pixel` on. `words`: as of pack_block().
SOFTGL_INLINE void merge_colors(const EncodedMerger& encoded, const FragmentBlock& block,
                                const uint32_t* words, int first, const uint32_t* live, void* color,
                                int pixel) {
  const Merger& merger = encoded.merger;
  const auto format = ColorFormat(merger.key.color_format);
  if (format == ColorFormat::Rgba8 && !merger.key.encoded) {
    uint32_t* target = static_cast<uint32_t*>(color) + pixel;
    for (int i = 0; i < kStripLanes; i += kWidth)
      merger.color(load(live + i), load(words + first + i), target + i);
    return;
  }
  if (format == ColorFormat::Rgb565) {
    uint16_t* halves = static_cast<uint16_t*>(color) + pixel;
    for (int i = 0; i < kStripLanes; i += kWidth) {
      const IntV kept = load_halves(halves + i), there = expand_565(kept);
      const IntV drawn = cut_565(
          choose(load(live + i) & merger.mask, merger.blended(load(words + first + i), there), there));
      store_halves(halves + i, (drawn << 16) >> 16);
    }
    return;
  }
  encoded.strip(block, first, words + first, live, color, size_t(pixel));
}

/// Merges a strip of `block` whose colors are final, lanes from `first` on, with the pixels from `pixel` on.
/// `live` and `depth` are the strip's.
SOFTGL_INLINE void merge_strip(const EncodedMerger& encoded, const TileTarget& tile,
                               const FragmentBlock& block, const uint32_t* words, int first, int pixel,
                               uint32_t* live, const uint32_t* depth) {
  IntV living = IntV{};
  for (int i = 0; i < kStripLanes; i += kWidth) {
    IntV v = load(live + i);
    if (tile.depth_stencil) {
      v = encoded.merger.depth_stencil(v, load(depth + i), tile.depth_stencil + (pixel + i));
      store(live + i, v);
    }
    if (tile.samples) *tile.samples += count_lanes(v);
    living |= v;
  }
  if (any(living)) merge_colors(encoded, block, words, first, live, tile.color, pixel);
}

/// Merges the strips of `block` whose colors are final.
static void merge_strips(const RasterDraw& draw, const TileTarget& tile, FragmentBlock& block,
                         const StripBatch& batch) {
  const Merger merger{*draw.program};
  const EncodedMerger encoded{merger};
  alignas(64) uint32_t words[kLanes];
  pack_block(draw, block, words);
  for (int s = 0; s < batch.strips; ++s) {
    const int first = s * kStripLanes;
    merge_strip(encoded, tile, block, words, first, batch.pixel[s], block.live + first, block.depth + first);
  }
}

static void run_strips(const RasterDraw& draw, const TileTarget& tile, FragmentBlock& block,
                       StripBatch& batch) {
  if (batch.strips == 0) return;
  interpolate_strips(draw, batch, block);
  run_stages(*draw.program, block);
  merge_strips(draw, merged_tile(draw, tile, batch.changes), block, batch);
  batch.clear();
}

// Of the lanes of a strip, from its first pixel.
alignas(64) static constexpr int32_t kStripColumn[kStripLanes] = {0, 1, 2, 3, 4, 5, 6, 7,
                                                                  0, 1, 2, 3, 4, 5, 6, 7};
alignas(64) static constexpr int32_t kStripRow[kStripLanes] = {0, 0, 0, 0, 0, 0, 0, 0,
                                                               1, 1, 1, 1, 1, 1, 1, 1};

/// A primitive whose fragments go through the stages of its program, by strips.
template <bool Depth, int Edges> static void strips_primitive(const RasterDraw& draw, const TileTarget& tile,
                                                              const RasterPrimitive& p, FragmentBlock& block,
                                                              StripBatch& batch) {
  TileEdges edges;
  if (!clip_to_tile<Edges>(draw, p, tile.x, tile.y, edges)) return;
  const uint64_t* stipple =
      Edges == 3 ? draw.raster->stipple : nullptr; // triangles only: not lines and points
  EdgeSteps<Edges> steps;
  edge_steps<Edges>(p, steps);
  for (int by = edges.y0 & ~7; by < edges.y1; by += 8) {
    for (int bx = edges.x0 & ~7; bx < edges.x1; bx += 8) {
      uint64_t live = edges.inside ? box_mask(edges, bx, by) : block_coverage<Edges>(edges, steps, bx, by);
      if (stipple) live &= stipple[(by >> 1 & 12) | (bx >> 3 & 3)]; // tiles begin at multiples of 32
      if (!live) continue;
      alignas(64) uint32_t depth[64];
      const int pixel = pixel_in_tile(bx, by);
      bool changes = false;
      if constexpr (Depth)
        live = test_block(draw, p, float(tile.x + bx), float(tile.y + by), live, tile.depth_stencil + pixel,
                          depth, changes);
      for (int s = 0; live; s += kStripLanes, live >>= kStripLanes) {
        const uint32_t mask = uint32_t(live) & 0xffff;
        if (!mask) continue;
        const int lane = batch.strips * kStripLanes;
        const IntV x = splat(tile.x + bx), y = splat(tile.y + by + (s >> 3));
        for (int i = 0; i < kStripLanes; i += kWidth) {
          if constexpr (Depth) store(block.depth + lane + i, load(depth + s + i));
          store(block.live + lane + i, mask_of_bits(mask >> i));
          store(block.x + lane + i, x + load(kStripColumn + i));
          store(block.y + lane + i, y + load(kStripRow + i));
        }
        batch.add(p, pixel + s, changes);
        if (batch.full()) run_strips(draw, tile, block, batch);
      }
    }
  }
}

/// Points of so many pixels are cut into strips, of which they fill enough lanes: a million textured pixels
/// in points of 16x16 take 7.9 ms, packed densely 15.3; of 6x6 16.4 and 25.5, of 4x4 26.7 and 28.7, of
/// 3x3 43.7 and 40.3.
constexpr int32_t kStripsPixels = 16;

template <bool Depth> static void staged_primitives(const TileTarget& tile, const RasterDraw& draw,
                                                    const RasterPrimitive* const* primitive, int32_t count,
                                                    FragmentBlock& block) {
  // The most pixels a side of primitives that are not cut into strips.
  const int32_t box = draw.small ? kDenseBox : draw.quads ? kQuadsBox : 0;
  StripBatch strips;
  PackedBatch packed;
  for (int32_t i = 0; i < count; ++i) {
    const RasterPrimitive& p = *primitive[i];
    prefetch(primitive, i, count);
    const int32_t width = p.x1 - p.x0, height = p.y1 - p.y0;
    if (width > box || height > box || (p.edges == 0 && width * height >= kStripsPixels)) {
      run_packed(draw, tile, block, packed);
      if (p.edges == 3)
        strips_primitive<Depth, 3>(draw, tile, p, block, strips);
      else
        strips_primitive<Depth, 4>(draw, tile, p, block, strips);
      continue;
    }
    run_strips(draw, tile, block, strips);
    if (p.edges == 3)
      packed_primitive<Depth, 3>(draw, tile, p, block, packed);
    else
      packed_primitive<Depth, 4>(draw, tile, p, block, packed);
  }
  run_strips(draw, tile, block, strips);
  run_packed(draw, tile, block, packed);
}

} // namespace SOFTGL_ISA
} // namespace softgl
