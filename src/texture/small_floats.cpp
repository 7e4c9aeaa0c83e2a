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
  if (exponent == 0) return float(fraction) * std::bit_cast<float>(uint32_t(113 - mantissa) << 23);
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
  // 2 to the power of the exponent, which is -24 to 7.
  const float scale = std::bit_cast<float>(((word >> 27) - 15 - 9 + 127) << 23);
  for (int k = 0; k < 3; ++k) rgb[k] = float(word >> (9 * k) & 511) * scale;
}

// The extension's own algorithm.
uint32_t floats_to_shared_exponent(const float* rgb) {
  const float most = 511.0f / 512.0f * 65536.0f;
  float value[3], largest = 0;
  for (int k = 0; k < 3; ++k) {
    value[k] = rgb[k] > 0 ? std::min(rgb[k], most) : 0.0f;
    largest = std::max(largest, value[k]);
  }
  // The logarithm, cut to a whole number; of those too small for a normal number it does not matter.
  const int logarithm = int(std::bit_cast<uint32_t>(largest) >> 23) - 127;
  int exponent = std::max(-16, logarithm) + 16;
  const auto mantissa = [&](float v) {
    const auto scale = std::bit_cast<double>(uint64_t(1023 + 24 - exponent) << 52); // 2^(24 - exponent)
    return uint32_t(double(v) * scale + 0.5);
  };
  if (mantissa(largest) == 512) ++exponent;
  return mantissa(value[0]) | mantissa(value[1]) << 9 | mantissa(value[2]) << 18 | uint32_t(exponent) << 27;
}

namespace {

/// `value` for each of `count` floats.
template <class F> void replace(float* v, int count, F value) {
  for (int i = 0; i < count; ++i)
    v[i] = std::bit_cast<float>(
        value(std::bit_cast<uint32_t>(v[i]), std::bit_cast<uint32_t>(v[i]) & 0x7fffffffu));
}

/// What is below 2^-14 in units of the smallest half; of others some number.
float in_smallest_halves(uint32_t magnitude) {
  return std::bit_cast<float>(std::min(magnitude, 0x38800000u)) * 16777216.0f;
}

} // namespace

void reduce_to_halves(float* v, int count) {
  replace(v, count, [](uint32_t bits, uint32_t magnitude) {
    const uint32_t sign = bits & 0x80000000u, normal = magnitude & 0xffffe000u;
    const float small = float(int32_t(in_smallest_halves(magnitude))) * (1.0f / 16777216.0f);
    const uint32_t finite = std::min(normal, 0x477fe000u); // 65504
    uint32_t result = magnitude < 0x38800000u ? std::bit_cast<uint32_t>(small) : finite;
    result = magnitude == kInfinity ? kInfinity : result;
    result = magnitude > kInfinity ? 0x7fc00000u : result;
    return sign | result;
  });
}

void round_to_halves(float* v, int count) {
  replace(v, count, [](uint32_t bits, uint32_t magnitude) {
    const uint32_t sign = bits & 0x80000000u;
    const uint32_t normal = (magnitude + 0xfffu + (magnitude >> 13 & 1)) & 0xffffe000u;
    const float small = ((in_smallest_halves(magnitude) + 8388608.0f) - 8388608.0f) * (1.0f / 16777216.0f);
    uint32_t result = magnitude < 0x38800000u ? std::bit_cast<uint32_t>(small) : normal;
    result = magnitude >= 0x477ff000u ? kInfinity : result; // 65520 and more
    result = magnitude > kInfinity ? 0x7fc00000u : result;
    return sign | result;
  });
}

float reduce_to_unsigned_float(float value, int mantissa) {
  const uint32_t bits = std::bit_cast<uint32_t>(value), magnitude = bits & 0x7fffffffu;
  const uint32_t step = 1u << (23 - mantissa), most = 0x47800000u - step; // below 2^16
  uint32_t result = std::min(magnitude & ~(step - 1), most);
  result = magnitude == kInfinity ? kInfinity : result;
  result = (bits >> 31) != 0 || magnitude < 0x38800000u ? 0 : result;
  result = magnitude > kInfinity ? kInfinity | step : result;
  return std::bit_cast<float>(result);
}

} // namespace softgl
