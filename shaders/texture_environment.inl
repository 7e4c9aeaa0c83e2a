// Texture environments (GL 1.5, 3.8.13) as combiners, the expressions in the order of OSMesa 22.3.6. REPLACE, MODULATE,
// DECAL, BLEND and ADD are combiners too (texture/texture_environment.cpp chooses the arguments); MODULATE and REPLACE
// have kernels of their own for speed, with the same arithmetic.
#pragma once

#include "fragment_constants.h"
#include "texture_float.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Where sampling leaves the texel of a unit: the unit's coordinates are no longer needed.
struct UnitTexels {
  float* v[4];
  explicit UnitTexels(FragmentBlock& block, int unit)
      : v{block.unit[unit].s, block.unit[unit].t, block.unit[unit].r, block.unit[unit].ds_dx} {}
};

static inline void environment_modulate(FragmentBlock& block, const FragmentConstants&, int unit) {
  const UnitTexels texel(block, unit);
  for (int k = 0; k < 4; ++k) {
    float* color = block.color[k];
    const float* v = texel.v[k];
    SOFTGL_FOR_LANES(block, i) color[i] = v[i] * color[i];
  }
}

static inline void environment_replace(FragmentBlock& block, const FragmentConstants&, int unit) {
  const UnitTexels texel(block, unit);
  for (int k = 0; k < 4; ++k) {
    float* color = block.color[k];
    const float* v = texel.v[k];
    SOFTGL_FOR_LANES(block, i) color[i] = v[i];
  }
}

/// Component k of an argument.
static inline void combine_argument(FragmentBlock& block, const TextureUnitConstants& t, const CombineArgument& a, int k, float* out) {
  if (a.alpha) k = 3;
  if (a.source == CombineSource::Constant || a.source == CombineSource::Zero) {
    const float c = a.source == CombineSource::Zero ? 0.0f : t.color[k];
    const float v = a.complement ? 1.0f - c : c;
    SOFTGL_FOR_LANES(block, i) out[i] = v;
    return;
  }
  const float* from = a.source == CombineSource::Previous  ? block.color[k]
                      : a.source == CombineSource::Primary ? block.primary[k]
                                                           : UnitTexels(block, int(a.source)).v[k];
  if (a.complement) {
    SOFTGL_FOR_LANES(block, i) out[i] = 1.0f - from[i];
  } else {
    SOFTGL_FOR_LANES(block, i) out[i] = from[i];
  }
}

static inline bool function_saturates(CombineFunction f) {
  return f == CombineFunction::Add || f == CombineFunction::AddSigned || f == CombineFunction::Subtract || f >= CombineFunction::Dot3Rgb;
}

/// One component of the result before scaling. `part` is 0 for rgb, 1 for alpha.
static inline void combine_component(FragmentBlock& block, const TextureUnitConstants& t, int part, int k, float* out) {
  alignas(64) float a[kLanes], b[kLanes], c[kLanes];
  const CombineArgument* argument = t.argument[part];
  combine_argument(block, t, argument[0], k, a);
  const CombineFunction function = t.function[part];
  if (function != CombineFunction::Replace) combine_argument(block, t, argument[1], k, b);
  switch (function) {
  case CombineFunction::Replace: SOFTGL_FOR_LANES(block, i) out[i] = a[i]; break;
  case CombineFunction::Modulate: SOFTGL_FOR_LANES(block, i) out[i] = a[i] * b[i]; break;
  case CombineFunction::Add: SOFTGL_FOR_LANES(block, i) out[i] = a[i] + b[i]; break;
  case CombineFunction::AddSigned: SOFTGL_FOR_LANES(block, i) out[i] = (a[i] + b[i]) + -0.5f; break;
  case CombineFunction::Subtract: SOFTGL_FOR_LANES(block, i) out[i] = a[i] - b[i]; break;
  case CombineFunction::Interpolate:
    combine_argument(block, t, argument[2], k, c);
    SOFTGL_FOR_LANES(block, i) out[i] = a[i] * c[i] + b[i] * (1.0f - c[i]);
    break;
  default: break; // the dot products are made of three components at once
  }
}

static inline void combine_dot3(FragmentBlock& block, const TextureUnitConstants& t, float* out) {
  alignas(64) float product[3][kLanes];
  for (int k = 0; k < 3; ++k) {
    alignas(64) float a[kLanes], b[kLanes];
    combine_argument(block, t, t.argument[0][0], k, a);
    combine_argument(block, t, t.argument[0][1], k, b);
    SOFTGL_FOR_LANES(block, i) product[k][i] = (a[i] * 2.0f + -1.0f) * (b[i] * 2.0f + -1.0f);
  }
  SOFTGL_FOR_LANES(block, i) out[i] = (product[2][i] + product[1][i]) + product[0][i];
}

static inline void environment_combine(FragmentBlock& block, const FragmentConstants& constants, int unit) {
  const TextureUnitConstants& t = *constants.texture[unit];
  alignas(64) float result[4][kLanes];
  const bool dot = t.function[0] >= CombineFunction::Dot3Rgb, dot_alpha = t.function[0] == CombineFunction::Dot3Rgba;
  if (dot) {
    combine_dot3(block, t, result[0]);
    for (int k = 1; k < 3; ++k) SOFTGL_FOR_LANES(block, i) result[k][i] = result[0][i];
  } else {
    for (int k = 0; k < 3; ++k) combine_component(block, t, 0, k, result[k]);
  }
  if (dot_alpha) {
    SOFTGL_FOR_LANES(block, i) result[3][i] = result[0][i];
  } else {
    combine_component(block, t, 1, 3, result[3]);
  }
  for (int k = 0; k < 4; ++k) {
    const int part = k == 3;
    const float scale = t.combine_scale[part];
    const bool saturates = scale != 1.0f || function_saturates(k == 3 && !dot_alpha ? t.function[1] : t.function[0]);
    float* color = block.color[k];
    const float* r = result[k];
    if (saturates) {
      SOFTGL_FOR_LANES(block, i) color[i] = saturate(r[i] * scale);
    } else {
      SOFTGL_FOR_LANES(block, i) color[i] = r[i];
    }
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
