#include "texture/pixel_formats.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "texture/pixel_state.h"
#include "texture/small_floats.h"

namespace softgl {

namespace {

int packed_components(GLenum type) {
  switch (type) {
  case GL_UNSIGNED_BYTE_3_3_2:
  case GL_UNSIGNED_BYTE_2_3_3_REV:
  case GL_UNSIGNED_SHORT_5_6_5:
  case GL_UNSIGNED_SHORT_5_6_5_REV: return 3;
  case GL_UNSIGNED_SHORT_4_4_4_4:
  case GL_UNSIGNED_SHORT_4_4_4_4_REV:
  case GL_UNSIGNED_SHORT_5_5_5_1:
  case GL_UNSIGNED_SHORT_1_5_5_5_REV:
  case GL_UNSIGNED_INT_8_8_8_8:
  case GL_UNSIGNED_INT_8_8_8_8_REV:
  case GL_UNSIGNED_INT_10_10_10_2:
  case GL_UNSIGNED_INT_2_10_10_10_REV: return 4;
  default: return 0;
  }
}

/// Bits of the components, first component first, and whether the first one is the least significant.
struct PackedType {
  uint8_t bytes, bits[4];
  bool reversed;
};
PackedType packed_type(GLenum type) {
  switch (type) {
  case GL_UNSIGNED_BYTE_3_3_2: return {1, {3, 3, 2, 0}, false};
  case GL_UNSIGNED_BYTE_2_3_3_REV: return {1, {3, 3, 2, 0}, true};
  case GL_UNSIGNED_SHORT_5_6_5: return {2, {5, 6, 5, 0}, false};
  case GL_UNSIGNED_SHORT_5_6_5_REV: return {2, {5, 6, 5, 0}, true};
  case GL_UNSIGNED_SHORT_4_4_4_4: return {2, {4, 4, 4, 4}, false};
  case GL_UNSIGNED_SHORT_4_4_4_4_REV: return {2, {4, 4, 4, 4}, true};
  case GL_UNSIGNED_SHORT_5_5_5_1: return {2, {5, 5, 5, 1}, false};
  case GL_UNSIGNED_SHORT_1_5_5_5_REV: return {2, {5, 5, 5, 1}, true};
  case GL_UNSIGNED_INT_8_8_8_8: return {4, {8, 8, 8, 8}, false};
  case GL_UNSIGNED_INT_8_8_8_8_REV: return {4, {8, 8, 8, 8}, true};
  case GL_UNSIGNED_INT_10_10_10_2: return {4, {10, 10, 10, 2}, false};
  default: return {4, {10, 10, 10, 2}, true}; // GL_UNSIGNED_INT_2_10_10_10_REV
  }
}

bool depth_stencil_type(GLenum type) {
  return type == GL_UNSIGNED_INT_24_8 || type == GL_FLOAT_32_UNSIGNED_INT_24_8_REV;
}

bool plain_type(GLenum type) {
  switch (type) {
  case GL_UNSIGNED_BYTE:
  case GL_BYTE:
  case GL_UNSIGNED_SHORT:
  case GL_SHORT:
  case GL_UNSIGNED_INT:
  case GL_INT:
  case GL_FLOAT:
  case GL_HALF_FLOAT: return true;
  default: return false;
  }
}

} // namespace

Refusal check_pixel_format(GLenum format, GLenum type) {
  constexpr Refusal kFine, kWrongType{GL_INVALID_ENUM, "type"}, kMismatch{GL_INVALID_OPERATION};
  int components;
  switch (format) {
  case GL_COLOR_INDEX:
  case GL_STENCIL_INDEX:
  case GL_DEPTH_COMPONENT:
  case GL_RED:
  case GL_GREEN:
  case GL_BLUE:
  case GL_ALPHA:
  case GL_LUMINANCE: components = 1; break;
  case GL_LUMINANCE_ALPHA:
  case GL_RG: components = 2; break;
  case GL_RGB:
  case GL_BGR: components = 3; break;
  case GL_RGBA:
  case GL_BGRA:
  case GL_ABGR_EXT: components = 4; break;
  case GL_DEPTH_STENCIL: return depth_stencil_type(type) ? kFine : kWrongType;
  default: return {GL_INVALID_ENUM, "format"};
  }
  if (depth_stencil_type(type)) return kMismatch;
  if (type == GL_BITMAP) return format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX ? kFine : kWrongType;
  if (plain_type(type)) return kFine;
  if (type == GL_UNSIGNED_INT_10F_11F_11F_REV) return format == GL_RGB ? kFine : kMismatch;
  if (type == GL_UNSIGNED_INT_5_9_9_9_REV) return format == GL_RGB ? kFine : kWrongType;
  const int packed = packed_components(type);
  if (packed == 0) return kWrongType;
  if (packed != components || format == GL_BGR) return kMismatch;
  if (format == GL_ABGR_EXT) { // OSMesa: with components of one size only
    switch (type) {
    case GL_UNSIGNED_SHORT_4_4_4_4:
    case GL_UNSIGNED_SHORT_4_4_4_4_REV:
    case GL_UNSIGNED_INT_8_8_8_8:
    case GL_UNSIGNED_INT_8_8_8_8_REV: break;
    default: return kMismatch;
    }
  }
  return kFine;
}

PixelFormat describe_pixel_format(GLenum format, GLenum type) {
  PixelFormat f{};
  f.format = format;
  f.type = type;
  f.components = 1;
  switch (format) {
  case GL_GREEN: f.target[0] = 1; break;
  case GL_BLUE: f.target[0] = 2; break;
  case GL_ALPHA: f.target[0] = 3; break;
  case GL_LUMINANCE: f.luminance = true; break;
  case GL_LUMINANCE_ALPHA:
    f.luminance = true;
    f.components = 2;
    f.target[1] = 3;
    break;
  case GL_RG:
    f.components = 2;
    f.target[1] = 1;
    break;
  case GL_RGB:
    f.components = 3;
    f.target[1] = 1;
    f.target[2] = 2;
    break;
  case GL_BGR:
    f.components = 3;
    f.target[0] = 2;
    f.target[1] = 1;
    break;
  case GL_RGBA:
    f.components = 4;
    f.target[1] = 1;
    f.target[2] = 2;
    f.target[3] = 3;
    break;
  case GL_BGRA:
    f.components = 4;
    f.target[0] = 2;
    f.target[1] = 1;
    f.target[3] = 3;
    break;
  case GL_ABGR_EXT:
    f.components = 4;
    f.target[0] = 3;
    f.target[1] = 2;
    f.target[2] = 1;
    break;
  default: break; // red, indices, depth
  }
  switch (type) {
  case GL_UNSIGNED_BYTE:
    f.channel = PixelChannel::UnsignedByte;
    f.element_bytes = 1;
    break;
  case GL_BYTE:
    f.channel = PixelChannel::Byte;
    f.element_bytes = 1;
    break;
  case GL_UNSIGNED_SHORT:
    f.channel = PixelChannel::UnsignedShort;
    f.element_bytes = 2;
    break;
  case GL_SHORT:
    f.channel = PixelChannel::Short;
    f.element_bytes = 2;
    break;
  case GL_UNSIGNED_INT:
  case GL_UNSIGNED_INT_24_8: // of GL_DEPTH_STENCIL
    f.channel = PixelChannel::UnsignedInt;
    f.element_bytes = 4;
    break;
  case GL_INT:
    f.channel = PixelChannel::Int;
    f.element_bytes = 4;
    break;
  case GL_FLOAT:
  case GL_FLOAT_32_UNSIGNED_INT_24_8_REV: // of GL_DEPTH_STENCIL
    f.channel = PixelChannel::Float;
    f.element_bytes = 4;
    break;
  case GL_HALF_FLOAT:
    f.channel = PixelChannel::Half;
    f.element_bytes = 2;
    break;
  case GL_UNSIGNED_INT_10F_11F_11F_REV:
  case GL_UNSIGNED_INT_5_9_9_9_REV:
    f.channel = PixelChannel::PackedFloat;
    f.element_bytes = f.bytes = 4;
    return f;
  case GL_BITMAP:
    f.channel = PixelChannel::Bitmap;
    f.element_bytes = 1;
    break;
  default: {
    const PackedType p = packed_type(type);
    f.channel = PixelChannel::Packed;
    f.element_bytes = f.bytes = p.bytes;
    int used = 0;
    for (int i = 0; i < f.components; ++i) {
      f.bits[i] = p.bits[i];
      f.shift[i] = uint8_t(p.reversed ? used : p.bytes * 8 - used - p.bits[i]);
      used += p.bits[i];
    }
    return f;
  }
  }
  f.bytes = type == GL_BITMAP ? 0 : uint8_t(f.components * f.element_bytes);
  if (type == GL_FLOAT_32_UNSIGNED_INT_24_8_REV) f.bytes = 8; // a word of stencil values behind the float
  return f;
}

ImageLayout layout_image(const PixelStore& store, int dimensions, int width, int height,
                         const PixelFormat& format) {
  ImageLayout layout{};
  const size_t row_pixels = size_t(store.row_length > 0 ? store.row_length : width);
  const size_t rows = size_t(dimensions == 3 && store.image_height > 0 ? store.image_height : height);
  const size_t alignment = size_t(store.alignment);
  if (format.channel == PixelChannel::Bitmap) {
    layout.row_stride = ((row_pixels + 7) / 8 + alignment - 1) / alignment * alignment;
    layout.bit_offset = store.skip_pixels % 8;
    layout.offset = size_t(store.skip_pixels / 8);
    layout.row_bytes = (size_t(width) + size_t(layout.bit_offset) + 7) / 8;
  } else {
    layout.row_stride = (row_pixels * format.bytes + alignment - 1) / alignment * alignment;
    layout.offset = size_t(store.skip_pixels) * format.bytes;
    layout.row_bytes = size_t(width) * format.bytes;
  }
  layout.image_stride = layout.row_stride * rows;
  layout.inverted = store.invert ? height : 0;
  if (dimensions >= 2) layout.offset += size_t(store.skip_rows) * layout.row_stride;
  if (dimensions == 3) layout.offset += size_t(store.skip_images) * layout.image_stride;
  return layout;
}

uint32_t float_to_unorm(float x, int bits) {
  const float max = float((uint64_t(1) << bits) - 1);
  if (!(x > 0.0f)) return 0;
  // The 32-bit product of 1.0f is 2^32, which OSMesa lets wrap to 0; here it stays the maximum.
  if (x >= 1.0f) return uint32_t((uint64_t(1) << bits) - 1);
  return uint32_t(uint64_t(std::nearbyintf(x * max)));
}

namespace {

/// Fewer bits of `from`: 4 bits are rounded, the upper ones of more are kept, fewer are rounded nearly.
uint32_t reduce_bits(uint32_t value, int from, int to) {
  const int drop = from - to;
  if (to == 4) return convert_unorm(value, from, to);
  if (drop <= to) return value >> drop;
  return ((value >> to) * ((1u << to) - 1) + (1u << (drop - 1))) >> drop;
}

} // namespace

uint8_t reduced_byte(uint32_t value, int bits) {
  return uint8_t(bits == 0 || bits == 8 ? value : convert_unorm(reduce_bits(value, 8, bits), bits, 8));
}

// A float has no room for 32 bits: OSMesa reads the upper 23 and writes 31.
float wide_to_float(uint32_t value, int bits) {
  if (bits < 32) return unorm_to_float(value, bits);
  return (std::bit_cast<float>(value >> 9 | 0x3f800000u) - 1.0f) * 1.00000011920930376163766f;
}
uint32_t float_to_wide(float value, int bits) {
  if (bits == 2 || bits == 10) return reduce_bits(float_to_unorm(value, 16), 16, bits);
  if (bits < 32) return float_to_unorm(value, bits);
  const uint32_t scaled = uint32_t(value * 2147483648.0f);
  return (scaled << 1) - (scaled >> 31);
}

uint32_t pack_unorm(float x, int bits) {
  if (bits == 8) return float_to_unorm(x, bits);
  if (!(x > 0.0f)) return 0;
  const float clamped = x < 1.0f ? x : 1.0f;
  return uint32_t(clamped * float((1u << bits) - 1) + 0.5f);
}

int32_t float_to_snorm(float x, int bits) {
  const int32_t max = int32_t((uint32_t(1) << (bits - 1)) - 1);
  if (!(x >= -1.0f)) return x < -1.0f ? -max : 0;
  if (x >= 1.0f) return max;
  return int32_t(int64_t(std::nearbyintf(x * float(max))));
}

namespace {

struct Half {
  uint16_t bits;
};

float snorm_to_float(int32_t x, int bits) {
  const int32_t max = int32_t((uint32_t(1) << (bits - 1)) - 1);
  return x <= -max ? -1.0f : float(x) * (1.0f / float(max));
}

template <class T> T load(const unsigned char* p, bool swap) {
  T v;
  std::memcpy(&v, p, sizeof v);
  if (swap) {
    unsigned char b[sizeof v];
    std::memcpy(b, &v, sizeof v);
    std::reverse(b, b + sizeof v);
    std::memcpy(&v, b, sizeof v);
  }
  return v;
}
template <class T> void store(unsigned char* p, T v, bool swap) {
  std::memcpy(p, &v, sizeof v);
  if (swap && sizeof v > 1) std::reverse(p, p + sizeof v);
}

int32_t convert_snorm(int32_t x, int from, int to) {
  const int32_t from_max = int32_t((uint32_t(1) << (from - 1)) - 1);
  if (from == to) return x;
  if (x < -from_max) return -int32_t((uint32_t(1) << (to - 1)) - 1);
  if (from > to) return x >> (from - to);
  // Bits are repeated; those of negative numbers round down.
  const int32_t to_max = int32_t((uint32_t(1) << (to - 1)) - 1), rest = (to - 1) % (from - 1);
  return x * (to_max / from_max) + (rest ? x >> (from - 1 - rest) : 0);
}

// One component of client memory in an intermediate form and back, as OSMesa converts arrays of components.
template <class Out, class In> Out component_to(In v) {
  constexpr bool in_float = std::is_same_v<In, float>, out_float = std::is_same_v<Out, float>;
  constexpr int in_bits = int(sizeof(In) * 8), out_bits = int(sizeof(Out) * 8);
  if constexpr (std::is_same_v<In, Half>)
    return component_to<Out>(half_to_float(v.bits));
  else if constexpr (std::is_same_v<Out, Half>)
    return Half{float_to_half(component_to<float>(v))};
  else if constexpr (in_float && out_float)
    return v;
  else if constexpr (in_float && std::is_signed_v<Out>)
    return Out(float_to_snorm(v, out_bits));
  else if constexpr (in_float)
    return Out(float_to_unorm(v, out_bits));
  else if constexpr (out_float && std::is_signed_v<In>)
    return snorm_to_float(v, in_bits);
  else if constexpr (out_float)
    return unorm_to_float(v, in_bits);
  else if constexpr (std::is_signed_v<In> && std::is_signed_v<Out>)
    return Out(convert_snorm(v, in_bits, out_bits));
  else if constexpr (std::is_signed_v<In>)
    return v < 0 ? Out(0) : Out(convert_unorm(uint32_t(v), in_bits - 1, out_bits));
  else if constexpr (std::is_signed_v<Out>)
    return Out(convert_unorm(v, in_bits, out_bits - 1));
  else
    return Out(convert_unorm(v, in_bits, out_bits));
}

template <class T> constexpr T one() { return std::numeric_limits<T>::max(); }
template <> constexpr float one<float>() { return 1.0f; }

/// The number of components is known to the compiler, and which of them is where does not change on the way:
/// half of the time.
template <class In, int components, class Out>
void unpack_components(const PixelFormat& f, const unsigned char* p, int count, bool swap, Out (*rgba)[4]) {
  constexpr int kZero = components, kOne = components + 1;
  int from[4] = {kZero, kZero, kZero, kOne};
  for (int k = 0; k < components; ++k) from[f.target[k]] = k;
  if (f.luminance) from[1] = from[2] = from[0];
  Out value[components + 2];
  value[kZero] = 0, value[kOne] = one<Out>();
  for (int i = 0; i < count; ++i, p += components * sizeof(In)) {
    for (int k = 0; k < components; ++k)
      value[k] = component_to<Out>(load<In>(p + size_t(k) * sizeof(In), swap));
    for (int k = 0; k < 4; ++k) rgba[i][k] = value[from[k]];
  }
}

template <class In, class Out>
void unpack_array(const PixelFormat& f, const unsigned char* p, int count, bool swap, Out (*rgba)[4]) {
  swap = swap && sizeof(In) > 1;
  switch (f.components) {
  case 1: return unpack_components<In, 1>(f, p, count, swap, rgba);
  case 2: return unpack_components<In, 2>(f, p, count, swap, rgba);
  case 3: return unpack_components<In, 3>(f, p, count, swap, rgba);
  default: return unpack_components<In, 4>(f, p, count, swap, rgba);
  }
}
template <class Out, class In>
void pack_array(const PixelFormat& f, const In (*rgba)[4], int count, bool swap, unsigned char* p) {
  swap = swap && sizeof(Out) > 1;
  for (int i = 0; i < count; ++i, p += f.bytes, ++rgba)
    for (int k = 0; k < f.components; ++k)
      store<Out>(p + size_t(k) * sizeof(Out), component_to<Out>((*rgba)[f.target[k]]), swap);
}

uint32_t load_packed(const PixelFormat& f, const unsigned char* p, bool swap) {
  return f.bytes == 1 ? *p : f.bytes == 2 ? load<uint16_t>(p, swap) : load<uint32_t>(p, swap);
}
void store_packed(const PixelFormat& f, unsigned char* p, uint32_t v, bool swap) {
  if (f.bytes == 1)
    *p = uint8_t(v);
  else if (f.bytes == 2)
    store<uint16_t>(p, uint16_t(v), swap);
  else
    store<uint32_t>(p, v, swap);
}
bool wide_packed(const PixelFormat& f) { return f.bits[0] > 8; }

// 8_8_8_8 are arrays of bytes to OSMesa; the smaller ones go by 8 bits, 10_10_10_2 and 16-bit results by
// floats.
template <class Out>
void unpack_packed(const PixelFormat& f, const unsigned char* p, int count, bool swap, Out (*rgba)[4]) {
  for (int i = 0; i < count; ++i, p += f.bytes, ++rgba) {
    const uint32_t word = load_packed(f, p, swap);
    Out out[4] = {0, 0, 0, one<Out>()};
    for (int k = 0; k < f.components; ++k) {
      const int bits = f.bits[k];
      const uint32_t v = (word >> f.shift[k]) & ((1u << bits) - 1);
      if constexpr (std::is_same_v<Out, float>)
        out[f.target[k]] = unorm_to_float(v, bits);
      else if constexpr (std::is_signed_v<Out>)
        out[f.target[k]] = component_to<Out>(unorm_to_float(v, bits));
      else if (sizeof(Out) == 1 || bits == 8)
        out[f.target[k]] = Out(convert_unorm(v, bits, int(sizeof(Out) * 8)));
      else
        out[f.target[k]] = Out(float_to_unorm(unorm_to_float(v, bits), 16));
    }
    std::memcpy(*rgba, out, sizeof out);
  }
}
template <class In>
void pack_packed(const PixelFormat& f, const In (*rgba)[4], int count, bool swap, unsigned char* p) {
  for (int i = 0; i < count; ++i, p += f.bytes, ++rgba) {
    uint32_t word = 0;
    for (int k = 0; k < f.components; ++k) {
      const int bits = f.bits[k];
      const In in = (*rgba)[f.target[k]];
      uint32_t v;
      if constexpr (std::is_same_v<In, float>)
        v = pack_unorm(in, bits);
      else if constexpr (std::is_signed_v<In>)
        v = pack_unorm(component_to<float>(in), bits);
      else if constexpr (sizeof(In) == 1)
        v = convert_unorm(in, 8, bits);
      else
        v = wide_packed(f) ? pack_unorm(unorm_to_float(in, 16), bits)
                           : convert_unorm(convert_unorm(in, 16, 8), 8, bits);
      word |= v << f.shift[k];
    }
    store_packed(f, p, word, swap);
  }
}

template <class Out> void unpack_packed_floats(const PixelFormat& f, const unsigned char* p, int count,
                                               bool swap, Out (*rgba)[4]) {
  for (int i = 0; i < count; ++i, p += 4) {
    const uint32_t word = load<uint32_t>(p, swap);
    float v[3];
    if (f.type == GL_UNSIGNED_INT_5_9_9_9_REV)
      shared_exponent_to_floats(word, v);
    else
      v[0] = unsigned_float(word & 2047, 6), v[1] = unsigned_float(word >> 11 & 2047, 6),
      v[2] = unsigned_float(word >> 22, 5);
    for (int k = 0; k < 3; ++k) rgba[i][k] = component_to<Out>(v[k]);
    rgba[i][3] = one<Out>();
  }
}
template <class In>
void pack_packed_floats(const PixelFormat& f, const In (*rgba)[4], int count, bool swap, unsigned char* p) {
  for (int i = 0; i < count; ++i, p += 4) {
    float v[3];
    for (int k = 0; k < 3; ++k) v[k] = component_to<float>(rgba[i][k]);
    store<uint32_t>(p,
                    f.type == GL_UNSIGNED_INT_5_9_9_9_REV
                        ? floats_to_shared_exponent(v)
                        : to_unsigned_float(v[0], 6) | to_unsigned_float(v[1], 6) << 11 |
                              to_unsigned_float(v[2], 5) << 22,
                    swap);
  }
}

template <class Out>
void unpack(const PixelFormat& f, const void* row, int count, bool swap, Out (*rgba)[4]) {
  auto p = static_cast<const unsigned char*>(row);
  switch (f.channel) {
  case PixelChannel::UnsignedByte: unpack_array<uint8_t>(f, p, count, swap, rgba); break;
  case PixelChannel::Byte: unpack_array<int8_t>(f, p, count, swap, rgba); break;
  case PixelChannel::UnsignedShort: unpack_array<uint16_t>(f, p, count, swap, rgba); break;
  case PixelChannel::Short: unpack_array<int16_t>(f, p, count, swap, rgba); break;
  case PixelChannel::UnsignedInt: unpack_array<uint32_t>(f, p, count, swap, rgba); break;
  case PixelChannel::Int: unpack_array<int32_t>(f, p, count, swap, rgba); break;
  case PixelChannel::Float: unpack_array<float>(f, p, count, swap, rgba); break;
  case PixelChannel::Half: unpack_array<Half>(f, p, count, swap, rgba); break;
  case PixelChannel::PackedFloat: unpack_packed_floats(f, p, count, swap, rgba); break;
  case PixelChannel::Packed: unpack_packed(f, p, count, swap, rgba); break;
  case PixelChannel::Bitmap: std::memset(static_cast<void*>(rgba), 0, size_t(count) * sizeof *rgba); break;
  }
}
template <class In> void pack(const PixelFormat& f, const In (*rgba)[4], int count, bool swap, void* row) {
  auto p = static_cast<unsigned char*>(row);
  switch (f.channel) {
  case PixelChannel::UnsignedByte: pack_array<uint8_t>(f, rgba, count, swap, p); break;
  case PixelChannel::Byte: pack_array<int8_t>(f, rgba, count, swap, p); break;
  case PixelChannel::UnsignedShort: pack_array<uint16_t>(f, rgba, count, swap, p); break;
  case PixelChannel::Short: pack_array<int16_t>(f, rgba, count, swap, p); break;
  case PixelChannel::UnsignedInt: pack_array<uint32_t>(f, rgba, count, swap, p); break;
  case PixelChannel::Int: pack_array<int32_t>(f, rgba, count, swap, p); break;
  case PixelChannel::Float: pack_array<float>(f, rgba, count, swap, p); break;
  case PixelChannel::Half: pack_array<Half>(f, rgba, count, swap, p); break;
  case PixelChannel::PackedFloat: pack_packed_floats(f, rgba, count, swap, p); break;
  case PixelChannel::Packed: pack_packed(f, rgba, count, swap, p); break;
  case PixelChannel::Bitmap: break;
  }
}

} // namespace

void unpack_pixels(const PixelFormat& f, const void* row, int count, bool swap, uint8_t (*rgba)[4]) {
  // The two layouts of nearly every texture.
  if (f.channel == PixelChannel::UnsignedByte && f.format == GL_RGBA) {
    std::memcpy(static_cast<void*>(rgba), row, size_t(count) * 4);
    return;
  }
  if (f.channel == PixelChannel::UnsignedByte && f.format == GL_RGB) {
    auto p = static_cast<const unsigned char*>(row);
    for (int i = 0; i < count; ++i) {
      const uint8_t r = p[3 * i], g = p[3 * i + 1], b = p[3 * i + 2];
      rgba[i][0] = r, rgba[i][1] = g, rgba[i][2] = b, rgba[i][3] = 255;
    }
    return;
  }
  unpack(f, row, count, swap, rgba);
}
void unpack_pixels(const PixelFormat& f, const void* row, int count, bool swap, uint16_t (*rgba)[4]) {
  unpack(f, row, count, swap, rgba);
}
void unpack_pixels(const PixelFormat& f, const void* row, int count, bool swap, float (*rgba)[4]) {
  unpack(f, row, count, swap, rgba);
}
void unpack_pixels(const PixelFormat& f, const void* row, int count, bool swap, int8_t (*rgba)[4]) {
  unpack(f, row, count, swap, rgba);
}
void unpack_pixels(const PixelFormat& f, const void* row, int count, bool swap, int16_t (*rgba)[4]) {
  unpack(f, row, count, swap, rgba);
}
void pack_pixels(const PixelFormat& f, const int8_t (*rgba)[4], int count, bool swap, void* row) {
  pack(f, rgba, count, swap, row);
}
void pack_pixels(const PixelFormat& f, const int16_t (*rgba)[4], int count, bool swap, void* row) {
  pack(f, rgba, count, swap, row);
}
void pack_pixels(const PixelFormat& f, const uint8_t (*rgba)[4], int count, bool swap, void* row) {
  if (f.channel == PixelChannel::UnsignedByte && f.format == GL_RGBA) {
    std::memcpy(row, rgba, size_t(count) * 4);
    return;
  }
  pack(f, rgba, count, swap, row);
}
void pack_pixels(const PixelFormat& f, const uint16_t (*rgba)[4], int count, bool swap, void* row) {
  pack(f, rgba, count, swap, row);
}
void pack_pixels(const PixelFormat& f, const float (*rgba)[4], int count, bool swap, void* row) {
  pack(f, rgba, count, swap, row);
}

void unpack_indexes(const PixelFormat& f, const void* row, int bit_offset, int count, bool swap,
                    bool lsb_first, uint32_t* index) {
  auto p = static_cast<const unsigned char*>(row);
  for (int i = 0; i < count; ++i, p += f.bytes) {
    switch (f.channel) {
    case PixelChannel::UnsignedByte: index[i] = *p; break;
    case PixelChannel::Byte: index[i] = uint32_t(int32_t(int8_t(*p))); break;
    case PixelChannel::UnsignedShort: index[i] = load<uint16_t>(p, swap); break;
    case PixelChannel::Short: index[i] = uint32_t(int32_t(load<int16_t>(p, swap))); break;
    case PixelChannel::UnsignedInt:
    case PixelChannel::Int: index[i] = load<uint32_t>(p, swap); break;
    case PixelChannel::Float:
    case PixelChannel::Half: {
      const float v =
          f.channel == PixelChannel::Half ? half_to_float(load<uint16_t>(p, swap)) : load<float>(p, swap);
      index[i] = v > -2147483648.0f && v < 2147483648.0f ? uint32_t(int32_t(v)) : 0;
      break;
    }
    case PixelChannel::Bitmap: {
      const int bit = bit_offset + i;
      index[i] = (p[bit >> 3] >> (lsb_first ? bit & 7 : 7 - (bit & 7))) & 1;
      break;
    }
    default: index[i] = 0;
    }
  }
}

void unpack_depth(const PixelFormat& f, const void* row, int count, bool swap, float* depth) {
  auto p = static_cast<const unsigned char*>(row);
  for (int i = 0; i < count; ++i, p += f.bytes) {
    float d = 0;
    switch (f.channel) {
    case PixelChannel::UnsignedByte: d = float(*p) / 255.0f; break; // a table of u / 255 in OSMesa
    case PixelChannel::Byte: {
      const int v = int8_t(*p);
      d = v == 0 ? 0.0f : (2.0f * float(v) + 1.0f) * (1.0f / 255.0f);
      break;
    }
    case PixelChannel::UnsignedShort: d = float(load<uint16_t>(p, swap)) * (1.0f / 65535.0f); break;
    case PixelChannel::Short: {
      const int v = load<int16_t>(p, swap);
      d = v == 0 ? 0.0f : (2.0f * float(v) + 1.0f) * (1.0f / 65535.0f);
      break;
    }
    case PixelChannel::UnsignedInt: d = float(load<uint32_t>(p, swap) * (1.0 / 4294967295.0)); break;
    case PixelChannel::Int:
      d = float((2.0f * float(load<int32_t>(p, swap)) + 1.0f) * (1.0 / 4294967294.0));
      break;
    case PixelChannel::Float: d = load<float>(p, swap); break;
    case PixelChannel::Half: d = half_to_float(load<uint16_t>(p, swap)); break;
    default: break;
    }
    depth[i] = d;
  }
}

void pack_depth(const PixelFormat& f, const float* depth, int count, bool swap, void* row) {
  auto p = static_cast<unsigned char*>(row);
  for (int i = 0; i < count; ++i, p += f.bytes) {
    const float d = depth[i];
    switch (f.channel) {
    case PixelChannel::UnsignedByte: *p = uint8_t(int(d * 255.0f)); break;
    case PixelChannel::Byte: *p = uint8_t(int8_t((int(255.0f * d) - 1) / 2)); break;
    case PixelChannel::UnsignedShort:
      store<uint16_t>(p, uint16_t(std::nearbyintf(d * 65535.0f)), swap);
      break;
    case PixelChannel::Short: store<int16_t>(p, int16_t((int(65535.0f * d) - 1) / 2), swap); break;
    case PixelChannel::UnsignedInt: store<uint32_t>(p, uint32_t(double(d) * 4294967295.0), swap); break;
    case PixelChannel::Int: store<int32_t>(p, int32_t(2147483647.0 * double(d)), swap); break;
    case PixelChannel::Float: store<float>(p, d, swap); break;
    case PixelChannel::Half: store<uint16_t>(p, float_to_half(d), swap); break;
    default: break;
    }
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
