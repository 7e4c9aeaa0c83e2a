#include "surface/sample_resolve.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/unit_range.h"
#include "surface/read_surface.h"

namespace softgl {
namespace {

/// A color as it is stored when it is drawn.
void store_color(ColorFormat format, const float* rgba, void* color, size_t pixel) {
  if (format == ColorFormat::RgbaFloat) {
    std::memcpy(static_cast<float*>(color) + 4 * pixel, rgba, 16);
    return;
  }
  const float one = format == ColorFormat::Rgba16 ? 65535.0f : 255.0f;
  uint16_t v[4];
  for (int i = 0; i < 4; ++i) v[i] = uint16_t(std::nearbyint(unit_range(rgba[i]) * one));
  switch (format) {
  case ColorFormat::Rgba8:
    for (size_t i = 0; i < 4; ++i) static_cast<uint8_t*>(color)[4 * pixel + i] = uint8_t(v[i]);
    return;
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
    for (int pixel = 0; pixel < count; ++pixel)
      for (int k = 0; k < 4; ++k) pixels[pixel][k] += sample[pixel][k];
  }
  for (int pixel = 0; pixel < count; ++pixel)
    for (int k = 0; k < 4; ++k) pixels[pixel][k] *= 1.0f / float(s.samples);
}

void resolve_samples(const Surface& from, const Surface& to, uint32_t tile) {
  const int x0 = int(tile) % from.tiles_x * kTileSize, y0 = int(tile) / from.tiles_x * kTileSize;
  const int columns = std::min(kTileSize, from.width - x0), rows = std::min(kTileSize, from.height - y0);
  unsigned char row[kTileSize * 16];
  float sample[kTileSize][4], pixels[kTileSize][4];
  for (int y = y0; y < y0 + rows; ++y) {
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
