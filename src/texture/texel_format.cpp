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

int stored_bits(const TexelFormat& f, int k) {
  return f.bits[k] ? f.bits[k] : f.layout == TexelLayout::Rgba8 ? 8 : 0;
}

/// to[i][k] = value(from[i][k]) of a row.
template <class To, class From, class F>
void convert_component(int k, const From (*from)[4], int count, To (*to)[4], F value) {
  for (int i = 0; i < count; ++i) to[i][k] = value(from[i][k]);
}

/// Whether component k comes with just so many bits.
bool has_bits(const PixelFormat& from, int k, int bits) {
  for (int i = 0; i < from.components; ++i)
    if (from.target[i] == k) return from.channel == PixelChannel::Packed && from.bits[i] == bits;
  return false;
}

/// Bytes to the bits that are stored, repeated to fill them.
void reduce_bytes(const TexelFormat& to, const PixelFormat& from, uint8_t (*texel)[4], int count) {
  Narrowing narrow[4];
  Widening widen[4];
  bool same = true;
  for (int k = 0; k < 4; ++k) {
    int bits = stored_bits(to, k);
    if (has_bits(from, k, bits)) bits = 8; // their bits are repeated already
    narrow[k] = narrowing(bits), widen[k] = widening(bits);
    same = same && bits == 8;
  }
  if (same) return;
  change_words(texel, count, [&](uint32_t word) {
    uint32_t reduced = 0;
    for (int k = 0; k < 4; ++k) reduced |= widen[k](narrow[k](word >> (8 * k) & 255)) << (8 * k);
    return reduced;
  });
}

void store_rgba8(const TexelFormat& to, uint8_t (*texel)[4], const PixelFormat& from, const void* pixels,
                 int count, bool swap, const PixelTransfer& transfer) {
  const bool transfers = transfer.changes_color();
  if (transfers || (!to.array && from.format == GL_RGBA && from.channel == PixelChannel::Float)) {
    float v[kTexelRow][4];
    unpack_pixels(from, pixels, count, swap, v);
    if (transfers) transfer.clamped_color(v, count);
    for (int k = 0; k < 4; ++k) {
      const int bits = stored_bits(to, k);
      if (bits == 8)
        convert_component(k, v, count, texel, [](float x) { return uint8_t(pack_unorm(x, 8)); });
      else
        convert_component(k, v, count, texel, [=, widen = widening(bits)](float x) {
          return uint8_t(widen(pack_unorm(x, bits)));
        });
    }
  } else {
    unpack_pixels(from, pixels, count, swap, texel);
    if (!to.array) reduce_bytes(to, from, texel, count);
  }
  spread_row<uint8_t>(to.base, texel, count, 255);
}

void store_rgba16(const TexelFormat& to, uint16_t (*texel)[4], const PixelFormat& from, const void* pixels,
                  int count, bool swap, const PixelTransfer& transfer) {
  const bool transfers = transfer.changes_color();
  const bool bytes = from.format == GL_RGBA && from.channel == PixelChannel::UnsignedByte;
  const bool floats = from.format == GL_RGBA && from.channel == PixelChannel::Float;
  if (to.array && !transfers && !floats) {
    unpack_pixels(from, pixels, count, swap, texel);
  } else if (bytes && !transfers) {
    uint8_t v[kTexelRow][4];
    unpack_pixels(from, pixels, count, swap, v);
    for (int k = 0; k < 4; ++k)
      convert_component(k, v, count, texel, [bits = to.bits[k]](uint8_t x) {
        return uint16_t(bits ? convert_unorm(x, 8, bits) : 0);
      });
  } else {
    float v[kTexelRow][4];
    unpack_pixels(from, pixels, count, swap, v);
    if (transfers) transfer.clamped_color(v, count);
    for (int k = 0; k < 4; ++k) {
      const int bits = to.array ? 16 : to.bits[k];
      convert_component(k, v, count, texel, [=](float x) { return uint16_t(pack_unorm(x, bits)); });
    }
  }
  spread_row<uint16_t>(to.base, texel, count, 1);
}

