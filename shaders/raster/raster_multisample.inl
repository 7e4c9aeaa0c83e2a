// Primitives on surfaces whose pixels have several samples (GL 1.5, 3.2.1): coverage, stencil, depth and
// color are of a sample, the stages run once a pixel, at its center.
#pragma once

#include "shaders/raster/raster_staged.inl"
#include "shaders/raster/sample_points.h"

namespace softgl {
namespace SOFTGL_ISA {

/// What samples know apart from the strips of their pixels.
struct SampleBatch {
  StripBatch pixels;
  uint16_t covered[kSamples][kLanes / kStripLanes]; // bit i: lane i of the strip
  alignas(64) uint32_t depth[kSamples][kLanes];     // unless they are final
};

/// Lanes of a strip whose alpha is large enough for a sample: as OSMesa 22.3.6, the first samples go last.
SOFTGL_INLINE IntV covered_by_alpha(FloatV alpha, int sample) {
  return (IntV)(alpha > splat(float(sample) / kSamples));
}

/// Merges the samples of the strips of `block` whose colors are final.
static void merge_samples(const RasterDraw& draw, const TileTarget& tile, FragmentBlock& block,
                          const SampleBatch& batch) {
  const RasterConstants& r = *draw.raster;
  const Merger merger{*draw.program};
  const EncodedMerger encoded{merger};
  const bool by_alpha = r.per_sample && r.alpha_to_coverage, one = r.per_sample && r.alpha_to_one;
  const bool replaces = draw.replaces_words && !tile.depth_stencil && !by_alpha,
             drops = draw.program->drops();
  const int step = depth_step(DepthFormat(merger.key.depth_format));
  alignas(64) float alpha[kLanes];
  for (int i = 0; i < block.lanes; i += kWidth) {
    store(alpha + i, load(block.color[3] + i));
    if (one) store(block.color[3] + i, splat(1.0f));
  }
  alignas(64) uint32_t words[kLanes];
  pack_block(draw, block, words);
  for (int s = 0; s < kSamples; ++s) {
    TileTarget samples = tile;
    samples.color = static_cast<uint8_t*>(tile.color) + size_t(s) * tile.color_step;
    if (tile.depth_stencil) samples.depth_stencil += s * kTilePixels * step;
    const uint32_t* depth = draw.program->writes_depth ? block.depth : batch.depth[s];
    for (int k = 0; k < batch.pixels.strips; ++k) {
      const int first = k * kStripLanes;
      const uint32_t covered = batch.covered[s][k];
      if (!covered) continue;
      if (replaces) {
        uint32_t* target = static_cast<uint32_t*>(samples.color) + batch.pixels.pixel[k];
        const bool whole = covered == (1u << kStripLanes) - 1 && !drops;
        for (int i = 0; whole && i < kStripLanes; i += kWidth) store(target + i, load(words + first + i));
        for (int i = 0; !whole && i < kStripLanes; i += kWidth) {
          const IntV live = load(block.live + first + i) & mask_of_bits(covered >> i);
          store(target + i, choose(live, load(words + first + i), load(target + i)));
        }
        continue;
      }
      alignas(64) uint32_t live[kStripLanes];
      for (int i = 0; i < kStripLanes; i += kWidth) {
        IntV v = load(block.live + first + i) & mask_of_bits(covered >> i);
        if (by_alpha) v &= covered_by_alpha(load(alpha + first + i), s);
        store(live + i, v);
      }
      merge_strip(merger, encoded, samples, block, words, first, batch.pixels.pixel[k], live, depth + first);
    }
  }
}

static void run_samples(const RasterDraw& draw, const TileTarget& tile, FragmentBlock& block,
                        SampleBatch& batch) {
  if (batch.pixels.strips == 0) return;
  if (draw.raster->per_sample)
    interpolate_strips<true>(draw, batch.pixels, block);
  else
    interpolate_strips<false>(draw, batch.pixels, block);
  run_stages(*draw.program, block);
  merge_samples(draw, merged_tile(draw, tile, batch.pixels.changes), block, batch);
  batch.pixels.clear();
}

namespace { // so that no member is visible outside

/// Which samples of a tile's pixels a primitive covers: where coverage is the pixel's, all of a covered one.
template <int Edges> struct SampleCoverage {
  TileEdges edges[kSamples];
  EdgeSteps<Edges> steps;      // the same for all samples
  TileEdges widest, narrowest; // outside and inside of these no sample is covered, and all are
  bool seen[kSamples];
  bool any = false, all = true; // samples are seen
  bool per_sample;
  bool round;
  int64_t center_x, center_y, radius2; // of a round one, from the tile's corner

  SOFTGL_MEMBER SampleCoverage(const RasterDraw& draw, const RasterPrimitive& p, const TileTarget& tile)
      : per_sample(draw.raster->per_sample), round(p.round), center_x(p.c[0] - 256 * tile.x),
        center_y(p.c[1] - 256 * tile.y), radius2(p.c[2]) {
    edge_steps<Edges>(p, steps);
    for (int s = 0; s < (per_sample ? kSamples : 1); ++s) {
      int64_t c[Edges];
      for (int i = 0; i < Edges; ++i)
        c[i] = round        ? 0
               : per_sample ? (p.c[i] - int64_t(p.a[i]) * kSampleX[s] + int64_t(p.b[i]) * kSampleY[s]) >> 8
                            : p.c[i];
      seen[s] = clip_to_tile<Edges>(draw, p, c, tile.x, tile.y, edges[s]);
      all = all && seen[s];
      if (!seen[s]) continue;
      if (!any) widest = narrowest = edges[s];
      for (int i = 0; i < Edges; ++i) {
        widest.c[i] = widest.c[i] > edges[s].c[i] ? widest.c[i] : edges[s].c[i];
        narrowest.c[i] = narrowest.c[i] < edges[s].c[i] ? narrowest.c[i] : edges[s].c[i];
      }
      any = true;
    }
  }
  /// Most blocks around a line.
  SOFTGL_MEMBER bool misses_block(int x, int y) const {
    int32_t e[Edges];
    return !any || place_block<Edges>(widest, x, y, e) == BlockPlace::Outside;
  }
  /// Of the block at (x, y) of the tile.
  SOFTGL_MEMBER void of_block(int x, int y, uint64_t covered[kSamples]) const {
    int32_t e[Edges];
    if (all && !round && place_block<Edges>(narrowest, x, y, e) == BlockPlace::Inside) {
      for (int s = 0; s < kSamples; ++s) covered[s] = box_mask(narrowest, x, y);
      return;
    }
    for (int s = 0; s < kSamples; ++s) {
      if (s > 0 && !per_sample)
        covered[s] = covered[0];
      else if (!seen[s])
        covered[s] = 0;
      else
        covered[s] =
            edges[s].inside ? box_mask(edges[s], x, y) : block_coverage<Edges>(edges[s], steps, x, y);
      if (round) covered[s] &= in_circle(x, y, s);
    }
  }
  uint64_t in_circle(int x, int y, int s) const {
    uint64_t mask = 0;
    for (int i = 0; i < 64; ++i) {
      const int64_t dx = (x + (i & 7)) * 256 + kSampleX[s] - center_x,
                    dy = (y + (i >> 3)) * 256 + kSampleY[s] - center_y;
      mask |= uint64_t(dx * dx + dy * dy <= radius2) << i;
    }
    return mask;
  }
};

} // namespace

template <bool Depth, int Edges>
static void multisampled_primitive(const RasterDraw& draw, const TileTarget& tile, const RasterPrimitive& p,
                                   FragmentBlock& block, SampleBatch& batch) {
  const SampleCoverage<Edges> coverage(draw, p, tile);
  const FragmentProgram& program = *draw.program;
  const float scale = depth_scale(program.key);
  const bool floats = DepthFormat(program.key.depth_format) == DepthFormat::Z32F;
  const int step = depth_step(DepthFormat(program.key.depth_format));
  const RasterConstants& r = *draw.raster;
  const uint64_t* stipple = Edges == 3 ? r.stipple : nullptr; // triangles only: not lines and points
  const int32_t x0 = p.x0 > tile.x ? p.x0 - tile.x : 0, y0 = p.y0 > tile.y ? p.y0 - tile.y : 0;
  const int32_t x1 = p.x1 < tile.x + kTileSize ? p.x1 - tile.x : kTileSize,
                y1 = p.y1 < tile.y + kTileSize ? p.y1 - tile.y : kTileSize;
  for (int by = y0 & ~7; by < y1; by += 8) {
    for (int bx = x0 & ~7; bx < x1; bx += 8) {
      if (coverage.misses_block(bx, by)) continue;
      const float x = float(tile.x + bx), y = float(tile.y + by);
      const int pixel = pixel_in_tile(bx, by);
      uint64_t live[kSamples], any = 0;
      bool changes = false;
      coverage.of_block(bx, by, live);
      alignas(64) uint32_t depth[kSamples][64];
      for (int s = 0; s < kSamples; ++s) {
        if (!(r.sample_mask >> s & 1)) live[s] = 0;
        if (stipple) live[s] &= stipple[(by >> 1 & 12) | (bx >> 3 & 3)]; // tiles begin at multiples of 32
        if constexpr (Depth) {
          const float dx = r.per_sample ? float(kSampleX[s]) / 256 : 0.0f,
                      dy = r.per_sample ? float(kSampleY[s]) / 256 : 0.0f;
          if (live[s])
            live[s] = test_block(draw, p, x + dx, y + dy, live[s],
                                 tile.depth_stencil + s * kTilePixels * step + pixel, depth[s], changes);
        }
        any |= live[s];
      }
      for (int first = 0; any; first += kStripLanes, any >>= kStripLanes) {
        const uint32_t mask = uint32_t(any) & 0xffff;
        if (!mask) continue;
        const int k = batch.pixels.strips, lane = k * kStripLanes;
        for (int i = 0; i < kStripLanes; i += kWidth) {
          const FloatV px = splat(x) + row_of_eight(i / kWidth), py = row_coordinates(y, (first + i) >> 3);
          store(block.x + lane + i, round_to_int(px));
          store(block.y + lane + i, round_to_int(py));
          store(block.live + lane + i, mask_of_bits(mask >> i));
          if (Depth && program.writes_depth) { // for stages that change it
            const float center = r.per_sample ? 0.5f : 0.0f;
            const FloatV z = at(p.plane[kPlaneZ], px + center, py + center) + p.depth_offset;
            store(block.depth + lane + i, floats ? depth_float(z) : depth_bits(z, scale));
          }
        }
        for (int s = 0; s < kSamples; ++s) {
          batch.covered[s][k] = uint16_t(live[s] >> first);
          if (Depth && !draw.final_depth)
            for (int i = 0; i < kStripLanes; i += kWidth)
              store(batch.depth[s] + lane + i, load(depth[s] + first + i));
        }
        batch.pixels.add(p, pixel + first, changes);
        if (batch.pixels.full()) run_samples(draw, tile, block, batch);
      }
    }
  }
}

template <bool Depth> static void multisampled_primitives(const TileTarget& tile, const RasterDraw& draw,
                                                          const RasterPrimitive* const* primitive,
                                                          int32_t count, FragmentBlock& block) {
  SampleBatch batch;
  for (int32_t i = 0; i < count; ++i) {
    prefetch(primitive, i, count);
    if (primitive[i]->edges == 3)
      multisampled_primitive<Depth, 3>(draw, tile, *primitive[i], block, batch);
    else
      multisampled_primitive<Depth, 4>(draw, tile, *primitive[i], block, batch);
  }
  run_samples(draw, tile, block, batch);
}

} // namespace SOFTGL_ISA
} // namespace softgl
