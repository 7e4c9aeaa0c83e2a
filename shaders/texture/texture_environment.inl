// Texture environments (GL 1.5, 3.8.13). MODULATE and REPLACE have kernels of their own for speed; all others
// are done by a program for the whole chain of units (texture/combiner_chain.cpp), because OSMesa 22.3.6
// orders additions over units.
#pragma once

#include "shaders/fragment/fragment_constants.h"
#include "shaders/texture/combiner_program.h"
#include "shaders/texture/texture_float.inl"

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

/// A value of a combiner program; one that is the same for all fragments is spread out in `wide`.
static inline const float* combiner_value(FragmentBlock& block, const FragmentConstants& constants,
                                          const float (*registers)[kLanes], int v, float* wide) {
  if (v >= kCombinerRegister) return registers[v - kCombinerRegister];
  if (v < kCombinerEnvironment) return UnitTexels(block, v / 4).v[v % 4];
  if (v >= kCombinerPrimary && v < kCombinerSecondary) return block.color[v - kCombinerPrimary];
  if (v >= kCombinerSecondary && v < kCombinerConstant) return block.secondary[v - kCombinerSecondary];
  const float number =
      v >= kCombinerConstant
          ? constants.combiner->constant[v - kCombinerConstant]
          : constants.texture[(v - kCombinerEnvironment) / 4]->color[(v - kCombinerEnvironment) % 4];
  SOFTGL_FOR_LANES(block, i) wide[i] = number;
  return wide;
}

/// All environments at once, where one of them is neither MODULATE nor REPLACE, and the color sum.
static inline void environment_combine(FragmentBlock& block, const FragmentConstants& constants, int) {
  const CombinerProgram& program = *constants.combiner;
  alignas(64) float registers[kCombinerRegisters][kLanes], wide[2][kLanes];
  for (int n = 0; n < program.step_count; ++n) {
    const CombinerStep step = program.step[n];
    const float* __restrict a = combiner_value(block, constants, registers, step.a, wide[0]);
    const float* __restrict b =
        step.b == step.a ? a : combiner_value(block, constants, registers, step.b, wide[1]);
    float* __restrict result = registers[step.result - kCombinerRegister];
    switch (step.operation) {
    case CombinerOperation::Copy: SOFTGL_FOR_LANES(block, i) result[i] = a[i]; break;
    case CombinerOperation::Negate: SOFTGL_FOR_LANES(block, i) result[i] = -a[i]; break;
    case CombinerOperation::Saturate: SOFTGL_FOR_LANES(block, i) result[i] = saturate(a[i]); break;
    case CombinerOperation::Add: SOFTGL_FOR_LANES(block, i) result[i] = a[i] + b[i]; break;
    case CombinerOperation::Subtract: SOFTGL_FOR_LANES(block, i) result[i] = a[i] - b[i]; break;
    case CombinerOperation::Multiply: SOFTGL_FOR_LANES(block, i) result[i] = a[i] * b[i]; break;
    }
  }
  for (int k = 0; k < 4; ++k) {
    float* color = block.color[k];
    const float* result = combiner_value(block, constants, registers, program.result[k], wide[0]);
    SOFTGL_FOR_LANES(block, i) color[i] = result[i];
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
