// Loops over the lanes of a block, and the few operations on lanes that need an instruction of their own.
#pragma once

#include <immintrin.h>

#include "shaders/common/lane_math.h"
#include "shaders/common/simd.h"
#include "shaders/fragment/fragment_block.h"

// Lanes come in strips of 16: a constant inner count lets GCC vectorise without a tail.
#define SOFTGL_FOR_LANES(block, i) \
  for (int32_t strip_ = 0, lanes_ = (block).lanes; strip_ < lanes_; strip_ += kStripLanes) \
    for (int32_t i = strip_; i < strip_ + kStripLanes; ++i)

namespace softgl {
namespace SOFTGL_ISA {

/// Round to nearest even; what does not fit an int32_t becomes INT32_MIN.
static inline void round_lanes(const FragmentBlock& block, const float* from, int32_t* to) {
  for (int32_t i = 0; i < block.lanes; i += 16) {
#if defined(__AVX512F__)
    _mm512_store_si512(to + i, _mm512_maskz_cvtps_epi32(0xffff, _mm512_load_ps(from + i)));
#elif defined(__AVX2__)
    for (int k = 0; k < 16; k += 8)
      _mm256_store_si256(reinterpret_cast<__m256i*>(to + i + k),
                         _mm256_cvtps_epi32(_mm256_load_ps(from + i + k)));
#else
    for (int k = 0; k < 16; k += 4)
      _mm_store_si128(reinterpret_cast<__m128i*>(to + i + k), _mm_cvtps_epi32(_mm_load_ps(from + i + k)));
#endif
  }
}

/// Floor as an integer; what does not fit an int32_t becomes INT32_MIN, whatever the compiler makes of
/// float(int32_t(a)).
static inline __attribute__((always_inline)) int32_t floor_to_int(float a) {
  const int32_t t = int32_t(a);
  return int32_t(uint32_t(t) + uint32_t(mask_of(float(t) > a) & mask_of(t != INT32_MIN)));
}
static inline __attribute__((always_inline)) int32_t clamp_int(int32_t a, int32_t low, int32_t high) {
  a = select(mask_of(a < high), a, high);
  return select(mask_of(a > low), a, low);
}

/// a + ((w * (b - a) + 128) >> 8) for each of four bytes per word; `weight` holds w in both halves of each
/// word. Modulo 65536 this needs 16 bits only, so every instruction set has it.
SOFTGL_INLINE IntV lerp_bytes(IntV weight, IntV a, IntV b) {
  const IntV odd = splat(int32_t(0xff00ff00u)), even = ~odd;
  const ShortV w = (ShortV)weight, half = ShortV{} + uint16_t(128);
  const ShortV even_step = w * ((ShortV)(b & even) - (ShortV)(a & even)),
               odd_step = w * (((ShortV)b >> 8) - ((ShortV)a >> 8));
  return (IntV)((((ShortV)a << 8) + even_step + half) >> 8) |
         ((IntV)((ShortV)(a & odd) + odd_step + half) & odd);
}

} // namespace SOFTGL_ISA
} // namespace softgl
