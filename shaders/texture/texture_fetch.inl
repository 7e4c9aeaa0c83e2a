// Texels as floats.
#pragma once

#include "shaders/common/lane_math.h"
#include "shaders/common/srgb.h"
#include "shaders/fragment/fragment_block.h"
#include "shaders/texture/texture_constants.h"

namespace softgl {
namespace SOFTGL_ISA {

/// Two texel numbers and the weight of the second. Numbers outside the image mean the border.
struct FloatAxis {
  alignas(64) int32_t first[kLanes], second[kLanes];
  alignas(64) float weight[kLanes];
};

struct FloatTexels {
  alignas(64) float v[4][kLanes];
};

/// The word of a depth.
static inline __attribute__((always_inline)) uint32_t depth_word(const TextureLevel& level, int face,
                                                                 size_t index) {
  typedef uint32_t AliasedDepth __attribute__((may_alias));
  return reinterpret_cast<const AliasedDepth*>(level.face[face])[index];
}
/// 32 bits do not fit a float: OSMesa keeps the upper 23.
static inline __attribute__((always_inline)) float wide_depth(uint32_t v) {
  return (bits_float(int32_t((v >> 9) | 0x3f800000u)) - 1.0f) * 1.00000011920930376163766f;
}

/// One texel as floats; the border outside.
static inline void fetch_float(const TextureUnitConstants& t, const TextureLevel& level, int face, int32_t x,
                               int32_t y, int32_t z, float* rgba) {
  if (x < 0 || x >= level.width || y < 0 || y >= level.height || z < 0 || z >= level.depth) {
    for (int k = 0; k < 4; ++k) rgba[k] = t.border[k];
    return;
  }
  const size_t index = size_t(z) * size_t(level.slice) + size_t(y) * size_t(level.row) + size_t(x);
  if (t.texel == TextureTexel::Rgba8) {
    const unsigned char* p = level.face[face] + index * 4;
    for (int k = 0; k < 4; ++k) rgba[k] = float(int32_t(p[k] >> t.shift[k])) * t.scale[k];
  } else if (t.texel == TextureTexel::Rgba16) {
    typedef uint16_t AliasedHalf __attribute__((may_alias));
    const AliasedHalf* p = reinterpret_cast<const AliasedHalf*>(level.face[face] + index * 8);
    for (int k = 0; k < 4; ++k) rgba[k] = float(int32_t(p[k])) * t.scale[k];
  } else if (t.texel == TextureTexel::Float) {
    typedef float AliasedFloat __attribute__((may_alias));
    const AliasedFloat* p = reinterpret_cast<const AliasedFloat*>(level.face[face] + index * 16);
    for (int k = 0; k < 4; ++k) rgba[k] = p[k];
  } else if (t.texel == TextureTexel::Srgb8) {
    const unsigned char* p = level.face[face] + index * 4;
    for (int k = 0; k < 3; ++k) rgba[k] = srgb_to_linear(float(int32_t(p[k])));
    rgba[3] = float(int32_t(p[3])) * t.scale[3];
  } else if (t.texel == TextureTexel::Signed16) {
    typedef int16_t AliasedShort __attribute__((may_alias));
    const AliasedShort* p = reinterpret_cast<const AliasedShort*>(level.face[face] + index * 8);
    for (int k = 0; k < 4; ++k) {
      const float v = float(int32_t(p[k])) * t.scale[k];
      rgba[k] = v > -1.0f ? v : -1.0f;
    }
  } else {
    const uint32_t v = depth_word(level, face, index);
    const float d = t.texel == TextureTexel::DepthFloat ? bits_float(int32_t(v))
                    : t.shift[0] == 32                  ? wide_depth(v)
                                                        : float(int32_t(v)) * t.scale[0];
    rgba[0] = rgba[1] = rgba[2] = d;
    rgba[3] = 1;
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
