// Texels as bytes or floats: what glGetTexImage and copies read.
#include "texture/texel_format.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

#include "texture/base_format.h"
#include "texture/component_values.h"
#include "texture/pixel_formats.h"
#include "texture/pixel_transfer.h"
#include "texture/small_floats.h"

namespace softgl {

namespace {

bool wide_packed(const PixelFormat& f) { return f.channel == PixelChannel::Packed && f.bits[0] > 8; }
bool wide_or_signed(const PixelFormat& f) {
  if (f.channel == PixelChannel::Packed) return f.bits[0] > 8;
  return f.channel != PixelChannel::UnsignedByte;
}

/// OSMesa clamps luminance for unsigned types, and does so in floats.
bool clamps_luminance(const PixelFormat& to) {
  return to.luminance && to.channel != PixelChannel::Float && to.channel != PixelChannel::Half &&
         to.channel != PixelChannel::Byte && to.channel != PixelChannel::Short &&
         to.channel != PixelChannel::Int;
}

void load_color(const TexelFormat& from, const unsigned char* texels, const PixelFormat& to, void* pixels,
                int count, bool swap) {
  const bool narrow = from.layout == TexelLayout::Rgba8;
  auto stored = [&](int i, int k) -> uint32_t { // the stored integer
    if (narrow) {
      const uint8_t v = texels[i * 4 + k];
      return from.bits[k] ? v >> (8 - from.bits[k]) : v != 0;
    }
    uint16_t v;
    std::memcpy(&v, texels + i * 8 + k * 2, 2);
    return v;
  };
  const bool exact_bytes = from.array && from.base == GL_RGBA;
  // A byte stays the same on its way through a float.
  const bool clamps =
      clamps_luminance(to) && !(narrow && from.array && to.channel == PixelChannel::UnsignedByte);
  const bool floats = clamps || (from.array ? (narrow ? wide_packed(to) && !exact_bytes : wide_packed(to))
                                            : wide_or_signed(to));
  if (floats) {
    float v[kTexelRow][4];
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < count; ++i)
        v[i][k] = from.bits[k] ? unorm_to_float(stored(i, k), from.bits[k]) : float(stored(i, k));
    gather_row<float>(from.base, v, count, 1.0f);
    pack_pixels(to, v, count, swap, pixels);
  } else if (!narrow && from.array) {
    uint16_t v[kTexelRow][4];
    std::memcpy(v, texels, size_t(count) * 8);
    if (from.bits[3] == 0)
      for (int i = 0; i < count; ++i) v[i][3] = 65535;
    gather_row<uint16_t>(from.base, v, count, 65535);
    pack_pixels(to, v, count, swap, pixels);
  } else {
    uint8_t v[kTexelRow][4];
    if (narrow)
      std::memcpy(v, texels, size_t(count) * 4);
    else
      for (int i = 0; i < count; ++i)
        for (int k = 0; k < 4; ++k)
          v[i][k] = uint8_t(from.bits[k] ? convert_unorm(stored(i, k), from.bits[k], 8) : 255 * stored(i, k));
    gather_row<uint8_t>(from.base, v, count, 255);
    pack_pixels(to, v, count, swap, pixels);
  }
}

void load_floats(const TexelFormat& from, const unsigned char* texels, const PixelFormat& to, void* pixels,
                 int count, bool swap) {
  float v[kTexelRow][4];
  std::memcpy(v, texels, size_t(count) * sizeof v[0]);
  gather_row<float>(from.base, v, count, 1);
  pack_pixels(to, v, count, swap, pixels);
}

template <class T> void load_signed(const TexelFormat& from, const unsigned char* texels,
                                    const PixelFormat& to, void* pixels, int count, bool swap) {
  constexpr T kMost = std::numeric_limits<T>::max();
  T v[kTexelRow][4];
  for (int i = 0; i < count; ++i) {
    int16_t texel[4];
    std::memcpy(texel, texels + i * 8, sizeof texel);
    for (int k = 0; k < 4; ++k) v[i][k] = T(texel[k]);
    if (from.bits[3] == 0) v[i][3] = kMost;
  }
  gather_row<T>(from.base, v, count, kMost);
  // OSMesa: shorts are made of floats, other integers of integers.
  if (!clamps_luminance(to) && to.channel != PixelChannel::UnsignedShort)
    return pack_pixels(to, v, count, swap, pixels);
  float floats[kTexelRow][4];
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 4; ++k) floats[i][k] = float(v[i][k]) * (1.0f / float(kMost));
  pack_pixels(to, floats, count, swap, pixels);
}

} // namespace

void load_texels(const TexelFormat& from, const void* texels, const PixelFormat& to, void* pixels, int count,
                 bool swap_bytes) {
  auto t = static_cast<const unsigned char*>(texels);
  auto p = static_cast<unsigned char*>(pixels);
  for (int done = 0; done < count; done += kTexelRow) {
    const int n = std::min(kTexelRow, count - done);
    const unsigned char* source = t + size_t(done) * size_t(from.bytes());
    unsigned char* target = p + size_t(done) * to.bytes;
    switch (from.layout) {
    case TexelLayout::Depth: break;
    case TexelLayout::Float: load_floats(from, source, to, target, n, swap_bytes); continue;
    case TexelLayout::Signed16:
      if (std::max(from.bits[0], from.bits[3]) == 8)
        load_signed<int8_t>(from, source, to, target, n, swap_bytes);
      else
        load_signed<int16_t>(from, source, to, target, n, swap_bytes);
      continue;
    default: load_color(from, source, to, target, n, swap_bytes); continue;
    }
    const int bits = from.bits[0];
    if (!swap_bytes && !from.floats &&
        ((bits == 32 && to.channel == PixelChannel::UnsignedInt) ||
         (bits == 16 && to.channel == PixelChannel::UnsignedShort))) {
      // The stored integers themselves.
      if (bits == 32)
        std::memcpy(target, source, size_t(n) * 4);
      else
        for (int i = 0; i < n; ++i) std::memcpy(target + 2 * i, source + 4 * i, 2);
      continue;
    }
    uint32_t v[kTexelRow];
    float d[kTexelRow];
    std::memcpy(v, source, size_t(n) * 4);
    const double scale = 1.0 / double((uint64_t(1) << bits) - 1);
    if (from.floats)
      std::memcpy(d, v, size_t(n) * 4);
    else if (bits == 16)
      for (int i = 0; i < n; ++i) d[i] = float(int32_t(v[i])) * (1.0f / 65535.0f);
    else
      for (int i = 0; i < n; ++i) d[i] = float(double(v[i]) * scale);
    pack_depth(to, d, n, swap_bytes, target);
  }
}

} // namespace softgl
