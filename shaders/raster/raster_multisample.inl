// Primitives on surfaces whose pixels have several samples (GL 1.5, 3.2.1): coverage, stencil, depth and
// color are of a sample, the stages run once a pixel, at its center.
#pragma once

#include "shaders/raster/raster_samples.inl"
#include "shaders/raster/raster_staged.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// What samples know apart from the strips of their pixels.
struct SampleBatch {
  StripBatch pixels;
  uint64_t covered[StripBatch::kMost];           // bit kSamples * i + s: sample s of lane i of the strip
  alignas(64) uint32_t depth[kLanes * kSamples]; // unless they are final
};

/// Samples of a strip for which its alphas are large enough: as OSMesa 22.3.6, the first samples go last.
static uint64_t covered_by_alpha(const float* alpha) {
  uint64_t samples = 0;
  for (int s = 0; s < kSamples; ++s) {
    uint32_t pixels = 0;
    for (int i = 0; i < kStripLanes; i += kWidth)
      pixels |= sign_bits((IntV)(load(alpha + i) > splat(float(s) / kSamples))) << i;
    samples |= spread_bits(pixels) << s;
  }
  return samples;
}

/// Merges `covered` samples of a strip, whose colors are RGBA8 words: one for all samples of a pixel.
/// `replaces`: nothing is left of what is there.
SOFTGL_INLINE void merge_sample_words(const Merger& merger, const uint32_t* words, uint64_t covered,
                                      bool replaces, uint32_t* target) {
  if (replaces && covered == ~uint64_t(0)) { // inside of large primitives
    for (int i = 0; i < kStripLanes; i += kVectorPixels) store(target + i * kSamples, for_samples(words + i));
    return;
  }
  for (int i = 0; i < kStripLanes; i += kVectorPixels) {
    const uint32_t lanes = uint32_t(covered >> (i * kSamples)) & kAllLanes;
    if (!lanes) continue;
    merger.color(mask_of_bits(lanes), for_samples(words + i), target + i * kSamples);
  }
}

/// The same of colors that are stored in another way: sample by sample, with its pixels brought together.
static void merge_sample_colors(const EncodedMerger& encoded, const FragmentBlock& block,
                                const uint32_t* words, int first, uint64_t covered, uint8_t* target) {
  const size_t bytes = size_t(bytes_per_pixel(ColorFormat(encoded.key.color_format)));
  for (int s = 0; s < kSamples; ++s, target += bytes) {
    alignas(64) uint8_t color[kStripLanes * 16];
    alignas(64) uint32_t live[kStripLanes];
    for (size_t i = 0; i < kStripLanes; ++i) {
      live[i] = uint32_t(mask_of(covered >> (i * kSamples + size_t(s)) & 1));
      memcpy(color + i * bytes, target + i * kSamples * bytes, bytes);
    }
    merge_colors(encoded, block, words, first, live, color, 0);
    for (size_t i = 0; i < kStripLanes; ++i) memcpy(target + i * kSamples * bytes, color + i * bytes, bytes);
  }
}

