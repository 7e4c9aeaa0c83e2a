// The transfer function of sRGB (GL_EXT_texture_sRGB, GL_EXT_framebuffer_sRGB), between bytes and linear
// numbers.
#pragma once

#include <stdint.h>

namespace softgl {

/// A byte of an sRGB color. OSMesa takes a cubic in place of the power 2.4.
static inline float srgb_to_linear(float v) {
  const float scale = 255.0f, square = v * v;
  const float even = (0.6935f / (scale * scale)) * square + 0.0023f;
  const float odd = (0.3012f / (scale * scale * scale)) * square + 0.0030f / scale;
  return v <= 15.0f ? v * (1.0f / (12.6f * scale)) : odd * v + even;
}

/// 1 / sqrt(v) as the processors' approximation gives it that OSMesa takes (RSQRTPS of Intel's): of the
/// middle of one of 1024 ranges between two powers of two, to 13 bits. v is neither 0 nor denormal.
static inline float approximate_inverse_root(float v) {
  const auto bits = __builtin_bit_cast(uint32_t, v);
  const int32_t exponent = int32_t(bits >> 23) - 127;
  const uint32_t middle = (bits & 0x7fe000) | 0x1000 | uint32_t(127 + (exponent & 1)) << 23;
  const auto number = int32_t(8192.0 / __builtin_sqrt(double(__builtin_bit_cast(float, middle))) + 0.5);
  return float(number) * __builtin_bit_cast(float, uint32_t(127 - 13 - (exponent >> 1)) << 23);
}

/// The way back, not rounded yet: 0 to 255 for linear numbers of [0, 1]. The power 1/2.4 is a mean of those
/// of 3/8 and 1/2, as in OSMesa.
static inline float linear_to_srgb(float v) {
  if (v <= 0.0031308f) return v * (12.92f * 255.0f);
  const float root = v * approximate_inverse_root(v),
              power = approximate_inverse_root(approximate_inverse_root(root * v));
  return float(0.675f * 1.0622 * 255.0f) * power +
         (float(0.325f * 1.0622 * 255.0f) * root + -0.0620f * 255.0f);
}

} // namespace softgl
