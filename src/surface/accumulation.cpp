#include "surface/accumulation.h"

#include <emmintrin.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace softgl {
namespace {

// One pixel is four lanes. All arithmetic is OSMesa 22.3.6's: a multiplication in float, then the fraction is
// cut off.

__m128i load_numbers(const int16_t* from) { return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(from)); }
void store_numbers(int16_t* to, __m128i numbers) {
  _mm_storel_epi64(reinterpret_cast<__m128i*>(to), numbers);
}

/// The lower halves of four 32-bit integers, in the lower half of the result.
__m128i lower_halves(__m128i v) {
  v = _mm_srai_epi32(_mm_slli_epi32(v, 16), 16);
  return _mm_packs_epi32(v, v);
}
__m128i to_numbers(__m128 v) { return lower_halves(_mm_cvttps_epi32(v)); }
__m128 to_floats(__m128i numbers) {
  return _mm_cvtepi32_ps(_mm_srai_epi32(_mm_unpacklo_epi16(numbers, numbers), 16));
}
/// Clamped to [0, 1]; what is not a number becomes 0.
__m128 each_in_unit_range(__m128 v) { return _mm_min_ps(_mm_max_ps(v, _mm_setzero_ps()), _mm_set1_ps(1.0f)); }

// Formats of the color buffer: a pixel as four floats and back, and a pixel whose masked components are those
// of another one.

struct Rgba8 {
  using Pixel = uint32_t;
  static __m128 load(const Pixel& p) {
    const __m128i zero = _mm_setzero_si128(), bytes = _mm_cvtsi32_si128(int(p));
    const __m128i words = _mm_unpacklo_epi16(_mm_unpacklo_epi8(bytes, zero), zero);
    return _mm_mul_ps(_mm_cvtepi32_ps(words), _mm_set1_ps(1.0f / 255.0f));
  }
  static Pixel pack(__m128 v) { // rounds to nearest even
    const __m128i words = _mm_cvtps_epi32(_mm_mul_ps(each_in_unit_range(v), _mm_set1_ps(255.0f)));
    const __m128i halves = _mm_packs_epi32(words, words);
    return Pixel(_mm_cvtsi128_si32(_mm_packus_epi16(halves, halves)));
  }
  static Pixel mask(const bool (&m)[4]) {
    return (m[0] ? 0xffu : 0u) | (m[1] ? 0xff00u : 0u) | (m[2] ? 0xff0000u : 0u) | (m[3] ? 0xff000000u : 0u);
  }
  static Pixel choose(Pixel mask, Pixel a, Pixel b) { return (a & mask) | (b & ~mask); }
};

struct Rgba16 {
  struct Pixel {
    uint64_t rgba;
  };
  static __m128 load(const Pixel& p) {
    const __m128i words =
        _mm_unpacklo_epi16(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(&p)), _mm_setzero_si128());
    return _mm_mul_ps(_mm_cvtepi32_ps(words), _mm_set1_ps(1.0f / 65535.0f));
  }
  static Pixel pack(__m128 v) { // rounds halves up
    v = _mm_add_ps(_mm_mul_ps(each_in_unit_range(v), _mm_set1_ps(65535.0f)), _mm_set1_ps(0.5f));
    Pixel p;
    _mm_storel_epi64(reinterpret_cast<__m128i*>(&p), to_numbers(v));
    return p;
  }
  static Pixel mask(const bool (&m)[4]) {
    Pixel p{};
    for (int i = 0; i < 4; ++i)
      if (m[i]) p.rgba |= uint64_t(0xffff) << (16 * i);
    return p;
  }
  static Pixel choose(Pixel mask, Pixel a, Pixel b) { return {(a.rgba & mask.rgba) | (b.rgba & ~mask.rgba)}; }
};

