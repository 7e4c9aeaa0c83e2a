#include "texture/drawn_values.h"

#include <bit>

#include "texture/component_values.h"

namespace softgl {
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

} // namespace softgl