/// Merges the samples of the strips of `block` whose colors are final.
static void merge_samples(const RasterDraw& draw, const TileTarget& tile, FragmentBlock& block,
                          const SampleBatch& batch) {
  const RasterConstants& r = *draw.raster;
  const FragmentProgram& program = *draw.program;
  const Merger merger{program, kTilePixels * kSamples};
  const EncodedMerger encoded{merger};
  const auto format = ColorFormat(merger.key.color_format);
  const bool by_alpha = r.per_sample && r.alpha_to_coverage, one = r.per_sample && r.alpha_to_one,
             drops = program.drops(), sees_words = format == ColorFormat::Rgba8 && !merger.key.encoded;
  alignas(64) float alpha[kLanes];
  for (int i = 0; i < block.lanes; i += kWidth) {
    if (by_alpha) store(alpha + i, load(block.color[3] + i));
    if (one) store(block.color[3] + i, splat(1.0f));
  }
  alignas(64) uint32_t words[kLanes];
  pack_block(draw, block, words);
  for (int k = 0; k < batch.pixels.strips; ++k) {
    const int first = k * kStripLanes;
    uint64_t covered = batch.covered[k];
    if (drops) {
      uint32_t living = 0;
      for (int i = 0; i < kStripLanes; i += kWidth) living |= sign_bits(load(block.live + first + i)) << i;
      covered &= all_samples(living);
    }
    if (by_alpha) covered &= covered_by_alpha(alpha + first);
    const size_t place = size_t(batch.pixels.pixel[k]) * kSamples;
    if (tile.depth_stencil || tile.samples) {
      uint64_t left = 0;
      for (int i = 0; i < kStripLanes; i += kVectorPixels) {
        const uint32_t lanes = uint32_t(covered >> (i * kSamples)) & kAllLanes;
        if (!lanes) continue;
        IntV live = mask_of_bits(lanes);
        if (tile.depth_stencil) {
          const IntV z = program.writes_depth ? for_samples(block.depth + first + i)
                                              : load(batch.depth + (first + i) * kSamples);
          live = merger.depth_stencil(live, z, tile.depth_stencil + place + i * kSamples);
        }
        if (tile.samples) *tile.samples += count_lanes(live);
        left |= uint64_t(sign_bits(live)) << (i * kSamples);
      }
      covered = left;
    }
    if (!covered) continue;
    if (sees_words)
      merge_sample_words(merger, words + first, covered, draw.replaces_words,
                         static_cast<uint32_t*>(tile.color) + place);
    else
      merge_sample_colors(encoded, block, words, first, covered,
                          static_cast<uint8_t*>(tile.color) + place * size_t(bytes_per_pixel(format)));
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

/// Puts a strip of pixels at (x, y) of the window, of which samples are `covered`, into the block's next
/// lanes.
template <bool Depth> SOFTGL_INLINE void put_strip(const RasterDraw& draw, const RasterPrimitive& p,
                                                   const EarlyTests& tests, int32_t x, int32_t y,
                                                   uint64_t covered, SampleBatch& batch,
                                                   FragmentBlock& block) {
  const int lane = batch.pixels.strips * kStripLanes;
  batch.covered[batch.pixels.strips] = covered;
  for (int i = 0; i < kStripLanes; i += kWidth) {
    const IntV px = splat(x) + load(kStripColumn + i), py = splat(y) + load(kStripRow + i);
    store(block.x + lane + i, px), store(block.y + lane + i, py);
    store(block.live + lane + i, pixels_with_samples(covered >> (i * kSamples)));
    if (Depth && draw.program->writes_depth) { // for stages that change it
      const float center = draw.raster->per_sample ? 0.5f : 0.0f;
      const FloatV z = at(p.plane[kPlaneZ], to_float(px) + center, to_float(py) + center) + p.depth_offset;
      store(block.depth + lane + i, tests.floats ? depth_float(z) : depth_bits(z, tests.scale));
    }
  }
}

template <bool Depth, int Edges>
static void multisampled_primitive(const RasterDraw& draw, const TileTarget& tile, const RasterPrimitive& p,
                                   FragmentBlock& block, SampleBatch& batch) {
  SampleEdges<Edges> edges;
  if (!edges.set(draw, p, tile)) return;
  const RasterConstants& r = *draw.raster;
  const EarlyTests tests(draw);
  const SamplePlaces places(r.per_sample);
  const Plane& z_plane = p.plane[kPlaneZ];
  const FloatV a = splat(z_plane.a), gx = splat(z_plane.gx), gy = splat(z_plane.gy),
               offset = splat(p.depth_offset);
  const uint32_t mask = (r.sample_mask & ((1u << kSamples) - 1)) * 0x11111111u;
  const uint64_t* stipple = Edges == 3 ? r.stipple : nullptr; // triangles only: not lines and points
  const TileEdges& box = edges.box;
  for (int by = box.y0 & ~7; by < box.y1; by += 8)
    for (int bx = box.x0 & ~7; bx < box.x1; bx += 8) {
      const BlockPlace place = edges.place(bx, by);
      if (place == BlockPlace::Outside) continue;
      const int left = box.x0 > bx ? box.x0 - bx : 0, right = box.x1 < bx + 8 ? box.x1 - bx : 8;
      const int top = box.y0 > by ? box.y0 - by : 0, bottom = box.y1 < by + 8 ? box.y1 - by : 8;
      const uint32_t columns = (~0u << (left * kSamples)) & (~0u >> ((8 - right) * kSamples)) & mask;
      uint64_t pattern = ~uint64_t(0);
      if (stipple) pattern = stipple[(by >> 1 & 12) | (bx >> 3 & 3)]; // tiles begin at multiples of 32
      const int begin = left & ~(kVectorPixels - 1);
      FloatV of_column[8 / kVectorPixels]; // the parts of depths
      for (int i = begin; Depth && i < right; i += kVectorPixels)
        of_column[i / kVectorPixels] = gx * (places.x + to_float(load(kLanePixel) + (tile.x + bx + i))) + a;
      for (int strip = top & ~1; strip < bottom; strip += 2) {
        uint64_t covered = 0;
        IntV changed = IntV{};
        const int pixel = pixel_in_tile(bx, by + strip);
        for (int row = strip < top ? top : strip; row < strip + 2 && row < bottom; ++row) {
          uint32_t within = columns;
          if (stipple) within &= uint32_t(all_samples(pattern >> (8 * row) & 0xff));
          if (p.round) within &= samples_in_circle(p, tile.x + bx, tile.y + by + row);
          const FloatV of_row = gy * (places.y + float(tile.y + by + row));
          // Of `live` ones of the vector at a column.
          const auto vector = [&](int column, IntV live) __attribute__((always_inline)) {
            const int lane = (row - strip) * 8 + column; // of the strip
            if constexpr (Depth)
              live = tests.test(live, of_row + of_column[column / kVectorPixels] + offset,
                                tile.depth_stencil + (pixel + lane) * kSamples,
                                batch.depth + (batch.pixels.strips * kStripLanes + lane) * kSamples, changed);
            covered |= uint64_t(sign_bits(live)) << (lane * kSamples);
          };
          if (place == BlockPlace::Inside && within == ~0u) {
            for (int column = 0; Depth && column < 8; column += kVectorPixels) vector(column, splat(-1));
            if (!Depth) covered |= uint64_t(~0u) << ((row - strip) * 8 * kSamples);
            continue;
          }
          IntV v[Edges];
          for (int i = 0; i < Edges; ++i)
            v[i] = edges.lanes[i] + (box.b[i] * (by + row) - box.a[i] * (bx + begin));
          for (int column = begin; column < right; column += kVectorPixels) {
            IntV live = mask_of_bits(within >> (column * kSamples));
            if (place == BlockPlace::Cut) {
              IntV outside = v[0];
              for (int i = 1; i < Edges; ++i) outside |= v[i];
              for (int i = 0; i < Edges; ++i) v[i] += edges.next[i];
              live &= outside >= 0;
            }
            if (!Depth || any(live)) vector(column, live);
          }
        }
        if (!covered) continue;
        put_strip<Depth>(draw, p, tests, tile.x + bx, tile.y + by + strip, covered, batch, block);
        batch.pixels.add(p, pixel, any(changed));
        if (batch.pixels.full()) run_samples(draw, tile, block, batch);
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
