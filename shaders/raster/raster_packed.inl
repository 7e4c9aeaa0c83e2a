// Small primitives whose fragments go through the stages of their program: those of several primitives
// packed densely into a block.
#pragma once

#include "shaders/raster/raster_early.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Merges fragments with a tile's pixels, in order: as many at a time as a vector has lanes, less where two
/// lie on one pixel.
static void merge_fragments(const TileTarget& tile, const FragmentProgram& program,
                            const SmallFragments& fragments, int32_t count) {
  const Merger merger{program};
  const bool writes_depth = program.key.depth_write || program.key.stencil;
  const bool words = ColorFormat(program.key.color_format) == ColorFormat::Rgba8;
  auto* colors = static_cast<uint32_t*>(tile.color);
  auto* halves = static_cast<uint16_t*>(tile.color);
  for (int32_t first = 0; first < count;) {
    alignas(64) uint16_t pixel[kWidth];
    alignas(64) uint32_t depth[kWidth], color[kWidth], there[kWidth];
    // Lanes behind the last fragment repeat the first, and so are left out.
    const int32_t left = count - first;
    if (left >= kWidth) {
      memcpy(pixel, fragments.pixel + first, sizeof pixel);
      store(depth, load(fragments.depth + first)), store(color, load(fragments.color + first));
    } else {
      for (int k = 0; k < kWidth; ++k) {
        const int32_t i = first + (k < left ? k : 0);
        pixel[k] = fragments.pixel[i], depth[k] = fragments.depth[i], color[k] = fragments.color[i];
      }
    }
    const int lanes = distinct_lanes(load_halves(pixel));
    first += lanes;
    IntV live = mask_of_bits((1u << lanes) - 1);
    if (tile.depth_stencil && merger.tests) {
      uint32_t* place = tile.depth_stencil;
      store(there, load_words([&](int k) __attribute__((always_inline)) { return place + pixel[k]; }));
      live = merger.word_depth_stencil(live, load(depth), there);
      if (writes_depth)
        for (int k = 0; k < lanes; ++k) place[pixel[k]] = there[k];
      if (!any(live)) continue;
    }
    if (tile.samples) *tile.samples += count_lanes(live);
    if (words) {
      store(there, load_words([&](int k) __attribute__((always_inline)) { return colors + pixel[k]; }));
      merger.color(live, load(color), there);
      for (int k = 0; k < lanes; ++k) colors[pixel[k]] = there[k];
    } else {
      for (int k = 0; k < kWidth; ++k) there[k] = expand_565(uint32_t(halves[pixel[k]]));
      merger.color(live, load(color), there);
      for (int k = 0; k < lanes; ++k) halves[pixel[k]] = uint16_t(cut_565(there[k]));
    }
  }
}

/// The tile as the end of fragments sees it: without depths that are tested and written before. `changes`: a
/// fragment among them has a depth that is not the stored one. Without one, as where a light is added to what
/// the light before it has drawn, no test can end otherwise than before.
SOFTGL_INLINE TileTarget merged_tile(const RasterDraw& draw, TileTarget tile, bool changes) {
  if (draw.final_depth || (draw.lasting_depth && !changes)) tile.depth_stencil = nullptr;
  return tile;
}

/// Primitives at most so wide and high are shaded with lane = fragment, packed densely: lines and points, and
/// triangles that are not small ones. Measured on 10-pixel textured triangles, strips leave five of six lanes
/// dead. Of 16 to 32 pixels strips are faster.
constexpr int kDenseBox = 16;
/// The same where the lanes of whole 2x2 quads are needed.
constexpr int kQuadsBox = 32;

/// Fragments of several small primitives of one draw, in order, on their way through the program: one a lane,
/// or by quads, of which lanes may be dead. The lanes of a quad lie as in a strip; so of two on one pixel the
/// later one has the higher lane, too.
struct PackedBatch {
  int32_t lanes = 0;    // or four times the quads
  bool changes = false; // as of test_block(), of any of them
  uint16_t pixel[kLanes];
  const RasterPrimitive* primitive[kLanes];
};

/// The first lane of quad n of a block.
SOFTGL_INLINE int lane_of_quad(int n) { return (n & ~3) * 4 + (n & 3) * 2; }

