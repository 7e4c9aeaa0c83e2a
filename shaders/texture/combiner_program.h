// What the texture environments of all units and the color sum make of a fragment's colors, as a list of
// operations: immutable, and without numbers that may change from draw to draw.
#pragma once

#include <stdint.h>

namespace softgl {

/// Values have numbers: four components of each unit's texel and environment color, of the primary and of
/// the secondary color; constants; registers.
constexpr int kCombinerTexel = 0, kCombinerEnvironment = 32, kCombinerPrimary = 64, kCombinerSecondary = 68;
constexpr int kCombinerConstant = 72, kCombinerConstants = 32;
constexpr int kCombinerRegister = kCombinerConstant + kCombinerConstants, kCombinerRegisters = 64;

enum class CombinerOperation : uint8_t { Copy, Negate, Saturate, Add, Subtract, Multiply };
struct CombinerStep {
  CombinerOperation operation;
  uint8_t result; // a register, and neither of the operands
  uint8_t a, b;   // values; the same where there is one operand
};

struct CombinerProgram {
  static constexpr int kMaxSteps = 352;
  int32_t step_count;
  uint8_t result[4]; // values that take the place of the primary color, of which they may be the same
                     // component only
  float constant[kCombinerConstants];
  CombinerStep step[kMaxSteps];
};

} // namespace softgl
