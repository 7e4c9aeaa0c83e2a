// exp2, log2 and pow with the polynomials and operation order of OSMesa 22.3.6 (llvmpipe without FMA), so
// that fog, spot lights and highlights have its bits. log2: absolute error <= 5.6e-7; exp2: relative error
// <= 2.6e-7.
#pragma once

#include "shaders/common/lane_math.h"

namespace softgl {
namespace SOFTGL_ISA {

/// 2^x; 0 below 2^-126.99999, infinity from 2^128 on.
static inline __attribute__((always_inline)) float exp2_lane(float x) {
  x = select(mask_of(128.0f < x), 128.0f, x);
  x = select(mask_of(-126.99999f > x), -126.99999f, x);
  const float whole = floor_of(x);
  const float f = x - whole;
  const float scale = bits_float((int32_t(whole) + 127) << 23);
  const float f2 = f * f;
  const float even = f2 * (f2 * 0.00898934009049466391101f + 0.240153617044375388211f) + 1.0f;
  const float odd =
      f2 * (f2 * 0.00187757667519147912699f + 0.0558263180532956664775f) + 0.693153073200168932794f;
  return scale * (odd * f + even);
}

/// log2 of a positive, finite x. 0 gives about -127.
static inline __attribute__((always_inline)) float log2_positive_lane(float x) {
  const int32_t bits = float_bits(x);
  const float exponent = float(((bits & 0x7f800000) >> 23) - 127);
  const float mantissa = bits_float((bits & 0x007fffff) | 0x3f800000);
  const float y = (mantissa - 1.0f) / (mantissa + 1.0f);
  const float z = y * y;
  const float z2 = z * z;
  const float even =
      z2 * (z2 * 0.406718052498846252698f + 0.577440339438736392009f) + 2.88539009343309178325f;
  const float odd = z2 * 0.403343858251329912514f + 0.961791550404184197881f;
  return y * (odd * z + even) + exponent;
}

/// log2 with log2(0) = -infinity, log2(infinity) = infinity, log2(negative) = not a number.
static inline __attribute__((always_inline)) float log2_lane(float x) {
  float result = log2_positive_lane(x);
  result = select(mask_of(x >= bits_float(0x7f800000)), bits_float(0x7f800000), result);
  result = select(mask_of(x == 0.0f), bits_float(int32_t(0xff800000)), result);
  return select(mask_of(x < 0.0f), bits_float(0x7fc00000), result);
}

/// x^y; 0^y = 0 for every y.
static inline __attribute__((always_inline)) float pow_lane(float x, float y) {
  return keep(~mask_of(x == 0.0f), exp2_lane(log2_lane(x) * y));
}

} // namespace SOFTGL_ISA
} // namespace softgl
