// Vectors of what pixels are made of: the bytes of words, pairs of words, and four floats each.
#pragma once

#include "shaders/common/simd.h"

namespace softgl {
namespace SOFTGL_ISA {

/// Roots; differences of bytes, at least 0, the smaller and the greater ones.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
SOFTGL_INLINE FloatV square_root(FloatV v) { return (FloatV)_mm512_sqrt_ps((__m512)v); }
SOFTGL_INLINE IntV subtract_bytes(IntV a, IntV b) { return (IntV)_mm512_subs_epu8((__m512i)a, (__m512i)b); }
SOFTGL_INLINE IntV min_bytes(IntV a, IntV b) { return (IntV)_mm512_min_epu8((__m512i)a, (__m512i)b); }
SOFTGL_INLINE IntV max_bytes(IntV a, IntV b) { return (IntV)_mm512_max_epu8((__m512i)a, (__m512i)b); }
#elif defined(__AVX2__)
SOFTGL_INLINE FloatV square_root(FloatV v) { return (FloatV)_mm256_sqrt_ps((__m256)v); }
SOFTGL_INLINE IntV subtract_bytes(IntV a, IntV b) { return (IntV)_mm256_subs_epu8((__m256i)a, (__m256i)b); }
SOFTGL_INLINE IntV min_bytes(IntV a, IntV b) { return (IntV)_mm256_min_epu8((__m256i)a, (__m256i)b); }
SOFTGL_INLINE IntV max_bytes(IntV a, IntV b) { return (IntV)_mm256_max_epu8((__m256i)a, (__m256i)b); }
#else
SOFTGL_INLINE FloatV square_root(FloatV v) { return (FloatV)_mm_sqrt_ps((__m128)v); }
SOFTGL_INLINE IntV subtract_bytes(IntV a, IntV b) { return (IntV)_mm_subs_epu8((__m128i)a, (__m128i)b); }
SOFTGL_INLINE IntV min_bytes(IntV a, IntV b) { return (IntV)_mm_min_epu8((__m128i)a, (__m128i)b); }
SOFTGL_INLINE IntV max_bytes(IntV a, IntV b) { return (IntV)_mm_max_epu8((__m128i)a, (__m128i)b); }
#endif

/// kWidth pixels of four floats each, side by side: component c of pixel i goes to lane i of out[c].
SOFTGL_INLINE void load_pixels(const float* p, FloatV out[4]) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  const __m512 p0 = _mm512_loadu_ps(p), p4 = _mm512_loadu_ps(p + 16), p8 = _mm512_loadu_ps(p + 32),
               p12 = _mm512_loadu_ps(p + 48);
  const __m512 t0 = _mm512_shuffle_f32x4(p0, p4, 0x44), t1 = _mm512_shuffle_f32x4(p0, p4, 0xee),
               t2 = _mm512_shuffle_f32x4(p8, p12, 0x44), t3 = _mm512_shuffle_f32x4(p8, p12, 0xee);
  // Pixels 0 4 8 12, 1 5 9 13, ...
  const __m512 r0 = _mm512_shuffle_f32x4(t0, t2, 0x88), r1 = _mm512_shuffle_f32x4(t0, t2, 0xdd),
               r2 = _mm512_shuffle_f32x4(t1, t3, 0x88), r3 = _mm512_shuffle_f32x4(t1, t3, 0xdd);
  const __m512 a = _mm512_unpacklo_ps(r0, r1), b = _mm512_unpackhi_ps(r0, r1), c = _mm512_unpacklo_ps(r2, r3),
               d = _mm512_unpackhi_ps(r2, r3);
  out[0] = (FloatV)_mm512_shuffle_ps(a, c, 0x44), out[1] = (FloatV)_mm512_shuffle_ps(a, c, 0xee);
  out[2] = (FloatV)_mm512_shuffle_ps(b, d, 0x44), out[3] = (FloatV)_mm512_shuffle_ps(b, d, 0xee);
#else
  load_transposed(
      [&](int i) __attribute__((always_inline)) { return p + 4 * i; }, out);
#endif
}
/// The way back.
SOFTGL_INLINE void store_pixels(float* p, const FloatV v[4]) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  const __m512 a = _mm512_unpacklo_ps((__m512)v[0], (__m512)v[1]),
               b = _mm512_unpackhi_ps((__m512)v[0], (__m512)v[1]),
               c = _mm512_unpacklo_ps((__m512)v[2], (__m512)v[3]),
               d = _mm512_unpackhi_ps((__m512)v[2], (__m512)v[3]);
  const __m512 r0 = _mm512_shuffle_ps(a, c, 0x44), r1 = _mm512_shuffle_ps(a, c, 0xee),
               r2 = _mm512_shuffle_ps(b, d, 0x44), r3 = _mm512_shuffle_ps(b, d, 0xee);
  const __m512 t0 = _mm512_shuffle_f32x4(r0, r1, 0x44), t1 = _mm512_shuffle_f32x4(r0, r1, 0xee),
               t2 = _mm512_shuffle_f32x4(r2, r3, 0x44), t3 = _mm512_shuffle_f32x4(r2, r3, 0xee);
  _mm512_storeu_ps(p, _mm512_shuffle_f32x4(t0, t2, 0x88));
  _mm512_storeu_ps(p + 16, _mm512_shuffle_f32x4(t0, t2, 0xdd));
  _mm512_storeu_ps(p + 32, _mm512_shuffle_f32x4(t1, t3, 0x88));
  _mm512_storeu_ps(p + 48, _mm512_shuffle_f32x4(t1, t3, 0xdd));
#elif defined(__AVX2__)
  const __m256 a = _mm256_unpacklo_ps((__m256)v[0], (__m256)v[1]),
               b = _mm256_unpackhi_ps((__m256)v[0], (__m256)v[1]),
               c = _mm256_unpacklo_ps((__m256)v[2], (__m256)v[3]),
               d = _mm256_unpackhi_ps((__m256)v[2], (__m256)v[3]);
  const __m256 r0 = _mm256_shuffle_ps(a, c, 0x44), r1 = _mm256_shuffle_ps(a, c, 0xee),
               r2 = _mm256_shuffle_ps(b, d, 0x44), r3 = _mm256_shuffle_ps(b, d, 0xee);
  _mm256_storeu_ps(p, _mm256_permute2f128_ps(r0, r1, 0x20));
  _mm256_storeu_ps(p + 8, _mm256_permute2f128_ps(r2, r3, 0x20));
  _mm256_storeu_ps(p + 16, _mm256_permute2f128_ps(r0, r1, 0x31));
  _mm256_storeu_ps(p + 24, _mm256_permute2f128_ps(r2, r3, 0x31));
#else
  __m128 a = (__m128)v[0], b = (__m128)v[1], c = (__m128)v[2], d = (__m128)v[3];
  _MM_TRANSPOSE4_PS(a, b, c, d);
  _mm_storeu_ps(p, a), _mm_storeu_ps(p + 4, b), _mm_storeu_ps(p + 8, c), _mm_storeu_ps(p + 12, d);
#endif
}

