// The transfer function of sRGB (GL_EXT_texture_sRGB, GL_EXT_framebuffer_sRGB), between bytes and linear
// numbers.
#pragma once

namespace softgl {

/// A byte of an sRGB color. OSMesa takes a cubic in place of the power 2.4.
static inline float srgb_to_linear(float v) {
  const float scale = 255.0f, square = v * v;
  const float even = (0.6935f / (scale * scale)) * square + 0.0023f;
  const float odd = (0.3012f / (scale * scale * scale)) * square + 0.0030f / scale;
  return v <= 15.0f ? v * (1.0f / (12.6f * scale)) : odd * v + even;
}

/// The way back, not rounded yet: 0 to 255 for linear numbers of [0, 1]. The power 1/2.4 is a mean of those
/// of 3/8 and 1/2, as in OSMesa, which takes the processor's approximate roots.
static inline float linear_to_srgb(float v) {
  const float linear = v * (12.92f * 255.0f);
  const float root = __builtin_sqrtf(v), power = __builtin_sqrtf(__builtin_sqrtf(root * v));
  const float curve =
      (0.675f * 1.0622f * 255.0f) * power + ((0.325f * 1.0622f * 255.0f) * root - 0.0620f * 255.0f);
  return v <= 0.0031308f ? linear : curve;
}

} // namespace softgl
