#include "surface/read_surface.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "base/assert.h"
#include "shaders/common/srgb.h"
#include "texture/base_format.h"
#include "texture/component_values.h"
#include "texture/texel_format.h"

namespace softgl {
namespace {

/// Copies the pixels of a row block by block: 8 neighbours are contiguous unless a pixel has several samples,
/// the next 8 of the row in the tile are a block further.
template <class Pixel> void copy_row(const Surface& s, const Pixel* plane, const TileWords* tiles,
                                     int32_t columns, int x, int y, int count, Pixel* row) {
  SOFTGL_ASSERT(x >= 0 && count >= 0 && x + count <= s.width && y >= 0 && y < s.height);
  constexpr int kBlock = 8;
  while (count > 0) {
    SOFTGL_ASSERT(tiles[(y >> 6) * columns + (x >> 6)].place != kNoPlace &&
                  !tiles[(y >> 6) * columns + (x >> 6)].waits);
    const Pixel* from = plane + pixel_index(s, tiles, columns, x, y);
    int run = std::min(count, kTileSize - (x & (kTileSize - 1)));
    if (s.pixel_step > 1) {
      run = std::min(run, kBlock - x % kBlock);
      for (int i = 0; i < run; ++i) row[i] = from[i * s.pixel_step];
    } else if (x % kBlock != 0 || run < kBlock) { // a part of a block
      run = std::min(run, kBlock - x % kBlock);
      std::memcpy(row, from, size_t(run) * sizeof(Pixel));
    } else {
      run -= run % kBlock;
      for (int i = 0; i < run; i += kBlock, from += kBlock * kBlock)
        std::memcpy(row + i, from, kBlock * sizeof(Pixel));
    }
    x += run;
    row += run;
    count -= run;
  }
}

// `row` may be the client's memory, which need not be aligned.
struct Bytes2 {
  unsigned char b[2];
};
struct Bytes4 {
  unsigned char b[4];
};
struct Bytes8 {
  unsigned char b[8];
};
struct Bytes16 {
  unsigned char b[16];
};

template <class Pixel> void copy_colors(const Surface& s, int x, int y, int count, Pixel* row) {
  copy_row(s, static_cast<const Pixel*>(s.color), s.color_tile, s.color_columns, x, y, count, row);
}

/// Calls row(row of the surface, first column within the rectangle, count, row within the rectangle) for the
/// part on the surface.
template <class Row> void for_each_row(const Surface& s, int x, int y, int width, int height, Row&& row) {
  const int64_t left = std::max<int64_t>(x, 0), right = std::min<int64_t>(int64_t(x) + width, s.width);
  if (left >= right) return;
  for (int64_t line = std::max<int64_t>(y, 0); line < std::min<int64_t>(int64_t(y) + height, s.height);
       ++line)
    row(surface_row(s, int(line)), int(left), int(right - left), size_t(line - y), size_t(left - x));
}

} // namespace

void copy_color_row(const Surface& s, int x, int y, int count, void* row) {
  switch (s.color_format) {
  case ColorFormat::Rgba8: return copy_colors(s, x, y, count, static_cast<Bytes4*>(row));
  case ColorFormat::Rgba16: return copy_colors(s, x, y, count, static_cast<Bytes8*>(row));
  case ColorFormat::RgbaFloat: return copy_colors(s, x, y, count, static_cast<Bytes16*>(row));
  case ColorFormat::Rgb565: return copy_colors(s, x, y, count, static_cast<Bytes2*>(row));
  }
}

void copy_depth_stencil_row(const Surface& s, int x, int y, int count, uint32_t* row) {
  copy_row(s, static_cast<const uint32_t*>(s.depth_stencil), s.depth_tile, s.depth_columns, x, y, count, row);
}

void copy_stencil_row(const Surface& s, int x, int y, int count, uint32_t* row) {
  if (has_stencil_bits(s.depth_format)) {
    copy_depth_stencil_row(s, x, y, count, row);
    for (int i = 0; i < count; ++i) row[i] >>= 24;
  } else {
    copy_row(s, static_cast<const uint32_t*>(s.depth_stencil) + stencil_step(s), s.depth_tile,
             s.depth_columns, x, y, count, row);
  }
}

void color_row_to_bytes(const Surface& s, const void* row, int count, uint8_t (*rgba)[4]) {
  if (s.color_format == ColorFormat::Rgba8) {
    std::memcpy(rgba, row, size_t(count) * 4);
  } else if (s.color_format == ColorFormat::Rgb565) {
    for (int i = 0; i < count; ++i) {
      const uint32_t p = static_cast<const uint16_t*>(row)[i];
      rgba[i][0] = uint8_t(convert_unorm(p >> 11, 5, 8));
      rgba[i][1] = uint8_t(convert_unorm(p >> 5 & 63, 6, 8));
      rgba[i][2] = uint8_t(convert_unorm(p & 31, 5, 8));
      rgba[i][3] = 255;
    }
  } else if (s.color_format == ColorFormat::Rgba16 && s.encoding.numbers == ColorNumbers::Unsigned) {
    for (int i = 0; i < count * 4; ++i)
      rgba[i / 4][i % 4] = uint8_t(convert_unorm(static_cast<const uint16_t*>(row)[i], 16, 8));
  } else {
    for (int i = 0; i < count; ++i) {
      const size_t pixel = size_t(i) * size_t(bytes_per_pixel(s.color_format));
      float color[1][4] = {};
      color_row_to_floats(s, static_cast<const unsigned char*>(row) + pixel, 1, color);
      for (int k = 0; k < 4; ++k) rgba[i][k] = uint8_t(float_to_unorm(color[0][k], 8));
    }
  }
}

namespace {

/// Numbers of integers that fill Stored; those that are not kept are 0 or, as alpha, all ones.
template <class Stored>
void unsigned_row_to_floats(const Surface& s, const void* row, int count, float (*rgba)[4]) {
  constexpr int kWide = int(sizeof(Stored) * 8);
  const auto* from = static_cast<const Stored*>(row);
  const auto stored_bits = [&](int k) { return s.encoding.bits[k] ? s.encoding.bits[k] : kWide; };
  if (stored_bits(0) == kWide && stored_bits(1) == kWide && stored_bits(2) == kWide &&
      stored_bits(3) == kWide) {
    float* to = *rgba;
    constexpr float kScale = 1.0f / float((1 << kWide) - 1);
    for (int i = 0; i < 4 * count; ++i) to[i] = float(int32_t(from[i])) * kScale;
    return;
  }
  for (int k = 0; k < 4; ++k) {
    const int bits = stored_bits(k);
    for (int i = 0; i < count; ++i)
      rgba[i][k] = unorm_to_float(uint32_t(from[4 * i + k]) >> (kWide - bits), bits);
  }
}

} // namespace

void color_row_to_floats(const Surface& s, const void* row, int count, float (*rgba)[4]) {
  switch (s.color_format) {
  case ColorFormat::Rgba8: return unsigned_row_to_floats<uint8_t>(s, row, count, rgba);
  case ColorFormat::Rgba16: {
    if (s.encoding.numbers == ColorNumbers::Unsigned)
      return unsigned_row_to_floats<uint16_t>(s, row, count, rgba);
    const bool narrow = *std::max_element(s.encoding.bits, s.encoding.bits + 4) == 8;
    const float scale = 1.0f / (narrow ? 127.0f : 32767.0f);
    for (int i = 0; i < count * 4; ++i)
      rgba[i / 4][i % 4] = std::max(float(static_cast<const int16_t*>(row)[i]) * scale, -1.0f);
    return;
  }
  case ColorFormat::RgbaFloat: std::memcpy(rgba, row, size_t(count) * 16); return;
  case ColorFormat::Rgb565:
    for (int i = 0; i < count; ++i) {
      const uint32_t p = static_cast<const uint16_t*>(row)[i];
      rgba[i][0] = unorm_to_float(p >> 11, 5);
      rgba[i][1] = unorm_to_float(p >> 5 & 63, 6);
      rgba[i][2] = unorm_to_float(p & 31, 5);
      rgba[i][3] = 1.0f;
    }
    return;
  }
}

void color_row_to_linear_floats(const Surface& s, const void* row, int count, float (*rgba)[4]) {
  color_row_to_floats(s, row, count, rgba);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k)
      rgba[i][k] = srgb_to_linear(float(static_cast<const uint8_t*>(row)[4 * i + k]));
}

