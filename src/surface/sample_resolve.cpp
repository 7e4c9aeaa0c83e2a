#include "surface/sample_resolve.h"

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

/// Means of the `count` bytes from `first` on, which are of the first sample, with those of the others.
void average_run(const uint8_t* first, int count, uint8_t* __restrict to) {
  constexpr size_t kStep = size_t(kTilePixels) * 4; // bytes to the next sample
  constexpr float kPart = 1.0f / float(kSamples), kUnit = 1.0f / 255.0f;
  constexpr float kUlpIsOne = 8388608.0f; // added and subtracted it rounds, and loops stay loops of vectors
  static_assert(kSamples == 4);
  const uint8_t *b = first + kStep, *c = b + kStep, *d = c + kStep;
  for (int i = 0; i < count; ++i) {
    float sum = float(first[i]) * kUnit;
    sum += float(b[i]) * kUnit;
    sum += float(c[i]) * kUnit;
    sum += float(d[i]) * kUnit;
    to[i] = uint8_t(int32_t(((sum * kPart) * 255.0f + kUlpIsOne) - kUlpIsOne));
  }
}

} // namespace

void average_bytes(const Surface& s, int x, int y, int count, uint8_t (*bytes)[4]) {
  constexpr int kRun = 8; // pixels of a block's row lie together
  for (int run; count > 0; x += run, bytes += run, count -= run) {
    run = std::min(count, kRun - x % kRun);
    average_run(static_cast<const uint8_t*>(s.color) + 4 * color_index(s, x, y), 4 * run, *bytes);
  }
}

void resolve_samples(const Surface& from, const Surface& to, uint32_t tile) {
  const int x0 = int(tile) % from.tiles_x * kTileSize, y0 = int(tile) / from.tiles_x * kTileSize;
  const int columns = std::min(kTileSize, from.width - x0), rows = std::min(kTileSize, from.height - y0);
  unsigned char row[kTileSize * 16];
  float sample[kTileSize][4], pixels[kTileSize][4];
  for (int y = y0; y < y0 + rows; ++y) {
    if (to.color_format == ColorFormat::Rgba8) {
      constexpr int kRun = 8;
      for (int x = x0; x < x0 + columns; x += kRun)
        average_bytes(
            from, x, y, std::min(kRun, x0 + columns - x),
            reinterpret_cast<uint8_t(*)[4]>(static_cast<uint8_t*>(to.color) + 4 * color_index(to, x, y)));
      continue;
    }
    average_samples(from, x0, y, columns, false, row, sample, pixels);
    for (int i = 0; i < columns; ++i)
      store_color(to.color_format, pixels[i], to.color, color_index(to, x0 + i, y));
  }
  color_words(to, tile).known = 0;
  if (!to.depth_stencil) return;
  const auto words = [&](const Surface& s) {
    return s.depth_stencil + depth_words(s, tile).place * size_t(kTilePixels);
  };
  std::memcpy(words(to), words(from), kTilePixels * sizeof(uint32_t));
  depth_words(to, tile).known = 0;
}

} // namespace softgl
