// The numbers that colors of fewer bits are kept as (ColorEncoding), as OSMesa 22.3.6 cuts them. For kernels
// and for those who store colors without drawing.
#pragma once

#include <stdint.h>

namespace softgl {

/// `bits` of a number in `wide` ones (8 or 16): repeated until they fill them.
static inline uint32_t fill_bits(uint32_t v, int bits, int wide) {
  uint32_t filled = v << (wide - bits);
  for (int n = bits; n < wide; n *= 2) filled |= filled >> n;
  return filled;
}
/// The upper bits of a number of `wide` ones that a drawn color keeps: cut, but rounded to four and fewer.
static inline uint32_t drawn_bits(uint32_t v, int bits, int wide) {
  const int rest = wide - bits;
  if (rest == 0) return v;
  if (bits == 4 && wide == 8) return (v + 8) / 17;
  if (rest <= bits) return v >> rest;
  return ((v >> bits) * ((1u << bits) - 1) + (1u << (rest - 1))) >> rest;
}
/// A drawn number of `wide` bits as it is kept.
static inline uint32_t drawn_number(uint32_t v, int bits, int wide) {
  return bits == wide ? v : fill_bits(drawn_bits(v, bits, wide), bits, wide);
}

/// A drawn float of 16 (half), 11 or 10 bits: the next one towards zero, at most the greatest finite one.
/// Those of 11 and 10 bits have no sign.
static inline float drawn_float(float v, int bits) {
  if (bits == 32) return v;
  const int mantissa = bits == 16 ? 10 : bits - 5;
  const uint32_t word = __builtin_bit_cast(uint32_t, v), sign = bits == 16 ? word & 0x80000000u : 0;
  const uint32_t infinity = 0x7f800000u, cut = 23u - uint32_t(mantissa), mask = ~((1u << cut) - 1);
  uint32_t magnitude = word & 0x7fffffffu;
  if (magnitude > infinity) return __builtin_bit_cast(float, sign | 0x7fc00000u);
  if (bits != 16 && (word & 0x80000000u)) return 0.0f;
  if (magnitude == infinity) return v;
  const uint32_t most = 0x47000000u | (0x7fffffu & mask); // exponent 15
  if (magnitude >= 0x38800000u) {                         // 2^-14, the least with all bits
    magnitude = magnitude < most ? magnitude & mask : most;
  } else {
    const float steps = float(1u << (14 + mantissa));
    const float whole = float(int32_t(__builtin_bit_cast(float, magnitude) * steps)) / steps;
    magnitude = __builtin_bit_cast(uint32_t, whole);
  }
  return __builtin_bit_cast(float, sign | magnitude);
}

} // namespace softgl
