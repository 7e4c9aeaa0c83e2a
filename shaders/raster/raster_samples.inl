// Vectors whose lanes are samples: those of as many neighboring pixels as there is room for.
#pragma once

#include "shaders/raster/raster_early.inl"
#include "shaders/raster/sample_points.h"

namespace softgl {
namespace SOFTGL_ISA {

constexpr int kVectorPixels = kWidth / kSamples; // of a row
constexpr uint32_t kAllLanes = (1u << (kWidth - 1) << 1) - 1;

/// The pixel of each lane, counted in its vector.
alignas(64) static constexpr int32_t kLanePixel[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

/// Each of kVectorPixels words for all samples of its pixel.
template <class Word> SOFTGL_INLINE IntV for_samples(const Word* words) {
  static_assert(sizeof(Word) == 4);
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  const __m512i four = _mm512_broadcast_i32x4(_mm_loadu_si128(reinterpret_cast<const __m128i*>(words)));
  return (IntV)_mm512_permutexvar_epi32((__m512i)load(kLanePixel), four);
#elif defined(__AVX2__)
  int64_t two;
  memcpy(&two, words, sizeof two);
  return (IntV)_mm256_permutevar8x32_epi32(_mm256_set1_epi64x(two), (__m256i)load(kLanePixel));
#else
  return splat(int32_t(*words));
#endif
}

/// One of kSamples words for the sample of each lane.
SOFTGL_INLINE IntV of_samples(const int32_t* words) {
  alignas(64) int32_t lane[kWidth];
  for (int i = 0; i < kWidth; ++i) lane[i] = words[i % kSamples];
  return load(lane);
}

/// Where the samples of a vector lie in their pixels.
struct SamplePlaces {
  FloatV x = FloatV{}, y = FloatV{};

  /// `per_sample`: else all of a pixel where its center is for pixels with one sample.
  SOFTGL_MEMBER explicit SamplePlaces(bool per_sample) {
    if (per_sample)
      x = to_float(of_samples(kSampleX)) * (1.0f / 256), y = to_float(of_samples(kSampleY)) * (1.0f / 256);
  }
};

/// The samples of kVectorPixels pixels, which lie at words + place[i]; and of the first `pixels` of them back
/// there.
SOFTGL_INLINE IntV load_sample_words(const uint32_t* words, const size_t* place) {
  const auto of_pixel = [&](int i) __attribute__((always_inline)) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(words + place[i]));
  };
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  __m512i v = _mm512_castsi128_si512(of_pixel(0));
  v = _mm512_inserti32x4(v, of_pixel(1), 1);
  v = _mm512_inserti32x4(v, of_pixel(2), 2);
  return (IntV)_mm512_inserti32x4(v, of_pixel(3), 3);
#elif defined(__AVX2__)
  return (IntV)_mm256_inserti128_si256(_mm256_castsi128_si256(of_pixel(0)), of_pixel(1), 1);
#else
  return (IntV)of_pixel(0);
#endif
}
SOFTGL_INLINE void store_sample_words(uint32_t* words, const size_t* place, int pixels, IntV v) {
  const auto put = [&](int i, __m128i samples) __attribute__((always_inline)) {
    if (i < pixels) _mm_storeu_si128(reinterpret_cast<__m128i*>(words + place[i]), samples);
  };
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  put(0, _mm512_castsi512_si128((__m512i)v));
  put(1, _mm512_extracti32x4_epi32((__m512i)v, 1));
  put(2, _mm512_extracti32x4_epi32((__m512i)v, 2));
  put(3, _mm512_extracti32x4_epi32((__m512i)v, 3));
#elif defined(__AVX2__)
  put(0, _mm256_castsi256_si128((__m256i)v));
  put(1, _mm256_extracti128_si256((__m256i)v, 1));
#else
  put(0, (__m128i)v);
#endif
}

/// A bit of each pixel as the lowest of kSamples: bit i becomes bit kSamples * i.
SOFTGL_INLINE uint64_t spread_bits(uint64_t pixels) {
  static_assert(kSamples == 4);
  uint64_t v = (pixels | pixels << 24) & 0x000000ff000000ffu;
  v = (v | v << 12) & 0x000f000f000f000fu;
  v = (v | v << 6) & 0x0303030303030303u;
  return (v | v << 3) & 0x1111111111111111u;
}
/// The bits of all samples of up to 16 pixels.
SOFTGL_INLINE uint64_t all_samples(uint64_t pixels) { return spread_bits(pixels) * ((1u << kSamples) - 1); }

/// Masks of the kWidth pixels of which a sample's bit is set.
SOFTGL_INLINE IntV pixels_with_samples(uint64_t samples) {
  alignas(64) static constexpr uint32_t bits[16] = {
      0xf, 0xf0, 0xf00, 0xf000, 0xf0000, 0xf00000, 0xf000000, 0xf0000000,
      0xf, 0xf0, 0xf00, 0xf000, 0xf0000, 0xf00000, 0xf000000, 0xf0000000};
  IntV words = splat(int32_t(uint32_t(samples)));
  for (int i = 8; i < kWidth; ++i) words[i] = int32_t(uint32_t(samples >> 32));
  return (words & load(bits)) != 0;
}

namespace { // so that no member is visible outside

/// The edges of a primitive at all samples of a tile's pixels. Where coverage is the pixel's, the samples
/// have the same ones.
template <int Edges> struct SampleEdges {
  TileEdges box;                         // of it the box, the steps, and what changes over a block
  int32_t least[Edges], greatest[Edges]; // of the samples' constants
  IntV lanes[Edges];                     // at the first pixels of the tile
  IntV next[Edges];                      // from a vector to the next one of the row

  /// False: no sample of the tile is covered.
  SOFTGL_MEMBER bool set(const RasterDraw& draw, const RasterPrimitive& p, const TileTarget& tile) {
    if (!clip_box(p, tile.x, tile.y, box)) return false;
    box.least = draw.whole_blocks ? 0 : -1;
    for (int i = 0; i < Edges; ++i) {
      const int32_t a = p.a[i], b = p.b[i];
      int32_t c[kSamples];
      for (int s = 0; s < kSamples; ++s) {
        const int64_t of_sample = int64_t(b) * kSampleY[s] - int64_t(a) * kSampleX[s];
        c[s] = constant_in_tile(p.round                   ? 0
                                : draw.raster->per_sample ? (p.c[i] + of_sample) >> 8
                                                          : p.c[i],
                                a, b, tile.x, tile.y);
      }
      set_edge(box, i, c[0], a, b);
      const int32_t low[2] = {c[0] < c[1] ? c[0] : c[1], c[2] < c[3] ? c[2] : c[3]};
      const int32_t high[2] = {c[0] < c[1] ? c[1] : c[0], c[2] < c[3] ? c[3] : c[2]};
      least[i] = low[0] < low[1] ? low[0] : low[1], greatest[i] = high[0] < high[1] ? high[1] : high[0];
      if (greatest[i] + box.block_max[i] * 9 < 0) return false;
      lanes[i] = of_samples(c) - multiply(splat(a), load(kLanePixel));
      next[i] = splat(-a * kVectorPixels);
    }
    return true;
  }

  /// As place_block(), of all samples.
  SOFTGL_MEMBER BlockPlace place(int32_t x, int32_t y) const {
    int32_t inside = box.least, outside = 0; // only their signs matter
    for (int i = 0; i < Edges; ++i) {
      const int32_t step = box.b[i] * y - box.a[i] * x;
      outside |= greatest[i] + step + box.block_max[i];
      inside |= least[i] + step + box.block_min[i];
    }
    return outside < 0 ? BlockPlace::Outside : inside < 0 ? BlockPlace::Cut : BlockPlace::Inside;
  }
};

} // namespace

/// The samples of eight pixels of a row, from (x, y) in the window on, that lie in a round point.
static uint32_t samples_in_circle(const RasterPrimitive& p, int32_t x, int32_t y) {
  uint32_t samples = 0;
  for (int i = 0; i < 8; ++i)
    for (int s = 0; s < kSamples; ++s) {
      const int64_t dx = int64_t(x + i) * 256 + kSampleX[s] - p.c[0],
                    dy = int64_t(y) * 256 + kSampleY[s] - p.c[1];
      samples |= uint32_t(dx * dx + dy * dy <= p.c[2]) << (i * kSamples + s);
    }
  return samples;
}

} // namespace SOFTGL_ISA
} // namespace softgl