/// 2 kWidth words: those of even index, and those of odd.
SOFTGL_INLINE void load_alternating(const uint32_t* p, IntV& even, IntV& odd) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  const __m512i a = _mm512_loadu_si512(p), b = _mm512_loadu_si512(p + 16);
  const __m512i index = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
  even = (IntV)_mm512_permutex2var_epi32(a, index, b);
  odd = (IntV)_mm512_permutex2var_epi32(a, _mm512_or_si512(index, _mm512_set1_epi32(1)), b);
#elif defined(__AVX2__)
  const __m256 a = (__m256)load(p), b = (__m256)load(p + 8);
  even = (IntV)_mm256_permute4x64_epi64((__m256i)_mm256_shuffle_ps(a, b, 0x88), 0xd8);
  odd = (IntV)_mm256_permute4x64_epi64((__m256i)_mm256_shuffle_ps(a, b, 0xdd), 0xd8);
#else
  const __m128 a = (__m128)load(p), b = (__m128)load(p + 4);
  even = (IntV)_mm_shuffle_ps(a, b, 0x88), odd = (IntV)_mm_shuffle_ps(a, b, 0xdd);
#endif
}
/// The way back.
SOFTGL_INLINE void store_alternating(uint32_t* p, IntV even, IntV odd) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  const __m512i index = _mm512_setr_epi32(0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
  const __m512i a = (__m512i)even, b = (__m512i)odd;
  _mm512_storeu_si512(p, _mm512_permutex2var_epi32(a, index, b));
  _mm512_storeu_si512(p + 16, _mm512_permutex2var_epi32(a, _mm512_or_si512(index, _mm512_set1_epi32(8)), b));
#elif defined(__AVX2__)
  const __m256i low = _mm256_unpacklo_epi32((__m256i)even, (__m256i)odd),
                high = _mm256_unpackhi_epi32((__m256i)even, (__m256i)odd);
  store(p, (IntV)_mm256_permute2x128_si256(low, high, 0x20));
  store(p + 8, (IntV)_mm256_permute2x128_si256(low, high, 0x31));
#else
  store(p, (IntV)_mm_unpacklo_epi32((__m128i)even, (__m128i)odd));
  store(p + 4, (IntV)_mm_unpackhi_epi32((__m128i)even, (__m128i)odd));
#endif
}

} // namespace SOFTGL_ISA
} // namespace softgl
