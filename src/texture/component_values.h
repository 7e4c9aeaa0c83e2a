// One component of a pixel in another form, as OSMesa 22.3.6 converts it. Everything is inline and without
// branches where it can be, so that loops over a row become vectors.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "texture/small_floats.h"

namespace softgl {

/// A value of `from` bits in `to` bits, as OSMesa converts it: repeated bits upwards, round to nearest
/// downwards.
constexpr uint32_t convert_unorm(uint32_t x, int from, int to) {
  if (from < to) {
    const uint64_t from_max = (uint64_t(1) << from) - 1, to_max = (uint64_t(1) << to) - 1;
    return x * uint32_t(to_max / from_max) + (to % from ? x >> (from - to % from) : 0);
  }
  if (from > to && from <= 16) { // 32 bits are enough, and vectors have them
    const uint32_t from_max = (1u << from) - 1, to_max = (1u << to) - 1;
    return (x * to_max + ((1u << (from - 1)) - 1)) / from_max;
  }
  if (from > to) {
    const uint64_t from_max = (uint64_t(1) << from) - 1, to_max = (uint64_t(1) << to) - 1;
    return uint32_t((x * to_max + ((uint64_t(1) << (from - 1)) - 1)) / from_max);
  }
  return x;
}

/// convert_unorm(x, bits, 8) of bits 0 to 8, without a division or a table, so that vectors can do it: the
/// bits repeated.
struct Widening {
  uint32_t times, down;
  constexpr uint32_t operator()(uint32_t x) const { return (x * times) >> down; }
};
constexpr Widening widening(int bits) {
  constexpr Widening kOfBits[9] = {{0, 0},  {255, 0}, {85, 0},  {73, 1}, {17, 0},
                                   {33, 2}, {65, 4},  {129, 6}, {1, 0}};
  return kOfBits[bits];
}
/// convert_unorm(x, 8, bits) of bits 0 to 8; 32897 / 2^23 divides numbers below 2^16 by 255.
struct Narrowing {
  uint32_t most;
  constexpr uint32_t operator()(uint32_t x) const { return ((x * most + 127) * 32897) >> 23; }
};
constexpr Narrowing narrowing(int bits) { return {(1u << bits) - 1}; }

namespace detail {

constexpr bool widens_and_narrows_as_convert_unorm() {
  for (int bits = 1; bits <= 8; ++bits)
    for (uint32_t x = 0; x < 256; ++x) {
      if (narrowing(bits)(x) != convert_unorm(x, 8, bits)) return false;
      if (x < 1u << bits && widening(bits)(x) != convert_unorm(x, bits, 8)) return false;
    }
  return narrowing(0)(255) == 0 && widening(0)(0) == 0;
}
static_assert(widens_and_narrows_as_convert_unorm());

} // namespace detail

/// The nearest integer of 0 <= v < 2^22, of two the even one.
inline uint32_t round_to_even(float v) { return std::bit_cast<uint32_t>(v + 8388608.0f) & 0x7fffffu; }
/// The same of |v| < 2^21.
inline int32_t round_signed_to_even(float v) {
  return std::bit_cast<int32_t>(v + 12582912.0f) - std::bit_cast<int32_t>(12582912.0f);
}
/// Into [0, 1]; not a number becomes 0.
inline float clamp_to_unit(float x) {
  const float positive = x > 0.0f ? x : 0.0f;
  return positive < 1.0f ? positive : 1.0f;
}

/// Round to nearest even of clamped x * (2^bits - 1); not a number gives 0 (as everywhere in softgl).
inline uint32_t float_to_unorm(float x, int bits) {
  if (bits <= 16) return round_to_even(clamp_to_unit(x) * float((1u << bits) - 1));
  const float max = float((uint64_t(1) << bits) - 1);
  if (!(x > 0.0f)) return 0;
  // The 32-bit product of 1.0f is 2^32, which OSMesa lets wrap to 0; here it stays the maximum.
  if (x >= 1.0f) return uint32_t((uint64_t(1) << bits) - 1);
  return uint32_t(uint64_t(std::nearbyintf(x * max)));
}
/// Round to nearest even of x * (2^(bits-1) - 1), x clamped to [-1, 1].
inline int32_t float_to_snorm(float x, int bits) {
  const int32_t max = int32_t((uint32_t(1) << (bits - 1)) - 1);
  if (bits <= 16) {
    const float number = x == x ? x : 0.0f, low = number > -1.0f ? number : -1.0f;
    return round_signed_to_even((low < 1.0f ? low : 1.0f) * float(max));
  }
  if (!(x >= -1.0f)) return x < -1.0f ? -max : 0;
  if (x >= 1.0f) return max;
  return int32_t(int64_t(std::nearbyintf(x * float(max))));
}
/// The other rounding of OSMesa, used when a whole RGBA group of floats is packed at once: halves go up,
/// except to 8 bits. At most 16 bits.
inline uint32_t pack_unorm(float x, int bits) {
  const float scaled = clamp_to_unit(x) * float((1u << bits) - 1);
  return bits == 8 ? round_to_even(scaled) : uint32_t(int32_t(scaled + 0.5f));
}
inline float unorm_to_float(uint32_t x, int bits) {
  // SSE2 converts signed integers only.
  const float value = bits < 32 ? float(int32_t(x)) : float(x);
  return value * (1.0f / float((uint64_t(1) << bits) - 1));
}
inline float snorm_to_float(int32_t x, int bits) {
  const int32_t max = int32_t((uint32_t(1) << (bits - 1)) - 1);
  return x <= -max ? -1.0f : float(x) * (1.0f / float(max));
}
inline int32_t convert_snorm(int32_t x, int from, int to) {
  const int32_t from_max = int32_t((uint32_t(1) << (from - 1)) - 1);
  if (from == to) return x;
  if (x < -from_max) return -int32_t((uint32_t(1) << (to - 1)) - 1);
  if (from > to) return x >> (from - to);
  // Bits are repeated; those of negative numbers round down.
  const int32_t to_max = int32_t((uint32_t(1) << (to - 1)) - 1), rest = (to - 1) % (from - 1);
  return x * (to_max / from_max) + (rest ? x >> (from - 1 - rest) : 0);
}

/// A float of 16 bits in memory.
struct Half {
  uint16_t bits;
};

/// One component of client memory in an intermediate form and back, as OSMesa converts arrays of components.
template <class Out, class In> Out component_to(In v) {
  constexpr bool in_float = std::is_same_v<In, float>, out_float = std::is_same_v<Out, float>;
  constexpr int in_bits = int(sizeof(In) * 8), out_bits = int(sizeof(Out) * 8);
  if constexpr (std::is_same_v<In, Half>)
    return component_to<Out>(half_to_float(v.bits));
  else if constexpr (std::is_same_v<Out, Half>)
    return Half{float_to_half(component_to<float>(v))};
  else if constexpr (std::is_same_v<In, Out>)
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

} // namespace softgl
