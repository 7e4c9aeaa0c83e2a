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
  alignas(64) uint32_t depth[kSamples][kLanes];
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
      alignas(64) uint32_t live[kStripLanes];
      for (int i = 0; i < kStripLanes; i += kWidth) {
        IntV v = load(block.live + first + i) & mask_of_bits(uint32_t(batch.covered[s][k]) >> i);
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
  merge_samples(draw, merged_tile(draw, tile), block, batch);
  batch.pixels.strips = 0;
}

namespace { // so that no member is visible outside

/// Which samples of a tile's pixels a primitive covers: where coverage is the pixel's, all of a covered one.
template <int Edges> struct SampleCoverage {
  TileEdges edges[kSamples];
  EdgeSteps<Edges> steps; // the same for all samples
  TileEdges widest;       // outside of these no sample is covered
  bool seen[kSamples];
  bool any = false; // sample is seen
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
      if (!seen[s]) continue;
      if (any)
        for (int i = 0; i < Edges; ++i)
          widest.c[i] = widest.c[i] > edges[s].c[i] ? widest.c[i] : edges[s].c[i];
      else
        widest = edges[s];
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
  const RasterConstants& r = *draw.raster;
  const uint64_t* stipple = Edges == 3 ? r.stipple : nullptr; // triangles only: not lines and points
  const float scale = depth_scale(draw.program->key);
  const bool floats = DepthFormat(draw.program->key.depth_format) == DepthFormat::Z32F;
  const int32_t x0 = p.x0 > tile.x ? p.x0 - tile.x : 0, y0 = p.y0 > tile.y ? p.y0 - tile.y : 0;
  const int32_t x1 = p.x1 < tile.x + kTileSize ? p.x1 - tile.x : kTileSize,
                y1 = p.y1 < tile.y + kTileSize ? p.y1 - tile.y : kTileSize;
  const Compare function = Compare(draw.program->key.depth_function);
  const bool writes = draw.final_depth && draw.program->key.depth_write;
  for (int by = y0 & ~7; by < y1; by += 8) {
    for (int bx = x0 & ~7; bx < x1; bx += 8) {
      if (coverage.misses_block(bx, by)) continue;
      uint64_t covered[kSamples], any = 0;
      coverage.of_block(bx, by, covered);
      for (int s = 0; s < kSamples; ++s) {
        if (!(r.sample_mask >> s & 1)) covered[s] = 0;
        if (stipple) covered[s] &= stipple[(by >> 1 & 12) | (bx >> 3 & 3)]; // tiles begin at multiples of 32
        any |= covered[s];
      }
      for (int strip = 0; any; ++strip, any >>= kStripLanes) {
        const uint32_t mask = uint32_t(any) & 0xffff;
        if (!mask) continue;
        const int k = batch.pixels.strips, lane = k * kStripLanes;
        const int pixel = pixel_in_tile(bx, by) + strip * kStripLanes;
        const FloatV x = splat(float(tile.x + bx)), y = splat(float(tile.y + by + 2 * strip));
        uint32_t live[kSamples], any_live = 0;
        for (int s = 0; s < kSamples; ++s) live[s] = uint32_t(covered[s] >> (kStripLanes * strip)) & 0xffff;
        for (int i = 0; i < kStripLanes / kWidth; ++i) {
          const int at_lane = lane + i * kWidth;
          const FloatV px = x + row_of_eight(i), py = y + row_number(i);
          store(block.x + at_lane, round_to_int(px));
          store(block.y + at_lane, round_to_int(py));
          if constexpr (Depth) {
            const auto depth = [&](float dx, float dy) __attribute__((always_inline)) {
              const FloatV z = at(p.plane[kPlaneZ], px + dx, py + dy) + p.depth_offset;
              return floats ? depth_float(z) : depth_bits(z, scale);
            };
            IntV z{};
            if (!r.per_sample || draw.program->writes_depth) { // for stages that change it
              const float center = r.per_sample ? 0.5f : 0.0f;
              z = depth(center, center);
              store(block.depth + at_lane, z);
            }
            for (int s = 0; s < kSamples; ++s) {
              if (r.per_sample) z = depth(float(kSampleX[s]) / 256, float(kSampleY[s]) / 256);
              if (!draw.final_depth) store(batch.depth[s] + at_lane, z);
              if (!draw.early_depth) continue;
              uint32_t* place = tile.depth_stencil + s * kTilePixels + pixel + i * kWidth;
              const IntV there = load(place), passes = compare_words(function, z, there & 0xffffff);
              if (writes)
                store(place, choose(passes & mask_of_bits(live[s] >> (i * kWidth)) & 0xffffff, z, there));
              live[s] &= ~(~sign_bits(passes) << (i * kWidth) & ((2u << (kWidth - 1)) - 1) << (i * kWidth));
            }
          }
        }
        for (int s = 0; s < kSamples; ++s) batch.covered[s][k] = uint16_t(live[s]), any_live |= live[s];
        if (!any_live) continue;
        for (int i = 0; i < kStripLanes; i += kWidth)
          store(block.live + lane + i, mask_of_bits(any_live >> i));
        batch.pixels.add(p, pixel);
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
