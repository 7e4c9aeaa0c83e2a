// Small triangles where pixels have several samples: their pixels are shaded side by side, whatever triangles
// they belong to, and merged by vectors of samples.
#pragma once

#include "shaders/raster/raster_samples.inl"
#include "shaders/raster/raster_small.inl"
#include "shaders/raster/raster_spans.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Merges pixels with a tile's in order, kVectorPixels at a time, less where two are the same. `samples`: bit
/// s is set if the pixel's sample s is covered; `depth`: of all samples.
static void merge_sampled_pixels(const TileTarget& tile, const FragmentProgram& program,
                                 const uint16_t* pixel, const uint32_t* samples, const uint32_t* depth,
                                 const uint32_t* color, int count) {
  const Merger merger{program};
  const bool tests = tile.depth_stencil && merger.tests,
             writes_depth = program.key.depth_write || program.key.stencil;
  uint32_t* const words = tile.depth_stencil;
  auto* const colors = static_cast<uint32_t*>(tile.color);
  for (int i = 0; i < count;) {
    int pixels = 1;
    uint32_t covered = samples[i];
    size_t place[kVectorPixels];
    for (size_t& p : place) p = size_t(pixel[i]) * kSamples; // lanes behind the last pixel repeat the first
    const auto is_new = [&](int k) {
      for (int n = 0; n < k; ++n)
        if (pixel[i + n] == pixel[i + k]) return false;
      return true;
    };
    while (pixels < kVectorPixels && i + pixels < count && is_new(pixels)) {
      place[pixels] = size_t(pixel[i + pixels]) * kSamples;
      covered |= samples[i + pixels] << (pixels * kSamples);
      ++pixels;
    }
    IntV live = mask_of_bits(covered);
    if (tests) {
      IntV there = load_sample_words(words, place);
      live = merger.word_depth_stencil(live, load(depth + i * kSamples), there);
      if (writes_depth) store_sample_words(words, place, pixels, there);
    }
    if (tile.samples) *tile.samples += count_lanes(live);
    if (any(live)) {
      const IntV there = load_sample_words(colors, place);
      const IntV drawn = merger.blended(for_samples(color + i), there);
      store_sample_words(colors, place, pixels, choose(live & merger.mask, drawn, there));
    }
    i += pixels;
  }
}

/// Depths at (x, y) of the samples of kVectorPixels pixels, which are of triangles `number`.
SOFTGL_INLINE FloatV sample_depths(const StoredPlanes& stored, const int32_t* number, FloatV x, FloatV y) {
  const auto of_lanes = [&](const float* values) __attribute__((always_inline)) {
    return kWidth > 4 ? permute(load(values), for_samples(number)) : splat(values[*number]);
  };
  const auto& z = stored.plane[kPlaneZ];
  return value_at(PlaneV{of_lanes(z[0]), of_lanes(z[1]), of_lanes(z[2])}, x, y) + of_lanes(stored.offset);
}

/// Shades small triangles and merges their samples, in order.
template <bool PerSample> static void shade_sampled_triangles(const TileTarget& tile, const RasterDraw& draw,
                                                              const SmallTriangle* triangle, int32_t count,
                                                              FragmentBlock& block) {
  constexpr int kMargin = 2 * kWidth; // vectors are read and written whole
  const RasterConstants& r = *draw.raster;
  SampledPixels pixels;
  alignas(64) uint16_t pixel[kLanes + kMargin];
  alignas(64) uint32_t unused[kLanes + kMargin], color[kLanes + kMargin], live[kLanes + kMargin],
      samples[kLanes + kMargin], depth[(kLanes + kMargin) * kSamples];
  const FragmentWords words(draw, pixel, unused, color, live);
  const bool killing = draw.program->tests_alpha();
  const SamplePlaces places(PerSample);
  const float scale = depth_scale(draw.program->key);
  const uint32_t mask = r.sample_mask & ((1u << kSamples) - 1);
  for (; count > 0; triangle += kWidth, count -= kWidth) {
    const int lanes = count < kWidth ? count : kWidth;
    SmallTriangle padded[kWidth];
    const SmallTriangle* const group = whole_group(triangle, count, padded);
    StoredPlanes stored;
    CornerPlanes planes(group, r.pixel_center);
    list_pixels<PerSample ? kSamples : 1>(r, tile, planes.position, lanes, pixels, pixels.samples);
    const int32_t all = pixels.end[lanes - 1];
    if (all == 0) continue;
    store_planes(draw, planes, stored);
    for (int i = 0; i < kWidth; ++i) pixels.place[all + i] = pixels.place[0], pixels.samples[all + i] = 0;
    for (int32_t first = 0; first < all; first += kNumberedLanes) {
      const int32_t most = all - first < kNumberedLanes ? all - first : kNumberedLanes;
      alignas(64) int32_t number_of[kLanes];
      for (int32_t i = 0; i < most; i += kWidth) {
        const IntV p = load_halves(pixels.place + first + i);
        store_halves(pixel + i, pixels_in_tile(p));
        put_places(p, tile, i, number_of, block);
        const IntV covered = PerSample ? load_halves(pixels.samples + first + i) : splat(-1);
        store(samples + i, covered & int32_t(mask));
      }
      interpolate_numbered<PerSample>(draw, stored, number_of, most, block, unused);
      SmallShader<true>(draw, block).finish(words, most);
      for (int32_t i = 0; killing && i < most; i += kWidth)
        store(samples + i, load(samples + i) & load(live + i));
      for (int32_t i = 0; i < most; i += kVectorPixels) {
        const FloatV x = to_float(for_samples(block.x + i)) + places.x,
                     y = to_float(for_samples(block.y + i)) + places.y;
        store(depth + i * kSamples, depth_bits(sample_depths(stored, number_of + i, x, y), scale));
      }
      merge_sampled_pixels(tile, *draw.program, pixel, samples, depth, color, most);
    }
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