/// Whether OSMesa makes texels of whole colors, and not one component after the other: then halves are cut,
/// and what lies in the middle of two integers with a sign goes away from 0; else both are rounded to the
/// nearest.
bool packs_colors(const PixelFormat& from, bool transfers) {
  if (transfers || from.channel == PixelChannel::PackedFloat) return true;
  if (from.channel == PixelChannel::Packed && from.bits[0] != 8) return true;
  return from.format == GL_RGBA &&
         (from.channel == PixelChannel::Float || from.channel == PixelChannel::UnsignedByte ||
          from.type == GL_UNSIGNED_INT_8_8_8_8_REV);
}

int32_t signed_away_from_zero(float x, int bits) {
  const float scaled = std::clamp(x, -1.0f, 1.0f) * float((1 << (bits - 1)) - 1);
  return int32_t(scaled < 0 ? scaled - 0.5f : scaled + 0.5f);
}

// Integers become integers without floats where nothing changes them.
template <class T> void store_signed(const TexelFormat& to, int16_t (*texel)[4], const PixelFormat& from,
                                     const void* pixels, int count, bool swap,
                                     const PixelTransfer& transfer) {
  T v[kTexelRow][4];
  const bool transfers = transfer.changes_color();
  if (transfers || (packs_colors(from, false) && from.channel != PixelChannel::UnsignedByte)) {
    float f[kTexelRow][4];
    unpack_pixels(from, pixels, count, swap, f);
    if (transfers) transfer.color(f, count);
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < 4; ++k) v[i][k] = T(signed_away_from_zero(f[i][k], sizeof(T) * 8));
  } else {
    unpack_pixels(from, pixels, count, swap, v);
  }
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 4; ++k) texel[i][k] = v[i][k];
  spread_row<int16_t>(to.base, texel, count, 1);
}

void store_float(const TexelFormat& to, float (*texel)[4], const PixelFormat& from, const void* pixels,
                 int count, bool swap, const PixelTransfer& transfer) {
  unpack_pixels(from, pixels, count, swap, texel);
  const bool transfers = transfer.changes_color();
  if (transfers) transfer.color(texel, count);
  const bool nearest = !packs_colors(from, transfers);
  const bool same = !transfers && from.channel == PixelChannel::PackedFloat &&
                    (from.type == GL_UNSIGNED_INT_5_9_9_9_REV) == (to.bits[0] == 9) && !to.array;
  if (!same) to.reduce(texel, count, nearest);
  spread_row<float>(to.base, texel, count, 1);
}

void store_depth(const TexelFormat& to, uint32_t* texel, const PixelFormat& from, const void* pixels,
                 int count, bool swap, const PixelTransfer& transfer) {
  const bool plain = !transfer.changes_depth();
  auto p = static_cast<const unsigned char*>(pixels);
  if (to.floats) {
    float d[kTexelRow];
    unpack_depth(from, pixels, count, swap, d);
    transfer.depths(d, count);
    std::memcpy(texel, d, size_t(count) * 4);
    return;
  }
  const int bits = to.bits[0];
  // Integers that need no float on their way.
  if (plain && !swap && from.channel == PixelChannel::UnsignedInt && (bits == 16 || bits == 32)) {
    for (int i = 0; i < count; ++i, p += 4) {
      uint32_t v;
      std::memcpy(&v, p, 4);
      texel[i] = bits == 16 ? v >> 16 : v;
    }
    return;
  }
  if (plain && !swap && from.channel == PixelChannel::UnsignedShort && (bits == 16 || bits == 32)) {
    for (int i = 0; i < count; ++i, p += 2) {
      uint16_t v;
      std::memcpy(&v, p, 2);
      texel[i] = bits == 16 ? v : uint32_t(v) | uint32_t(v) << 16;
    }
    return;
  }
  float d[kTexelRow];
  unpack_depth(from, pixels, count, swap, d);
  transfer.depths(d, count);
  // OSMesa truncates here.
  const float most = float((1u << (bits & 31)) - 1);
  if (bits == 32)
    for (int i = 0; i < count; ++i) texel[i] = uint32_t(std::min(double(d[i]) * 4294967295.0, 4294967295.0));
  else
    for (int i = 0; i < count; ++i) texel[i] = uint32_t(int32_t(d[i] * most));
}

} // namespace

