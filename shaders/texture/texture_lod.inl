// Level of detail (GL 1.5, 3.8.8), one value per lane; the lanes of a 2x2 quad carry equal differences, so
// they get equal levels (except in cube maps).
//
// OSMesa 22.3.6: rho squared = max of the squared lengths, scaled by the size of the base level. Without bias
// and limits, the nearest level is (exponent + 1) >> 1 and magnification is rho <= magnified_rho. Otherwise
// lod = 0.5 *
// ((exponent - 1) + mantissa), a piecewise linear logarithm, plus bias, clamped; nearest rounds it to even,
// magnification is lod <= magnified_lod.
#pragma once

#include "shaders/common/lane_math.h"
#include "shaders/fragment/fragment_block.h"
#include "shaders/texture/texture_constants.h"
#include "shaders/texture/texture_cube.inl"
#include "shaders/texture/texture_lanes.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Where to sample each lane: one or two levels, and which filter.
struct LaneLevels {
  int32_t level[kLanes];     // the first or only level
  float fraction[kLanes];    // of the second level, which is level + 1; 0 when there is none
  int32_t magnified[kLanes]; // mask
};

static inline void squared_rho(const FragmentBlock& block, const BlockCoordinates& c,
                               const TextureUnitConstants& t, float* rho) {
  const TextureLevel& base = t.level[0];
  const float w = t.counts_texels ? 1.0f : float(base.width), h = t.counts_texels ? 1.0f : float(base.height),
              d = float(base.depth);
  if (t.shape == TextureShape::ThreeD) {
    SOFTGL_FOR_LANES(block, i) {
      const float sx = c.ds_dx[i] * w, tx = c.dt_dx[i] * h, rx = c.dr_dx[i] * d;
      const float sy = c.ds_dy[i] * w, ty = c.dt_dy[i] * h, ry = c.dr_dy[i] * d;
      const float x = (sx * sx + tx * tx) + rx * rx, y = (sy * sy + ty * ty) + ry * ry;
      rho[i] = select(mask_of(x > y), x, y);
    }
  } else if (t.shape == TextureShape::OneD) {
    SOFTGL_FOR_LANES(block, i) {
      const float x = absolute(c.ds_dx[i]), y = absolute(c.ds_dy[i]);
      const float longest = select(mask_of(x > y), x, y) * w;
      rho[i] = longest;
    }
  } else {
    SOFTGL_FOR_LANES(block, i) {
      const float sx = c.ds_dx[i] * w, tx = c.dt_dx[i] * h;
      const float sy = c.ds_dy[i] * w, ty = c.dt_dy[i] * h;
      const float x = sx * sx + tx * tx, y = sy * sy + ty * ty;
      rho[i] = select(mask_of(x > y), x, y);
    }
    if (t.shape == TextureShape::Cube) // the division by the major axis may leave anything
      SOFTGL_FOR_LANES(block, i) rho[i] = keep(mask_of(rho[i] < __builtin_inff()), rho[i]);
  }
}

/// Half the logarithm to the base of 2; between powers of two it is linear (OSMesa 22.3.6).
static inline __attribute__((always_inline)) float half_log2(float v) {
  const int32_t bits = float_bits(v);
  const int32_t exponent = ((bits >> 23) & 255) - 128; // less one: the mantissa is in [1, 2)
  const float mantissa = bits_float((bits & 0x007fffff) | 0x3f800000);
  return (float(exponent) + mantissa) * 0.5f;
}

static inline void find_levels(const FragmentBlock& block, const BlockCoordinates& c,
                               const TextureUnitConstants& t, LaneLevels& out) {
  alignas(64) float rho[kLanes];
  squared_rho(block, c, t, rho);
  const int32_t last = t.last_level;
  const bool squared = t.shape != TextureShape::OneD;
  if (!t.adjusts_lod && !t.constant_lod && t.mip != TextureMip::Linear) {
    const float root2 = 1.41421356237309504880f, magnified_rho = t.magnified_rho;
    SOFTGL_FOR_LANES(block, i) {
      // One-dimensional textures: the exponent of rho * sqrt 2 rounds log2 rho.
      const int32_t bits = float_bits(squared ? rho[i] : rho[i] * root2);
      const int32_t exponent = ((bits >> 23) & 255) - 127;
      int32_t level = squared ? (exponent + 1) >> 1 : exponent;
      level = select(mask_of(level > last), last, level);
      out.level[i] = level & ~(level >> 31);
      out.fraction[i] = 0;
      out.magnified[i] = ~mask_of(rho[i] > magnified_rho);
    }
    return;
  }
  alignas(64) float lod[kLanes];
  const float magnified_lod = t.magnified_lod;
  if (t.constant_lod) {
    SOFTGL_FOR_LANES(block, i) lod[i] = t.min_lod;
  } else {
    const float bias = t.lod_bias;
    const float low = t.has_min_lod ? t.min_lod : -1e30f, high = t.has_max_lod ? t.max_lod : 1e30f;
    SOFTGL_FOR_LANES(block, i) {
      float l = half_log2(squared ? rho[i] : rho[i] * rho[i]) + bias;
      l = select(mask_of(l < high), l, high);
      lod[i] = select(mask_of(l > low), l, low);
    }
  }
  if (t.mip == TextureMip::Linear) {
    SOFTGL_FOR_LANES(block, i) {
      const float l = lod[i], whole = floor_of(l);
      int32_t level = int32_t(whole);
      const int32_t between = mask_of(level >= 0) & mask_of(level < last);
      level = select(mask_of(level > last), last, level);
      out.level[i] = level & ~(level >> 31);
      out.fraction[i] = keep(between, l - whole);
      out.magnified[i] = ~mask_of(l > magnified_lod);
    }
  } else {
    alignas(64) int32_t nearest[kLanes];
    round_lanes(block, lod, nearest);
    SOFTGL_FOR_LANES(block, i) {
      int32_t level = nearest[i];
      level = select(mask_of(level > last), last, level);
      out.level[i] = t.mip == TextureMip::Nearest ? level & ~(level >> 31) : 0;
      out.fraction[i] = 0;
      out.magnified[i] = ~mask_of(lod[i] > magnified_lod);
    }
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