float depth_to_float(DepthFormat format, uint32_t word) {
  if (format == DepthFormat::Z32F) return std::bit_cast<float>(word);
  const uint32_t one = largest_depth(format);
  const auto whole = int32_t(word & one);
  if (format == DepthFormat::Z16) return float(whole) * (1.0f / float(one));
  return float(double(whole) * (1.0 / double(one)));
}

void depths_to_floats(DepthFormat format, const uint32_t* word, int count, float* depth) {
  const auto each = [&](auto value) {
    for (int i = 0; i < count; ++i) depth[i] = value(word[i]);
  };
  switch (format) {
  case DepthFormat::Z32F: std::memcpy(depth, word, size_t(count) * 4); return;
  case DepthFormat::Z16: return each([](uint32_t v) { return depth_to_float(DepthFormat::Z16, v); });
  default: return each([](uint32_t v) { return depth_to_float(DepthFormat::Z24S8, v); });
  }
}

void floats_to_depths(DepthFormat format, const float* depth, size_t count, uint32_t* word) {
  if (format == DepthFormat::Z32F) {
    std::memcpy(word, depth, count * sizeof *word);
    return;
  }
  const auto largest = float(largest_depth(format));
  for (size_t i = 0; i < count; ++i) word[i] = uint32_t(int32_t(std::lrintf(depth[i] * largest)));
}

