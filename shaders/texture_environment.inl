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

static inline bool same_argument(const CombineArgument& a, const CombineArgument& b) {
  return a.source == b.source && a.alpha == b.alpha && a.complement == b.complement;
}
static inline bool complements(const CombineArgument& a, const CombineArgument& b) {
  return a.source == b.source && a.alpha == b.alpha && a.complement != b.complement;
}

/// a * c + b * (1 - c), in the form that OSMesa's compiler leaves: common factors are taken out, 1 - (1 - c) is c.
static inline void interpolate(FragmentBlock& block, const TextureUnitConstants& t, const CombineArgument* argument, int k, const float* a,
                               const float* b, float* out) {
  alignas(64) float c[kLanes], rest[kLanes];
  CombineArgument opposite = argument[2];
  opposite.complement = !opposite.complement;
  combine_argument(block, t, argument[2], k, c);
  if (argument[2].complement) combine_argument(block, t, opposite, k, rest);
  else SOFTGL_FOR_LANES(block, i) rest[i] = 1.0f - c[i];
  if (same_argument(argument[0], argument[1])) {
    SOFTGL_FOR_LANES(block, i) out[i] = a[i];
  } else if (same_argument(argument[1], argument[2])) {
    SOFTGL_FOR_LANES(block, i) out[i] = c[i] * (a[i] + rest[i]);
  } else if (complements(argument[0], argument[2])) {
    SOFTGL_FOR_LANES(block, i) out[i] = rest[i] * (c[i] + b[i]);
  } else {
    SOFTGL_FOR_LANES(block, i) out[i] = a[i] * c[i] + b[i] * rest[i];
  }
}

/// One component of the result before scaling. `part` is 0 for rgb, 1 for alpha.
static inline void combine_component(FragmentBlock& block, const TextureUnitConstants& t, int part, int k, float* out) {
  alignas(64) float a[kLanes], b[kLanes];
  const CombineArgument* argument = t.argument[part];
  combine_argument(block, t, argument[0], k, a);
  const CombineFunction function = t.function[part];
  if (function != CombineFunction::Replace) combine_argument(block, t, argument[1], k, b);
  switch (function) {
  case CombineFunction::Replace: SOFTGL_FOR_LANES(block, i) out[i] = a[i]; break;
  case CombineFunction::Modulate: SOFTGL_FOR_LANES(block, i) out[i] = a[i] * b[i]; break;
  case CombineFunction::Add: SOFTGL_FOR_LANES(block, i) out[i] = a[i] + b[i]; break;
  case CombineFunction::AddSigned: // the constant goes to the first argument; (1 - x) - 0.5 becomes 0.5 - x
    if (argument[0].complement) {
      CombineArgument plain = argument[0];
      plain.complement = 0;
      combine_argument(block, t, plain, k, a);
      SOFTGL_FOR_LANES(block, i) out[i] = (0.5f - a[i]) + b[i];
    } else {
      SOFTGL_FOR_LANES(block, i) out[i] = (a[i] + -0.5f) + b[i];
    }
    break;
  case CombineFunction::Subtract: SOFTGL_FOR_LANES(block, i) out[i] = a[i] - b[i]; break;
  case CombineFunction::Interpolate: interpolate(block, t, argument, k, a, b, out); break;
  default: break; // the dot products are made of three components at once
  }
}

/// The sum of products runs from blue to red; an argument that is one alpha for all components is a common factor.
static inline void combine_dot3(FragmentBlock& block, const TextureUnitConstants& t, float* out) {
  alignas(64) float a[3][kLanes], b[3][kLanes];
  for (int k = 0; k < 3; ++k) {
    combine_argument(block, t, t.argument[0][0], k, a[k]);
    combine_argument(block, t, t.argument[0][1], k, b[k]);
    SOFTGL_FOR_LANES(block, i) {
      a[k][i] = a[k][i] * 2.0f + -1.0f;
      b[k][i] = b[k][i] * 2.0f + -1.0f;
    }
  }
  if (t.argument[0][0].alpha) {
    SOFTGL_FOR_LANES(block, i) out[i] = a[0][i] * (b[0][i] + (b[1][i] + b[2][i]));
  } else if (t.argument[0][1].alpha) {
    SOFTGL_FOR_LANES(block, i) out[i] = b[0][i] * (a[0][i] + (a[1][i] + a[2][i]));
  } else {
    SOFTGL_FOR_LANES(block, i) out[i] = a[0][i] * b[0][i] + (a[1][i] * b[1][i] + a[2][i] * b[2][i]);
  }
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