void TexelFormat::reduce(float (*rgba)[4], int count, bool to_nearest) const {
  if (bits[0] == 9) {
    for (int i = 0; i < count; ++i) shared_exponent_to_floats(floats_to_shared_exponent(rgba[i]), rgba[i]);
  } else if (bits[0] == 16 || bits[3] == 16) { // components that are not stored may be reduced, too
    to_nearest ? round_to_halves(rgba[0], 4 * count) : reduce_to_halves(rgba[0], 4 * count);
  } else if (bits[0] == 11) {
    for (int k = 0; k < 3; ++k)
      convert_component(k, rgba, count, rgba, [mantissa = k < 2 ? 6 : 5](float v) {
        return reduce_to_unsigned_float(v, mantissa);
      });
  }
}

void store_depth_stencil(const TexelFormat& to, uint32_t* texels, uint8_t* stencils, const PixelFormat& from,
                         const void* pixels, int count, bool swap_bytes, const PixelTransfer& transfer) {
  auto p = static_cast<const unsigned char*>(pixels);
  const StencilTransfer stencil(transfer);
  if (from.type == GL_UNSIGNED_INT_24_8 && !to.floats && !transfer.changes_depth()) { // words stay words
    for (int i = 0; i < count; ++i, p += 4) {
      uint32_t word;
      std::memcpy(&word, p, 4);
      if (swap_bytes) word = __builtin_bswap32(word);
      texels[i] = word >> 8;
      stencils[i] = stencil(word & 255);
    }
    return;
  }
  for (int i = 0; i < count; ++i, p += from.bytes) {
    const DepthStencilPixel v = unpack_depth_stencil(from, p, swap_bytes);
    if (to.floats)
      texels[i] = std::bit_cast<uint32_t>(transfer.depth(v.depth));
    else if (v.integer && !transfer.changes_depth())
      texels[i] = v.bits;
    else
      texels[i] = uint32_t(transfer.depth(v.depth) * 16777215.0f); // OSMesa truncates here
    stencils[i] = stencil(v.stencil);
  }
}

void load_depth_stencil(const TexelFormat& from, const uint32_t* texels, const uint8_t* stencils,
                        const PixelFormat& to, void* pixels, int count, bool swap_bytes) {
  auto p = static_cast<unsigned char*>(pixels);
  if (to.type == GL_UNSIGNED_INT_24_8 && !from.floats) {
    for (int i = 0; i < count; ++i, p += 4) {
      uint32_t word = texels[i] << 8 | stencils[i];
      if (swap_bytes) word = __builtin_bswap32(word);
      std::memcpy(p, &word, 4);
    }
    return;
  }
  for (int i = 0; i < count; ++i, p += to.bytes) {
    DepthStencilPixel v;
    v.stencil = stencils[i];
    v.integer = !from.floats;
    v.bits = texels[i];
    v.depth = from.floats ? std::bit_cast<float>(texels[i]) : float(double(texels[i]) * (1.0 / 16777215.0));
    pack_depth_stencil(to, v, swap_bytes, p);
  }
}

void store_texels(const TexelFormat& to, void* texels, const PixelFormat& from, const void* pixels, int count,
                  bool swap_bytes, const PixelTransfer& transfer) {
  auto p = static_cast<const unsigned char*>(pixels);
  auto t = static_cast<unsigned char*>(texels);
  for (int done = 0; done < count; done += kTexelRow) {
    const int n = std::min(kTexelRow, count - done);
    const unsigned char* source = p + size_t(done) * from.bytes;
    unsigned char* target = t + size_t(done) * size_t(to.bytes());
    switch (to.layout) {
    case TexelLayout::Rgba8:
      store_rgba8(to, reinterpret_cast<uint8_t(*)[4]>(target), from, source, n, swap_bytes, transfer);
      break;
    case TexelLayout::Rgba16:
      store_rgba16(to, reinterpret_cast<uint16_t(*)[4]>(target), from, source, n, swap_bytes, transfer);
      break;
    case TexelLayout::Depth:
      store_depth(to, reinterpret_cast<uint32_t*>(target), from, source, n, swap_bytes, transfer);
      break;
    case TexelLayout::Signed16: {
      auto* texel = reinterpret_cast<int16_t(*)[4]>(target);
      if (std::max(to.bits[0], to.bits[3]) == 8)
        store_signed<int8_t>(to, texel, from, source, n, swap_bytes, transfer);
      else
        store_signed<int16_t>(to, texel, from, source, n, swap_bytes, transfer);
      break;
    }
    case TexelLayout::Float:
      store_float(to, reinterpret_cast<float(*)[4]>(target), from, source, n, swap_bytes, transfer);
      break;
    }
  }
}