struct RgbaFloat {
  struct Pixel {
    __m128 rgba;
  };
  static __m128 load(const Pixel& p) { return p.rgba; }
  static Pixel pack(__m128 v) { return {v}; } // OSMesa clamps nothing in buffers of floats
  static Pixel mask(const bool (&m)[4]) {
    return {_mm_castsi128_ps(_mm_set_epi32(-int(m[3]), -int(m[2]), -int(m[1]), -int(m[0])))};
  }
  static Pixel choose(const Pixel& mask, const Pixel& a, const Pixel& b) {
    return {_mm_or_ps(_mm_and_ps(mask.rgba, a.rgba), _mm_andnot_ps(mask.rgba, b.rgba))};
  }
};

struct Rgb565 {
  using Pixel = uint16_t;
  static __m128 load(const Pixel& p) {
    const __m128 v = _mm_cvtepi32_ps(_mm_set_epi32(1, p & 31, p >> 5 & 63, p >> 11));
    return _mm_mul_ps(v, _mm_set_ps(1.0f, 1.0f / 31.0f, 1.0f / 63.0f, 1.0f / 31.0f));
  }
  static Pixel pack(__m128 v) { // rounds halves up
    v = _mm_add_ps(_mm_mul_ps(each_in_unit_range(v), _mm_set_ps(0.0f, 31.0f, 63.0f, 31.0f)),
                   _mm_set1_ps(0.5f));
    int32_t c[4];
    _mm_storeu_si128(reinterpret_cast<__m128i*>(c), _mm_cvttps_epi32(v));
    return Pixel(c[0] << 11 | c[1] << 5 | c[2]);
  }
  static Pixel mask(const bool (&m)[4]) {
    return Pixel((m[0] ? 0xf800 : 0) | (m[1] ? 0x07e0 : 0) | (m[2] ? 0x001f : 0));
  }
  static Pixel choose(Pixel mask, Pixel a, Pixel b) { return Pixel((a & mask) | (b & ~mask)); }
};

struct Box {
  int32_t x0, y0, x1, y1; // inside the tile, half open
};

/// Calls visit(first, count) for pixels [first, first + count) that lie side by side in a tile. All of a tile
/// that the box covers is one run; its pixels beyond the window do no harm.
template <class Visit> void for_each_run(const Box& box, bool whole, Visit visit) {
  if (whole) return visit(0, kTilePixels);
  for (int32_t y = box.y0; y < box.y1; ++y)
    for (int32_t x = box.x0; x < box.x1;) {
      const int32_t end = std::min(box.x1, (x | 7) + 1);
      visit(pixel_in_tile(x, y), end - x);
      x = end;
    }
}

/// GL_ACCUM and GL_LOAD.
template <class Format, bool add>
void take_colors(const void* color, int16_t* numbers, int count, float value) {
  const auto* pixel = static_cast<const typename Format::Pixel*>(color);
  const __m128 scale = _mm_set1_ps(value * 32767.0f);
  for (int i = 0; i < count; ++i) {
    __m128i v = to_numbers(_mm_mul_ps(Format::load(pixel[i]), scale));
    if constexpr (add) v = _mm_add_epi16(v, load_numbers(numbers + 4 * i));
    store_numbers(numbers + 4 * i, v);
  }
}

/// GL_RETURN.
template <class Format>
void give_colors(void* color, const int16_t* numbers, int count, float value, const bool (&color_mask)[4]) {
  auto* pixel = static_cast<typename Format::Pixel*>(color);
  const __m128 scale = _mm_set1_ps(value / 32767.0f);
  const auto mask = Format::mask(color_mask);
  for (int i = 0; i < count; ++i)
    pixel[i] = Format::choose(mask, Format::pack(_mm_mul_ps(to_floats(load_numbers(numbers + 4 * i)), scale)),
                              pixel[i]);
}

void multiply(int16_t* numbers, int count, float value) {
  const __m128 factor = _mm_set1_ps(value);
  for (int i = 0; i < count; ++i)
    store_numbers(numbers + 4 * i, to_numbers(_mm_mul_ps(to_floats(load_numbers(numbers + 4 * i)), factor)));
}

