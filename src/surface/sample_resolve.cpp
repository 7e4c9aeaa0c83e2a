#include "surface/sample_resolve.h"

#include <emmintrin.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/unit_range.h"
#include "surface/read_surface.h"

namespace softgl {
namespace {

/// A color that is not of bytes as it is stored when it is drawn.
void store_color(ColorFormat format, const float* rgba, void* color, size_t pixel) {
  if (format == ColorFormat::RgbaFloat) {
    std::memcpy(static_cast<float*>(color) + 4 * pixel, rgba, 16);
    return;
  }
  const float one = format == ColorFormat::Rgba16 ? 65535.0f : 255.0f;
  uint16_t v[4];
  for (int i = 0; i < 4; ++i) v[i] = uint16_t(std::nearbyint(unit_range(rgba[i]) * one));
  switch (format) {
  case ColorFormat::Rgb565:
    static_cast<uint16_t*>(color)[pixel] = uint16_t((v[0] & 0xf8) << 8 | (v[1] & 0xfc) << 3 | v[2] >> 3);
    return;
  default: std::memcpy(static_cast<uint16_t*>(color) + 4 * pixel, v, 8);
  }
}

} // namespace

void average_samples(const Surface& s, int x, int y, int count, bool linear, unsigned char* row,
                     float (*sample)[4], float (*pixels)[4]) {
  const auto to_floats = linear ? color_row_to_linear_floats : color_row_to_floats;
  for (int i = 0; i < s.samples; ++i) {
    copy_color_row(sample_surface(s, i), x, y, count, row);
    to_floats(s, row, count, i == 0 ? pixels : sample);
    if (i == 0) continue;
    float* sum = *pixels;
    const float* more = *sample;
    for (int k = 0; k < 4 * count; ++k) sum[k] += more[k];
  }
  float* mean = *pixels;
  const float part = 1.0f / float(s.samples);
  for (int k = 0; k < 4 * count; ++k) mean[k] *= part;
}

namespace {

/// Means of the samples of `count` pixels, which lie side by side. Most pixels lie inside of what was drawn,
/// so their samples are the same: a mean of four equal bytes is that byte.
void average_run(const uint32_t* samples, int count, uint8_t (*to)[4]) {
  static_assert(kSamples == 4);
  const __m128 unit = _mm_set1_ps(1.0f / 255.0f), part = _mm_set1_ps(1.0f / kSamples),
               one = _mm_set1_ps(255.0f);
  const __m128i zero = _mm_setzero_si128();
  for (int i = 0; i < count; ++i) {
    const __m128i words = _mm_loadu_si128(reinterpret_cast<const __m128i*>(samples + kSamples * i));
    __m128i mean = words;
    if (_mm_movemask_epi8(_mm_cmpeq_epi32(words, _mm_shuffle_epi32(words, 0))) != 0xffff) {
      const __m128i low = _mm_unpacklo_epi8(words, zero), high = _mm_unpackhi_epi8(words, zero);
      const auto value = [&](__m128i v) { return _mm_mul_ps(_mm_cvtepi32_ps(v), unit); };
      __m128 sum = value(_mm_unpacklo_epi16(low, zero));
      sum = _mm_add_ps(sum, value(_mm_unpackhi_epi16(low, zero)));
      sum = _mm_add_ps(sum, value(_mm_unpacklo_epi16(high, zero)));
      sum = _mm_add_ps(sum, value(_mm_unpackhi_epi16(high, zero)));
      mean = _mm_cvtps_epi32(_mm_mul_ps(_mm_mul_ps(sum, part), one));
      mean = _mm_packus_epi16(_mm_packs_epi32(mean, zero), zero);
    }
    const int32_t word = _mm_cvtsi128_si32(mean);
    std::memcpy(to[i], &word, 4);
  }
}

} // namespace

void average_bytes(const Surface& s, int x, int y, int width, int height, uint8_t (*bytes)[4], size_t row) {
  constexpr int kBlock = 8; // pixels a side: 1024x1024 take 2.0 ms by blocks, 6.4 row by row of the window
  for (int lines; height > 0; y += lines, bytes += size_t(lines) * row, height -= lines) {
    lines = std::min(height, kBlock - y % kBlock);
    for (int done = 0, run; done < width; done += run) {
      run = std::min(width - done, kBlock - (x + done) % kBlock);
      const uint32_t* from = static_cast<const uint32_t*>(s.color) + color_index(s, x + done, y);
      for (int i = 0; i < lines; ++i)
        average_run(from + i * kBlock * kSamples, run, bytes + size_t(i) * row + done);
    }
  }
}

void resolve_samples(const Surface& from, const Surface& to, uint32_t tile) {
  const int x0 = int(tile) % from.tiles_x * kTileSize, y0 = int(tile) / from.tiles_x * kTileSize;
  const int columns = std::min(kTileSize, from.width - x0), rows = std::min(kTileSize, from.height - y0);
  unsigned char row[kTileSize * 16];
  float sample[kTileSize][4], pixels[kTileSize][4];
  const bool bytes = to.color_format == ColorFormat::Rgba8;
  if (bytes) {
    constexpr int kBlock = 8;
    for (int y = y0; y < y0 + rows; y += kBlock)
      for (int x = x0; x < x0 + columns; x += kBlock)
        average_bytes(
            from, x, y, std::min(kBlock, x0 + columns - x), std::min(kBlock, y0 + rows - y),
            reinterpret_cast<uint8_t(*)[4]>(static_cast<uint8_t*>(to.color) + 4 * color_index(to, x, y)),
            kBlock);
  }
  for (int y = y0; !bytes && y < y0 + rows; ++y) {
    average_samples(from, x0, y, columns, false, row, sample, pixels);
    for (int i = 0; i < columns; ++i)
      store_color(to.color_format, pixels[i], to.color, color_index(to, x0 + i, y));
  }
  color_words(to, tile).known = 0;
  if (!to.depth_stencil) return;
  const auto words = [&](const Surface& s) {
    return s.depth_stencil + depth_words(s, tile).place * size_t(kTilePixels);
  };
  const uint32_t* first = words(from);
  uint32_t* word = words(to);
  for (int i = 0; i < kTilePixels; ++i) word[i] = first[i * from.pixel_step];
  depth_words(to, tile).known = 0;
}

} // namespace softgl
