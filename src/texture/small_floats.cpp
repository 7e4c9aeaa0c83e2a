#include "texture/small_floats.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace softgl {

namespace {

constexpr uint32_t kInfinity = 0x7f800000u; // as bits of a float

/// `bits` of a number with 5 bits of exponent, below them `mantissa` bits.
float expand(uint32_t bits, int mantissa) {
  const uint32_t exponent = bits >> mantissa & 31, fraction = bits & ((1u << mantissa) - 1);
  if (exponent == 31) return std::bit_cast<float>(kInfinity | fraction << (23 - mantissa));
  if (exponent == 0) return std::ldexp(float(fraction), -14 - mantissa);
  return std::bit_cast<float>((exponent + 112) << 23 | fraction << (23 - mantissa));
}

} // namespace

float half_to_float(uint16_t half) {
  const float magnitude = expand(half & 0x7fffu, 10);
  return half & 0x8000u ? -magnitude : magnitude;
}

uint16_t float_to_half_towards_zero(float value) {
  const uint32_t bits = std::bit_cast<uint32_t>(value), magnitude = bits & 0x7fffffffu;
  const uint32_t sign = bits >> 16 & 0x8000u;
  if (magnitude > kInfinity) return uint16_t(sign | 0x7e00u);
  if (magnitude == kInfinity) return uint16_t(sign | 0x7c00u);
  if (magnitude >= 0x477fe000u) return uint16_t(sign | 0x7bffu); // 65504
  if (magnitude >= 0x38800000u) return uint16_t(sign | (magnitude - 0x38000000u) >> 13);
  return uint16_t(sign | uint32_t(std::fabs(value) * 16777216.0f)); // in units of the smallest one
}

uint16_t float_to_half(float value) {
  const uint32_t bits = std::bit_cast<uint32_t>(value), magnitude = bits & 0x7fffffffu;
  const uint32_t sign = bits >> 16 & 0x8000u;
  if (magnitude > kInfinity) return uint16_t(sign | 0x7e00u);
  if (magnitude >= 0x477ff000u) return uint16_t(sign | 0x7c00u); // 65520 and more
  if (magnitude >= 0x38800000u)
    return uint16_t(sign | (magnitude - 0x38000000u + 0xfffu + (magnitude >> 13 & 1)) >> 13);
  return uint16_t(sign | uint32_t(std::nearbyintf(std::fabs(value) * 16777216.0f)));
}

float unsigned_float(uint32_t bits, int mantissa) { return expand(bits, mantissa); }

uint32_t to_unsigned_float(float value, int mantissa) {
  const uint32_t infinity = 31u << mantissa, bits = std::bit_cast<uint32_t>(value);
  if (std::isnan(value)) return infinity | 1;
  if (bits & 0x80000000u || bits < 0x38800000u) return 0;
  if (bits == kInfinity) return infinity;
  return std::min((bits - 0x38000000u) >> (23 - mantissa), infinity - 1);
}

void shared_exponent_to_floats(uint32_t word, float* rgb) {
  const int exponent = int(word >> 27) - 15 - 9;
  for (int k = 0; k < 3; ++k) rgb[k] = std::ldexp(float(word >> (9 * k) & 511), exponent);
}

// The extension's own algorithm.
uint32_t floats_to_shared_exponent(const float* rgb) {
  const float most = 511.0f / 512.0f * 65536.0f;
  float value[3], largest = 0;
  for (int k = 0; k < 3; ++k) {
    value[k] = rgb[k] > 0 ? std::min(rgb[k], most) : 0.0f;
    largest = std::max(largest, value[k]);
  }
  int exponent = -16;
  if (largest > 0) exponent = std::max(exponent, std::ilogb(largest));
  exponent += 16;
  const auto mantissa = [&](float v) {
    return uint32_t(std::floor(std::ldexp(double(v), 24 - exponent) + 0.5));
  };
  if (mantissa(largest) == 512) ++exponent;
  return mantissa(value[0]) | mantissa(value[1]) << 9 | mantissa(value[2]) << 18 | uint32_t(exponent) << 27;
}

} // namespace softgl
