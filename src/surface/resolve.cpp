// From the surface's blocks to the rows of the caller's buffer.
#include <GL/osmesa.h>
#include <emmintrin.h>

#include <algorithm>
#include <cstring>
#include <iterator>

#include "surface/framebuffer.h"

namespace softgl {
namespace {

constexpr int kBlock = 8;

// Each of these writes `count` pixels of a row. In rows of a block they run with the constant 8, which
// unrolls them.
struct Copy32 {
  static constexpr size_t kFrom = 4, kTo = 4;
  static void run(const unsigned char* from, unsigned char* to, int count) {
    std::memcpy(to, from, size_t(count) * 4);
  }
};
struct Copy64 {
  static constexpr size_t kFrom = 8, kTo = 8;
  static void run(const unsigned char* from, unsigned char* to, int count) {
    std::memcpy(to, from, size_t(count) * 8);
  }
};
struct Copy128 {
  static constexpr size_t kFrom = 16, kTo = 16;
  static void run(const unsigned char* from, unsigned char* to, int count) {
    std::memcpy(to, from, size_t(count) * 16);
  }
};
struct Copy16 {
  static constexpr size_t kFrom = 2, kTo = 2;
  static void run(const unsigned char* from, unsigned char* to, int count) {
    std::memcpy(to, from, size_t(count) * 2);
  }
};
/// Applies `Swizzle` to four pixels at a time, then to the rest. GCC 12 leaves the plain loop scalar: three
/// times slower.
template <class Swizzle>
void swizzle_row(const unsigned char* from, unsigned char* to, int count, Swizzle swizzle) {
  const size_t n = size_t(count), whole = n & ~size_t(3);
  for (size_t i = 0; i < whole; i += 4) {
    const __m128i p = _mm_loadu_si128(reinterpret_cast<const __m128i*>(from + 4 * i));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to + 4 * i), swizzle(p));
  }
  for (size_t i = whole; i < n; ++i) {
    int pixel;
    std::memcpy(&pixel, from + 4 * i, 4);
    pixel = _mm_cvtsi128_si32(swizzle(_mm_cvtsi32_si128(pixel)));
    std::memcpy(to + 4 * i, &pixel, 4);
  }
}
struct SwapRedAndBlue {
  static constexpr size_t kFrom = 4, kTo = 4;
  static void run(const unsigned char* from, unsigned char* to, int count) {
    swizzle_row(from, to, count, [](__m128i p) {
      const __m128i green_alpha = _mm_and_si128(p, _mm_set1_epi32(int(0xff00ff00u)));
      const __m128i red_blue = _mm_andnot_si128(_mm_set1_epi32(int(0xff00ff00u)), p);
      return _mm_or_si128(green_alpha,
                          _mm_or_si128(_mm_slli_epi32(red_blue, 16), _mm_srli_epi32(red_blue, 16)));
    });
  }
};
struct AlphaFirst {
  static constexpr size_t kFrom = 4, kTo = 4;
  static void run(const unsigned char* from, unsigned char* to, int count) {
    swizzle_row(from, to, count,
                [](__m128i p) { return _mm_or_si128(_mm_slli_epi32(p, 8), _mm_srli_epi32(p, 24)); });
  }
};
struct BytesWithoutAlpha {
  static constexpr size_t kFrom = 4, kTo = 3;
  static void run(const unsigned char* from, unsigned char* to, int count) {
    const size_t n = size_t(count), whole = n & ~size_t(3);
    for (size_t i = 0; i < whole; i += 4) {
      uint32_t p[4];
      std::memcpy(p, from + 4 * i, 16);
      const uint32_t q[3] = {(p[0] & 0xffffffu) | p[1] << 24, (p[1] >> 8 & 0xffffu) | p[2] << 16,
                             (p[2] >> 16 & 0xffu) | p[3] << 8};
      std::memcpy(to + 3 * i, q, 12);
    }
    for (size_t i = whole; i < n; ++i) std::memcpy(to + 3 * i, from + 4 * i, 3);
  }
};
/// Three of four components of `bytes` each.
template <size_t bytes> struct DropAlpha {
  static constexpr size_t kFrom = 4 * bytes, kTo = 3 * bytes;
  static void run(const unsigned char* from, unsigned char* to, int count) {
    for (int i = 0; i < count; ++i) std::memcpy(to + kTo * size_t(i), from + kFrom * size_t(i), kTo);
  }
};

struct Destination {
  unsigned char* top;   // where row 0 of the surface goes
  ptrdiff_t row_stride; // bytes; negative when the buffer begins with the bottom row
};

