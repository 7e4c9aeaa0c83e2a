// Rows of depths, stencil values and color indexes in client memory. The form of a row's elements is chosen
// once, so that the loops over them become vectors.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "texture/component_values.h"
#include "texture/pixel_formats.h"
#include "texture/small_floats.h"

namespace softgl {
namespace {

template <class T> T load(const unsigned char* p, bool swap) {
  T v;
  std::memcpy(&v, p, sizeof v);
  if (swap) {
    auto* b = reinterpret_cast<unsigned char*>(&v);
    std::reverse(b, b + sizeof v);
  }
  return v;
}
template <class T> void store(unsigned char* p, T v, bool swap) {
  std::memcpy(p, &v, sizeof v);
  if (swap && sizeof v > 1) std::reverse(p, p + sizeof v);
}

/// out[i] = value(element i of the row), which is a T.
template <class T, class Out, class F>
void read_row(const unsigned char* p, int count, bool swap, Out* out, F value) {
  if (swap && sizeof(T) > 1)
    for (int i = 0; i < count; ++i) out[i] = value(load<T>(p + size_t(i) * sizeof(T), true));
  else
    for (int i = 0; i < count; ++i) out[i] = value(load<T>(p + size_t(i) * sizeof(T), false));
}
/// Element i of the row, which is a T, = value(in[i]).
template <class T, class In, class F>
void write_row(const In* in, int count, bool swap, unsigned char* p, F value) {
  if (swap && sizeof(T) > 1)
    for (int i = 0; i < count; ++i) store<T>(p + size_t(i) * sizeof(T), value(in[i]), true);
  else
    for (int i = 0; i < count; ++i) store<T>(p + size_t(i) * sizeof(T), value(in[i]), false);
}

uint32_t whole_number(float v) { return v > -2147483648.0f && v < 2147483648.0f ? uint32_t(int32_t(v)) : 0; }

} // namespace

void unpack_indexes(const PixelFormat& f, const void* row, int bit_offset, int count, bool swap,
                    bool lsb_first, uint32_t* index) {
  auto p = static_cast<const unsigned char*>(row);
  switch (f.channel) {
  case PixelChannel::UnsignedByte:
    return read_row<uint8_t>(p, count, swap, index, [](uint8_t v) { return v; });
  case PixelChannel::Byte:
    return read_row<int8_t>(p, count, swap, index, [](int8_t v) { return uint32_t(int32_t(v)); });
  case PixelChannel::UnsignedShort:
    return read_row<uint16_t>(p, count, swap, index, [](uint16_t v) { return v; });
  case PixelChannel::Short:
    return read_row<int16_t>(p, count, swap, index, [](int16_t v) { return uint32_t(int32_t(v)); });
  case PixelChannel::UnsignedInt:
  case PixelChannel::Int: return read_row<uint32_t>(p, count, swap, index, [](uint32_t v) { return v; });
  case PixelChannel::Float: return read_row<float>(p, count, swap, index, whole_number);
  case PixelChannel::Half:
    return read_row<uint16_t>(p, count, swap, index,
                              [](uint16_t v) { return whole_number(half_to_float(v)); });
  case PixelChannel::Bitmap:
    for (int i = 0; i < count; ++i) {
      const int bit = bit_offset + i;
      index[i] = (p[bit >> 3] >> (lsb_first ? bit & 7 : 7 - (bit & 7))) & 1;
    }
    return;
  default: std::fill_n(index, count, 0u);
  }
}

void unpack_depth(const PixelFormat& f, const void* row, int count, bool swap, float* depth) {
  auto p = static_cast<const unsigned char*>(row);
  switch (f.channel) {
  case PixelChannel::UnsignedByte: // a table of u / 255 in OSMesa
    return read_row<uint8_t>(p, count, swap, depth, [](uint8_t v) { return float(v) / 255.0f; });
  case PixelChannel::Byte:
    return read_row<int8_t>(p, count, swap, depth, [](int8_t v) {
      return v == 0 ? 0.0f : (2.0f * float(v) + 1.0f) * (1.0f / 255.0f);
    });
  case PixelChannel::UnsignedShort:
    return read_row<uint16_t>(p, count, swap, depth, [](uint16_t v) { return float(v) * (1.0f / 65535.0f); });
  case PixelChannel::Short:
    return read_row<int16_t>(p, count, swap, depth, [](int16_t v) {
      return v == 0 ? 0.0f : (2.0f * float(v) + 1.0f) * (1.0f / 65535.0f);
    });
  case PixelChannel::UnsignedInt:
    return read_row<uint32_t>(p, count, swap, depth,
                              [](uint32_t v) { return float(v * (1.0 / 4294967295.0)); });
  case PixelChannel::Int:
    return read_row<int32_t>(p, count, swap, depth, [](int32_t v) {
      return float((2.0f * float(v) + 1.0f) * (1.0 / 4294967294.0));
    });
  case PixelChannel::Float: return read_row<float>(p, count, swap, depth, [](float v) { return v; });
  case PixelChannel::Half: return read_row<uint16_t>(p, count, swap, depth, half_to_float);
  default: std::fill_n(depth, count, 0.0f);
  }
}

void pack_depth(const PixelFormat& f, const float* depth, int count, bool swap, void* row) {
  auto p = static_cast<unsigned char*>(row);
  switch (f.channel) {
  case PixelChannel::UnsignedByte:
    return write_row<uint8_t>(depth, count, swap, p, [](float d) { return uint8_t(int(d * 255.0f)); });
  case PixelChannel::Byte:
    return write_row<int8_t>(depth, count, swap, p,
                             [](float d) { return int8_t((int(255.0f * d) - 1) / 2); });
  case PixelChannel::UnsignedShort:
    return write_row<uint16_t>(depth, count, swap, p, [](float d) {
      const float scaled = d * 65535.0f; // beyond [0, 1] only floats of 32 bits
      return uint16_t(scaled >= 0.0f && scaled <= 65535.0f ? round_to_even(scaled)
                                                           : uint32_t(int32_t(std::nearbyintf(scaled))));
    });
  case PixelChannel::Short:
    return write_row<int16_t>(depth, count, swap, p,
                              [](float d) { return int16_t((int(65535.0f * d) - 1) / 2); });
  case PixelChannel::UnsignedInt:
    return write_row<uint32_t>(depth, count, swap, p,
                               [](float d) { return uint32_t(double(d) * 4294967295.0); });
  case PixelChannel::Int:
    return write_row<int32_t>(depth, count, swap, p,
                              [](float d) { return int32_t(2147483647.0 * double(d)); });
  case PixelChannel::Float: return write_row<float>(depth, count, swap, p, [](float d) { return d; });
  case PixelChannel::Half: return write_row<uint16_t>(depth, count, swap, p, float_to_half);
  default: return;
  }
}

DepthStencilPixel unpack_depth_stencil(const PixelFormat& f, const void* pixel, bool swap) {
  auto p = static_cast<const unsigned char*>(pixel);
  DepthStencilPixel v;
  v.integer = f.channel != PixelChannel::Float;
  if (v.integer) {
    const auto word = load<uint32_t>(p, swap);
    v.bits = word >> 8;
    v.depth = unorm_to_float(v.bits, 24);
    v.stencil = word & 255;
  } else {
    v.depth = load<float>(p, swap);
    v.stencil = load<uint32_t>(p + 4, swap) & 255;
  }
  return v;
}

void unpack_depths_and_stencils(const PixelFormat& f, const void* row, int count, bool swap, float* depth,
                                uint8_t* stencil) {
  auto p = static_cast<const unsigned char*>(row);
  if (f.channel != PixelChannel::Float) {
    read_row<uint32_t>(p, count, swap, depth, [](uint32_t v) { return unorm_to_float(v >> 8, 24); });
    read_row<uint32_t>(p, count, swap, stencil, [](uint32_t v) { return uint8_t(v); });
    return;
  }
  for (int i = 0; i < count; ++i) {
    const DepthStencilPixel v = unpack_depth_stencil(f, p + 8 * i, swap);
    depth[i] = v.depth, stencil[i] = uint8_t(v.stencil);
  }
}

void pack_depth_stencil(const PixelFormat& f, const DepthStencilPixel& v, bool swap, void* pixel) {
  auto p = static_cast<unsigned char*>(pixel);
  const uint32_t stencil = v.stencil & 255;
  if (f.channel == PixelChannel::Float) {
    store<float>(p, v.depth, swap);
    store<uint32_t>(p + 4, stencil, swap);
  } else {
    const uint32_t z = v.integer ? v.bits : uint32_t(v.depth * 16777215.0f);
    store<uint32_t>(p, z << 8 | stencil, swap);
  }
}

} // namespace softgl