/// Dead lanes behind the last ones repeat the first, up to the end of the strip.
static void fill_last_strip(const RasterDraw& draw, FragmentBlock& block, PackedBatch& batch) {
  block.lanes = (batch.lanes + kStripLanes - 1) & ~(kStripLanes - 1);
  auto repeat = [&](int to, int from) {
    block.x[to] = block.x[from], block.y[to] = block.y[from];
    block.depth[to] = block.live[to] = 0;
    batch.primitive[to] = batch.primitive[from];
  };
  if (!draw.quads) {
    for (int i = batch.lanes; i < block.lanes; ++i) repeat(i, 0);
    return;
  }
  for (int n = batch.lanes / 4; n < block.lanes / 4; ++n)
    for (int i = 0; i < 4; ++i) {
      const int lane = (i & 1) + (i & 2) * 4;
      repeat(lane_of_quad(n) + lane, lane);
    }
}

static void run_packed(const RasterDraw& draw, const TileTarget& tile, FragmentBlock& block,
                       PackedBatch& batch) {
  if (batch.lanes == 0) return;
  fill_last_strip(draw, block, batch);
  if (draw.quads)
    interpolate_lanes<true>(draw, batch.primitive, block);
  else
    interpolate_lanes<false>(draw, batch.primitive, block);
  const FragmentProgram& program = *draw.program;
  run_stages(program, block);
  alignas(64) uint32_t color[kLanes];
  for (int i = 0; i < block.lanes; i += kWidth)
    store(color + i, pack_color(load(block.color[0] + i), load(block.color[1] + i), load(block.color[2] + i),
                                load(block.color[3] + i)));
  int32_t count = 0;
  for (int i = 0; i < block.lanes; ++i) {
    color[count] = color[i], block.depth[count] = block.depth[i], batch.pixel[count] = batch.pixel[i];
    count += block.live[i] != 0;
  }
  merge_fragments(merged_tile(draw, tile, batch.changes), program, {batch.pixel, block.depth, color}, count);
  batch.lanes = 0, batch.changes = false;
}

/// The quads of an 8x8 block, by the bits of their first pixels, that have a pixel of `live`.
SOFTGL_INLINE uint64_t quads_of(uint64_t live) {
  live |= live >> 8;
  return (live | live >> 1) & 0x0055005500550055u;
}

template <bool Depth, int Edges> static void packed_primitive(const RasterDraw& draw, const TileTarget& tile,
                                                              const RasterPrimitive& p, FragmentBlock& block,
                                                              PackedBatch& batch) {
  TileEdges edges;
  if (!clip_to_tile<Edges>(draw, p, tile.x, tile.y, edges)) return;
  EdgeSteps<Edges> steps;
  edge_steps<Edges>(p, steps);
  for (int by = edges.y0 & ~7; by < edges.y1; by += 8)
    for (int bx = edges.x0 & ~7; bx < edges.x1; bx += 8) {
      uint64_t live = edges.inside ? box_mask(edges, bx, by) : block_coverage<Edges>(edges, steps, bx, by);
      if (!live) continue;
      alignas(64) uint32_t depth[64];
      const int first = pixel_in_tile(bx, by);
      bool changes = false;
      if constexpr (Depth)
        live = test_block(draw, p, float(tile.x + bx), float(tile.y + by), live, tile.depth_stencil + first,
                          depth, changes);
      if (!live) continue;
      auto put = [&](int lane, int bit) __attribute__((always_inline)) {
        block.x[lane] = tile.x + bx + (bit & 7);
        block.y[lane] = tile.y + by + (bit >> 3);
        const auto mask = uint32_t(mask_of(live >> bit & 1));
        block.live[lane] = mask;
        if constexpr (Depth) block.depth[lane] = depth[bit] & mask;
        batch.pixel[lane] = uint16_t(first + bit);
        batch.primitive[lane] = &p;
      };
      const int step = draw.quads ? 4 : 1;
      for (uint64_t left = draw.quads ? quads_of(live) : live; left; left &= left - 1) {
        const int bit = __builtin_ctzll(left);
        if (draw.quads) {
          const int lane = lane_of_quad(batch.lanes / 4);
          put(lane, bit), put(lane + 1, bit + 1), put(lane + 8, bit + 8), put(lane + 9, bit + 9);
        } else {
          put(batch.lanes, bit);
        }
        batch.lanes += step, batch.changes |= changes;
        if (batch.lanes == kLanes) run_packed(draw, tile, block, batch);
      }
    }
}

} // namespace SOFTGL_ISA
} // namespace softgl
