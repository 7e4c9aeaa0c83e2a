// One lane's arithmetic, written so that GCC keeps a loop over lanes vectorised on every instruction set:
// choices are bit selects (a ternary with work behind it becomes control flow and costs 5-10x), floor needs
// no SSE4.1. Included inside no namespace; the functions land in the namespace of the instruction set.
#pragma once

#include <stdint.h>

namespace softgl {
namespace SOFTGL_ISA {

static inline __attribute__((always_inline)) int32_t float_bits(float f) {
  return __builtin_bit_cast(int32_t, f);
}
static inline __attribute__((always_inline)) float bits_float(int32_t i) {
  return __builtin_bit_cast(float, i);
}

/// All ones where the condition holds.
static inline __attribute__((always_inline)) int32_t mask_of(bool condition) { return -int32_t(condition); }
/// a where the mask is ones, b where it is zeros.
static inline __attribute__((always_inline)) float select(int32_t mask, float a, float b) {
  return bits_float((float_bits(a) & mask) | (float_bits(b) & ~mask));
}
static inline __attribute__((always_inline)) int32_t select(int32_t mask, int32_t a, int32_t b) {
  return (a & mask) | (b & ~mask);
}
/// a or +0.
static inline __attribute__((always_inline)) float keep(int32_t mask, float a) {
  return bits_float(float_bits(a) & mask);
}

static inline __attribute__((always_inline)) float absolute(float a) {
  return bits_float(float_bits(a) & 0x7fffffff);
}
/// The greater; b when a is not a number.
static inline __attribute__((always_inline)) float maximum(float a, float b) {
  return select(mask_of(a > b), a, b);
}
/// The smaller; b when a is not a number.
static inline __attribute__((always_inline)) float minimum(float a, float b) {
  return select(mask_of(a < b), a, b);
}
/// Clamp to [0,1]; not a number gives 0.
static inline __attribute__((always_inline)) float saturate(float a) {
  return minimum(maximum(a, 0.0f), 1.0f);
}
/// Floor; from 2^23 on all numbers are integers (and those beyond int32_t would be converted as the compiler
/// likes).
static inline __attribute__((always_inline)) float floor_of(float a) {
  const float t = float(int32_t(a));
  return select(mask_of(absolute(a) < 8388608.0f), t - keep(mask_of(t > a), 1.0f), a);
}
/// The nearest integer, of two the even one.
static inline __attribute__((always_inline)) float round_of(float a) {
  const float ulp_is_one = bits_float((float_bits(a) & int32_t(0x80000000u)) | 0x4b000000); // 2^23
  return select(mask_of(absolute(a) < 8388608.0f), (a + ulp_is_one) - ulp_is_one, a);
}
static inline __attribute__((always_inline)) float reciprocal_root(float a) {
  return 1.0f / __builtin_sqrtf(a);
}

} // namespace SOFTGL_ISA
} // namespace softgl