TexelRows::TexelRows(const TexelFormat& to, const PixelFormat& from, bool swap_bytes,
                     const PixelTransfer& transfer, uint64_t pixels)
    : to_(to), from_(from), swap_bytes_(swap_bytes), transfer_(transfer) {
  constexpr uint64_t kWorthALook = 64;
  takes_bytes_ = pixels >= kWorthALook && !transfer.changes_color() && bytes_.find(to, from);
  if (takes_bytes_) return;
  // Each byte of a texel is made of one component of its pixel, or of none: so a word for each value of each
  // component tells all. Measured: 16 million luminances take 20 ms in place of 250.
  constexpr uint64_t kWorthATable = 4096;
  if (to.layout != TexelLayout::Rgba8 || from.channel != PixelChannel::UnsignedByte || from.components > 2 ||
      pixels < kWorthATable)
    return;
  unsigned char pixel[256 * 2];
  for (int k = 0; k < from.components; ++k) {
    std::memset(pixel, 0, sizeof pixel);
    for (int v = 0; v < 256; ++v) pixel[v * from.components + k] = uint8_t(v);
    store_texels(to, table_[k], from, pixel, 256, swap_bytes, transfer);
    if (k > 0) // what a pixel of zeros gives is in the first component's words
      for (int v = 255; v >= 0; --v) table_[k][v] ^= table_[k][0];
  }
  table_components_ = from.components;
}

void TexelRows::store(void* texels, const void* pixels, int count) const {
  const auto* p = static_cast<const uint8_t*>(pixels);
  auto* texel = static_cast<uint32_t*>(texels);
  if (takes_bytes_) return bytes_.store(texel, p, count);
  switch (table_components_) {
  case 1:
    for (int i = 0; i < count; ++i) texel[i] = table_[0][p[i]];
    return;
  case 2:
    for (int i = 0; i < count; ++i) texel[i] = table_[0][p[2 * i]] ^ table_[1][p[2 * i + 1]];
    return;
  default: store_texels(to_, texels, from_, pixels, count, swap_bytes_, transfer_);
  }
}

void store_color_indexes(const TexelFormat& to, void* texels, const PixelFormat& from, const void* pixels,
                         int bit_offset, int count, bool swap_bytes, bool lsb_first,
                         const PixelTransfer& transfer) {
  const PixelFormat color = describe_pixel_format(GL_RGBA, GL_UNSIGNED_BYTE); // for wider texels, too
  auto p = static_cast<const unsigned char*>(pixels);
  auto t = static_cast<unsigned char*>(texels);
  for (int done = 0; done < count; done += kTexelRow) {
    const int n = std::min(kTexelRow, count - done);
    uint32_t index[kTexelRow];
    uint8_t rgba[kTexelRow][4];
    unpack_indexes(from, p + size_t(done) * from.bytes,
                   from.channel == PixelChannel::Bitmap ? bit_offset + done : 0, n, swap_bytes, lsb_first,
                   index);
    for (int i = 0; i < n; ++i) {
      float value[4];
      transfer.index_to_color(index[i], value);
      for (int k = 0; k < 4; ++k) rgba[i][k] = uint8_t(float_to_unorm(value[k], 8));
    }
    store_texels(to, t + size_t(done) * size_t(to.bytes()), color, rgba, n, false, PixelTransfer::none());
  }
}

} // namespace softgl