/// The caller's buffer as rows of the surface (y down).
Destination destination_of(const Surface& s, const ClientBuffer& client, size_t pixel_bytes) {
  const ptrdiff_t stride =
      ptrdiff_t(client.row_length ? client.row_length : s.width) * ptrdiff_t(pixel_bytes);
  auto* data = static_cast<unsigned char*>(client.data);
  if (client.y_up) return {data + ptrdiff_t(s.height - 1) * stride, -stride};
  return {data, stride};
}

template <class Convert> void resolve_tile(const Surface& s, const ClientBuffer& client, uint32_t tile) {
  const Destination to = destination_of(s, client, Convert::kTo);
  const int x0 = int(tile) % s.tiles_x * kTileSize, y0 = int(tile) / s.tiles_x * kTileSize;
  const int columns = s.width - x0 < kTileSize ? s.width - x0 : kTileSize,
            rows = s.height - y0 < kTileSize ? s.height - y0 : kTileSize;
  // Of a tile that waits all rows of blocks are this one.
  const TileWords& words = color_words(s, tile);
  const bool waits = words.waits;
  const auto* color = static_cast<const unsigned char*>(s.color) +
                      (waits ? 0 : words.place * size_t(kTilePixels) * Convert::kFrom);
  uint32_t same[kBlock * Convert::kFrom / sizeof(uint32_t)];
  if (waits) std::fill(std::begin(same), std::end(same), words.word);
  auto pixels = [&](int x, int y) {
    return waits ? reinterpret_cast<const unsigned char*>(same)
                 : color + size_t(pixel_in_tile(x, y)) * Convert::kFrom;
  };
  // Rows of the buffer are far apart, which no prefetcher foresees: without this a tile takes three times as
  // long (3.5 instead of 1.2 us for RGBA8).
  constexpr int kAhead = 6; // rows
  auto prefetch = [](const unsigned char* p, size_t bytes) {
    for (size_t i = 0; i < bytes; i += 64) __builtin_prefetch(p + i, 1);
  };
  for (int y = 0; y < rows; ++y) {
    unsigned char* out = to.top + ptrdiff_t(y0 + y) * to.row_stride + ptrdiff_t(x0) * ptrdiff_t(Convert::kTo);
    if (y + kAhead < rows) prefetch(out + kAhead * to.row_stride, size_t(columns) * Convert::kTo + 63);
    if (!waits && y % kBlock == 0 && y + kBlock < rows)
      prefetch(pixels(0, y + kBlock), kTileSize * kBlock * Convert::kFrom);
    int x = 0;
    for (; x + kBlock <= columns; x += kBlock, out += kBlock * Convert::kTo)
      Convert::run(pixels(x, y), out, kBlock);
    if (x < columns) Convert::run(pixels(x, y), out, columns - x);
  }
}

auto resolver_of(const Surface& s, const ClientBuffer& client) -> decltype(&resolve_tile<Copy32>) {
  if (!s.color || !client.data) return [](const Surface&, const ClientBuffer&, uint32_t) {};
  const bool rgb = client.format == OSMESA_RGB;
  switch (s.color_format) {
  case ColorFormat::Rgba8:
    if (rgb) return resolve_tile<BytesWithoutAlpha>;
    if (client.format == OSMESA_BGRA) return resolve_tile<SwapRedAndBlue>;
    if (client.format == OSMESA_ARGB) return resolve_tile<AlphaFirst>;
    return resolve_tile<Copy32>;
  // OSMesa 22.3.6: shorts and floats are stored as R, G, B, A whatever the format's name says.
  case ColorFormat::Rgba16: return rgb ? resolve_tile<DropAlpha<2>> : resolve_tile<Copy64>;
  case ColorFormat::RgbaFloat: return rgb ? resolve_tile<DropAlpha<4>> : resolve_tile<Copy128>;
  case ColorFormat::Rgb565: break;
  }
  return resolve_tile<Copy16>;
}

} // namespace

int depth_copy_bytes(const Framebuffer& f) {
  if (f.depth_bits == 0) return 0;
  return f.surface.depth_format == DepthFormat::Z16 ? 2 : 4;
}

void copy_depth(Framebuffer& f) {
  const Surface& s = f.seen().surface;
  const size_t bytes = size_t(depth_copy_bytes(f));
  f.depth_copy.resize(size_t(s.width) * size_t(s.height) * bytes);
  unsigned char* out = f.depth_copy.data();
  for (int y = s.height - 1; y >= 0; --y)
    for (int x = 0; x < s.width; ++x, out += bytes) {
      const uint32_t word = s.depth_stencil[depth_index(s, x, y)];
      if (bytes == 4)
        std::memcpy(out, &word, 4);
      else {
        const uint16_t depth = uint16_t(word);
        std::memcpy(out, &depth, 2);
      }
    }
}

Resolver::Resolver(const Surface& surface, const ClientBuffer& client)
    : surface_(surface), client_(client), resolve_(resolver_of(surface, client)) {}

} // namespace softgl