void spread_colors(const TexelFormat* texels, uint8_t (*rgba)[4], size_t count) {
  if (texels) spread_row<uint8_t>(texels->base, rgba, int(count), 255);
}

void spread_colors(const TexelFormat* texels, float (*rgba)[4], size_t count) {
  if (texels) spread_row<float>(texels->base, rgba, int(count), 1.0f);
}

void read_rgba8(const Surface& s, int x, int y, int width, int height, uint8_t (*rgba)[4]) {
  if (width <= 0 || height <= 0) return;
  std::memset(rgba, 0, size_t(width) * size_t(height) * 4);
  std::vector<unsigned char> row(size_t(width) * 16);
  for_each_row(s, x, y, width, height,
               [&](int row_of_surface, int first, int count, size_t line, size_t column) {
                 copy_color_row(s, first, row_of_surface, count, row.data());
                 color_row_to_bytes(s, row.data(), count, rgba + line * size_t(width) + column);
               });
}

void read_rgba_float(const Surface& s, int x, int y, int width, int height, float (*rgba)[4]) {
  if (width <= 0 || height <= 0) return;
  std::memset(rgba, 0, size_t(width) * size_t(height) * 16);
  std::vector<unsigned char> row(size_t(width) * 16);
  for_each_row(s, x, y, width, height,
               [&](int row_of_surface, int first, int count, size_t line, size_t column) {
                 copy_color_row(s, first, row_of_surface, count, row.data());
                 color_row_to_floats(s, row.data(), count, rgba + line * size_t(width) + column);
               });
}

namespace {

/// Calls convert(word) for the words of a rectangle that copy_row copies.
template <class T, class Convert>
void read_words(const Surface& s, int x, int y, int width, int height, T* out,
                void (*copy_row)(const Surface&, int, int, int, uint32_t*), Convert convert) {
  if (width <= 0 || height <= 0) return;
  std::fill_n(out, size_t(width) * size_t(height), T(0));
  if (!s.depth_stencil) return;
  std::vector<uint32_t> row(static_cast<size_t>(width));
  for_each_row(
      s, x, y, width, height, [&](int row_of_surface, int first, int count, size_t line, size_t column) {
        copy_row(s, first, row_of_surface, count, row.data());
        std::transform(row.begin(), row.begin() + count, out + line * size_t(width) + column, convert);
      });
}

} // namespace

void read_depth_float(const Surface& s, int x, int y, int width, int height, float* depth) {
  const DepthFormat format = s.depth_format;
  read_words(s, x, y, width, height, depth, copy_depth_stencil_row,
             [=](uint32_t word) { return depth_to_float(format, word); });
}

void read_stencil(const Surface& s, int x, int y, int width, int height, uint8_t* stencil) {
  read_words(s, x, y, width, height, stencil, copy_stencil_row, [](uint32_t word) { return uint8_t(word); });
}

} // namespace softgl