void add(int16_t* numbers, int count, __m128i increment) {
  for (int i = 0; i < count; ++i)
    store_numbers(numbers + 4 * i, _mm_add_epi16(load_numbers(numbers + 4 * i), increment));
}

void fill(int16_t* numbers, int count, __m128i value) {
  for (int i = 0; i < count; ++i) store_numbers(numbers + 4 * i, value);
}

/// One run of pixels of a tile.
template <class Format>
void accumulate_run(const Accumulation& a, void* color, int16_t* numbers, int first, int count) {
  numbers += 4 * first;
  if (color) color = static_cast<typename Format::Pixel*>(color) + first;
  switch (a.operation) {
  case AccumulationOperation::Accumulate: return take_colors<Format, true>(color, numbers, count, a.value);
  case AccumulationOperation::Load: return take_colors<Format, false>(color, numbers, count, a.value);
  case AccumulationOperation::Return:
    return give_colors<Format>(color, numbers, count, a.value, a.color_mask);
  case AccumulationOperation::Multiply: return multiply(numbers, count, a.value);
  case AccumulationOperation::Add: return add(numbers, count, to_numbers(_mm_set1_ps(a.value * 32767.0f)));
  case AccumulationOperation::Clear: return fill(numbers, count, load_numbers(a.clear_value));
  }
}

auto run_of(ColorFormat format) -> decltype(&accumulate_run<Rgba8>) {
  switch (format) {
  case ColorFormat::Rgba8: break;
  case ColorFormat::Rgba16: return accumulate_run<Rgba16>;
  case ColorFormat::RgbaFloat: return accumulate_run<RgbaFloat>;
  case ColorFormat::Rgb565: return accumulate_run<Rgb565>;
  }
  return accumulate_run<Rgba8>;
}

} // namespace

void accumulate_tile(const Surface& s, int16_t* numbers, const Accumulation& a, uint32_t tile) {
  const int32_t x = int32_t(tile % uint32_t(s.tiles_x)) * kTileSize,
                y = int32_t(tile / uint32_t(s.tiles_x)) * kTileSize;
  const int32_t columns = std::min(kTileSize, s.width - x), rows = std::min(kTileSize, s.height - y);
  const Box box = {std::max(a.x0 - x, 0), std::max(a.y0 - y, 0), std::min(a.x1 - x, columns),
                   std::min(a.y1 - y, rows)};
  if (box.x0 >= box.x1 || box.y0 >= box.y1) return;
  const bool whole = box.x0 == 0 && box.y0 == 0 && box.x1 == columns && box.y1 == rows;
  TileWords& state = color_words(s, tile);
  // Operations without colors may find the tile's still waiting, without a place.
  unsigned char* color = nullptr;
  if (state.place != kNoPlace)
    color = static_cast<unsigned char*>(s.color) +
            state.place * size_t(kTilePixels) * size_t(bytes_per_pixel(s.color_format));
  if (a.operation == AccumulationOperation::Return) state.known &= ~Rgba8::mask(a.color_mask);
  const auto run = run_of(s.color_format);
  int16_t* of_tile = numbers + size_t(tile) * kTilePixels * 4;
  if (s.pixel_step == 1 || !color)
    return for_each_run(box, whole, [&](int first, int count) { run(a, color, of_tile, first, count); });
  // One of several samples: its colors are brought together for a while.
  const auto bytes = size_t(bytes_per_pixel(s.color_format)), step = bytes * size_t(s.pixel_step);
  std::vector<unsigned char> colors(kTilePixels * bytes);
  for (size_t i = 0; i < kTilePixels; ++i) std::memcpy(&colors[i * bytes], color + i * step, bytes);
  for_each_run(box, whole, [&](int first, int count) { run(a, colors.data(), of_tile, first, count); });
  for (size_t i = 0; i < kTilePixels; ++i) std::memcpy(color + i * step, &colors[i * bytes], bytes);
}

} // namespace softgl
