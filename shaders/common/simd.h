// Vectors of the instruction set's natural width, for the few kernels that plain loops do not serve: set-up,
// coverage, interpolation. GCC's vector extension does the arithmetic; intrinsics only what it cannot say.
#pragma once

#if defined(__GNUC__) && !defined(__clang__) && defined(__AVX512F__)
// GCC 12's own header starts from undefined registers (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define SOFTGL_INLINE static inline __attribute__((always_inline))
#define SOFTGL_MEMBER inline __attribute__((always_inline))

namespace softgl {
namespace SOFTGL_ISA {

#if defined(__AVX512F__) && defined(__AVX512DQ__)
constexpr int kWidth = 16;
#elif defined(__AVX2__)
constexpr int kWidth = 8;
#else
constexpr int kWidth = 4;
#endif

typedef float FloatV __attribute__((vector_size(4 * kWidth), may_alias));
typedef int32_t IntV __attribute__((vector_size(4 * kWidth), may_alias));
typedef uint32_t UintV __attribute__((vector_size(4 * kWidth), may_alias));
typedef uint16_t ShortV
    __attribute__((vector_size(4 * kWidth), may_alias)); // two 16-bit halves for each lane

SOFTGL_INLINE FloatV load(const float* p) {
  FloatV v;
  memcpy(&v, p, sizeof v);
  return v;
}
SOFTGL_INLINE IntV load(const int32_t* p) {
  IntV v;
  memcpy(&v, p, sizeof v);
  return v;
}
SOFTGL_INLINE IntV load(const uint32_t* p) {
  IntV v;
  memcpy(&v, p, sizeof v);
  return v;
}
SOFTGL_INLINE void store(float* p, FloatV v) { memcpy(p, &v, sizeof v); }
SOFTGL_INLINE void store(int32_t* p, IntV v) { memcpy(p, &v, sizeof v); }
SOFTGL_INLINE void store(uint32_t* p, IntV v) { memcpy(p, &v, sizeof v); }
// x - 0 is x, for all x, so nothing is left of it but the broadcast; 0 + x would be 0 for -0, and an
// addition.
SOFTGL_INLINE FloatV splat(float x) { return x - FloatV{}; }
SOFTGL_INLINE IntV splat(int32_t x) { return x - IntV{}; }
SOFTGL_INLINE FloatV to_float(IntV v) { return __builtin_convertvector(v, FloatV); }
SOFTGL_INLINE IntV truncate(FloatV v) { return __builtin_convertvector(v, IntV); }

#if defined(__AVX512F__) && defined(__AVX512DQ__)
SOFTGL_INLINE IntV round_to_int(FloatV v) { return (IntV)_mm512_cvtps_epi32((__m512)v); }
SOFTGL_INLINE FloatV max_(FloatV a, FloatV b) { return (FloatV)_mm512_max_ps((__m512)a, (__m512)b); }
SOFTGL_INLINE FloatV min_(FloatV a, FloatV b) { return (FloatV)_mm512_min_ps((__m512)a, (__m512)b); }
SOFTGL_INLINE uint32_t sign_bits(IntV v) { return _mm512_movepi32_mask((__m512i)v); }
SOFTGL_INLINE IntV min_(IntV a, IntV b) { return (IntV)_mm512_min_epi32((__m512i)a, (__m512i)b); }
SOFTGL_INLINE IntV max_(IntV a, IntV b) { return (IntV)_mm512_max_epi32((__m512i)a, (__m512i)b); }
SOFTGL_INLINE IntV multiply(IntV a, IntV b) { return (IntV)_mm512_mullo_epi32((__m512i)a, (__m512i)b); }
#elif defined(__AVX2__)
SOFTGL_INLINE IntV round_to_int(FloatV v) { return (IntV)_mm256_cvtps_epi32((__m256)v); }
/// The second argument where the first is not a number.
SOFTGL_INLINE FloatV max_(FloatV a, FloatV b) { return (FloatV)_mm256_max_ps((__m256)a, (__m256)b); }
SOFTGL_INLINE FloatV min_(FloatV a, FloatV b) { return (FloatV)_mm256_min_ps((__m256)a, (__m256)b); }
SOFTGL_INLINE uint32_t sign_bits(IntV v) { return uint32_t(_mm256_movemask_ps((__m256)v)); }
SOFTGL_INLINE IntV min_(IntV a, IntV b) { return (IntV)_mm256_min_epi32((__m256i)a, (__m256i)b); }
SOFTGL_INLINE IntV max_(IntV a, IntV b) { return (IntV)_mm256_max_epi32((__m256i)a, (__m256i)b); }
SOFTGL_INLINE IntV multiply(IntV a, IntV b) { return (IntV)_mm256_mullo_epi32((__m256i)a, (__m256i)b); }
#else
SOFTGL_INLINE IntV round_to_int(FloatV v) { return (IntV)_mm_cvtps_epi32((__m128)v); }
SOFTGL_INLINE FloatV max_(FloatV a, FloatV b) { return (FloatV)_mm_max_ps((__m128)a, (__m128)b); }
SOFTGL_INLINE FloatV min_(FloatV a, FloatV b) { return (FloatV)_mm_min_ps((__m128)a, (__m128)b); }
SOFTGL_INLINE uint32_t sign_bits(IntV v) { return uint32_t(_mm_movemask_ps((__m128)v)); }
SOFTGL_INLINE IntV min_(IntV a, IntV b) {
  const IntV m = a < b;
  return (a & m) | (b & ~m);
}
SOFTGL_INLINE IntV max_(IntV a, IntV b) {
  const IntV m = a > b;
  return (a & m) | (b & ~m);
}
SOFTGL_INLINE IntV multiply(IntV a, IntV b) { return (IntV)((UintV)a * (UintV)b); }
#endif

/// Sums of bytes, at most 255.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
SOFTGL_INLINE IntV add_bytes(IntV a, IntV b) { return (IntV)_mm512_adds_epu8((__m512i)a, (__m512i)b); }
#elif defined(__AVX2__)
SOFTGL_INLINE IntV add_bytes(IntV a, IntV b) { return (IntV)_mm256_adds_epu8((__m256i)a, (__m256i)b); }
#else
SOFTGL_INLINE IntV add_bytes(IntV a, IntV b) { return (IntV)_mm_adds_epu8((__m128i)a, (__m128i)b); }
#endif

/// The floor of numbers up to 2^22 that are at least 2^-16 off every integer.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
SOFTGL_INLINE IntV floor_off_integers(FloatV v) {
  return (IntV)_mm512_cvt_roundps_epi32((__m512)v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}
#else
SOFTGL_INLINE IntV floor_off_integers(FloatV v) { return round_to_int(v - 0.5f); }
#endif

SOFTGL_INLINE IntV choose(IntV mask, IntV a, IntV b) { return (a & mask) | (b & ~mask); }
SOFTGL_INLINE FloatV choose(IntV mask, FloatV a, FloatV b) {
  return (FloatV)(((IntV)a & mask) | ((IntV)b & ~mask));
}
/// True when a bit of any lane is set.
SOFTGL_INLINE bool any(IntV v) { return sign_bits(v != IntV{}) != 0; }
/// Into [0,1]; not a number becomes 0.
SOFTGL_INLINE FloatV unit_range(FloatV v) { return min_(max_(v, FloatV{}), splat(1.0f)); }

/// One bit per lane -> one mask per lane, from bit 0 of `bits` on.
SOFTGL_INLINE IntV mask_of_bits(uint32_t bits) {
  IntV bit;
  for (int i = 0; i < kWidth; ++i) bit[i] = int32_t(1u << i);
  return (splat(int32_t(bits)) & bit) == bit;
}

/// Four floats from each of kWidth places, transposed: component c of place(i) goes to lane i of out[c].
template <class Place> SOFTGL_INLINE void load_transposed(Place place, FloatV out[4]) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  __m512 r[4];
  for (int i = 0; i < 4; ++i) {
    __m512 v = _mm512_castps128_ps512(_mm_loadu_ps(place(i)));
    v = _mm512_insertf32x4(v, _mm_loadu_ps(place(i + 4)), 1);
    v = _mm512_insertf32x4(v, _mm_loadu_ps(place(i + 8)), 2);
    r[i] = _mm512_insertf32x4(v, _mm_loadu_ps(place(i + 12)), 3);
  }
  const __m512 a = _mm512_unpacklo_ps(r[0], r[1]), b = _mm512_unpackhi_ps(r[0], r[1]);
  const __m512 c = _mm512_unpacklo_ps(r[2], r[3]), d = _mm512_unpackhi_ps(r[2], r[3]);
  out[0] = (FloatV)_mm512_shuffle_ps(a, c, 0x44);
  out[1] = (FloatV)_mm512_shuffle_ps(a, c, 0xee);
  out[2] = (FloatV)_mm512_shuffle_ps(b, d, 0x44);
  out[3] = (FloatV)_mm512_shuffle_ps(b, d, 0xee);
#elif defined(__AVX2__)
  __m256 r[4];
  for (int i = 0; i < 4; ++i)
    r[i] =
        _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(place(i))), _mm_loadu_ps(place(i + 4)), 1);
  const __m256 a = _mm256_unpacklo_ps(r[0], r[1]), b = _mm256_unpackhi_ps(r[0], r[1]);
  const __m256 c = _mm256_unpacklo_ps(r[2], r[3]), d = _mm256_unpackhi_ps(r[2], r[3]);
  out[0] = (FloatV)_mm256_shuffle_ps(a, c, 0x44);
  out[1] = (FloatV)_mm256_shuffle_ps(a, c, 0xee);
  out[2] = (FloatV)_mm256_shuffle_ps(b, d, 0x44);
  out[3] = (FloatV)_mm256_shuffle_ps(b, d, 0xee);
#else
  __m128 a = _mm_loadu_ps(place(0)), b = _mm_loadu_ps(place(1)), c = _mm_loadu_ps(place(2)),
         d = _mm_loadu_ps(place(3));
  _MM_TRANSPOSE4_PS(a, b, c, d);
  out[0] = (FloatV)a, out[1] = (FloatV)b, out[2] = (FloatV)c, out[3] = (FloatV)d;
#endif
}

/// The words at place(i) and behind it, for lane i.
template <class Place> SOFTGL_INLINE void load_pairs(Place place, IntV& first, IntV& second) {
  auto pairs = [&](int i) __attribute__((always_inline)) {
    const __m128 low = _mm_castsi128_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(place(i))));
    return _mm_loadh_pi(low, reinterpret_cast<const __m64*>(place(i + 1)));
  };
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  auto eight = [&](int i) __attribute__((always_inline)) {
    __m512 v = _mm512_castps128_ps512(pairs(i));
    v = _mm512_insertf32x4(v, pairs(i + 4), 1);
    v = _mm512_insertf32x4(v, pairs(i + 8), 2);
    return _mm512_insertf32x4(v, pairs(i + 12), 3);
  };
  const __m512 a = eight(0), b = eight(2);
  first = (IntV)_mm512_shuffle_ps(a, b, 0x88), second = (IntV)_mm512_shuffle_ps(a, b, 0xdd);
#elif defined(__AVX2__)
  auto four = [&](int i) __attribute__((always_inline)) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(pairs(i)), pairs(i + 4), 1);
  };
  const __m256 a = four(0), b = four(2);
  first = (IntV)_mm256_shuffle_ps(a, b, 0x88), second = (IntV)_mm256_shuffle_ps(a, b, 0xdd);
#else
  const __m128 a = pairs(0), b = pairs(2);
  first = (IntV)_mm_shuffle_ps(a, b, 0x88), second = (IntV)_mm_shuffle_ps(a, b, 0xdd);
#endif
}

/// The word at place(i), for lane i. Plain loops over pointers become a sum of vectors of pointers, which is
/// then taken apart.
template <class Place> SOFTGL_INLINE IntV load_words(Place place) {
  auto four = [&](int i) __attribute__((always_inline)) {
    auto word = [&](int k) __attribute__((always_inline)) {
      int32_t v;
      memcpy(&v, place(i + k), sizeof v);
      return v;
    };
    return _mm_setr_epi32(word(0), word(1), word(2), word(3));
  };
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  __m512i v = _mm512_castsi128_si512(four(0));
  v = _mm512_inserti32x4(v, four(4), 1);
  v = _mm512_inserti32x4(v, four(8), 2);
  return (IntV)_mm512_inserti32x4(v, four(12), 3);
#elif defined(__AVX2__)
  return (IntV)_mm256_inserti128_si256(_mm256_castsi128_si256(four(0)), four(4), 1);
#else
  return (IntV)four(0);
#endif
}

#if defined(__AVX512F__) && defined(__AVX512DQ__)
/// kWidth bytes to lanes; lanes below 32768 to kWidth halves.
SOFTGL_INLINE IntV load_bytes(const uint8_t* p) {
  return (IntV)_mm512_cvtepu8_epi32(_mm_loadu_si128((const __m128i*)p));
}
SOFTGL_INLINE void store_halves(uint16_t* p, IntV v) {
  _mm256_storeu_si256((__m256i*)p, _mm512_cvtepi32_epi16((__m512i)v));
}
#elif defined(__AVX2__)
SOFTGL_INLINE IntV load_bytes(const uint8_t* p) {
  return (IntV)_mm256_cvtepu8_epi32(_mm_loadl_epi64((const __m128i*)p));
}
SOFTGL_INLINE void store_halves(uint16_t* p, IntV v) {
  const __m256i w = (__m256i)v;
  _mm_storeu_si128((__m128i*)p, _mm_packs_epi32(_mm256_castsi256_si128(w), _mm256_extracti128_si256(w, 1)));
}
#else
SOFTGL_INLINE IntV load_bytes(const uint8_t* p) {
  int32_t bytes;
  memcpy(&bytes, p, 4);
  const __m128i zero = _mm_setzero_si128();
  return (IntV)_mm_unpacklo_epi16(_mm_unpacklo_epi8(_mm_cvtsi32_si128(bytes), zero), zero);
}
SOFTGL_INLINE void store_halves(uint16_t* p, IntV v) {
  _mm_storel_epi64((__m128i*)p, _mm_packs_epi32((__m128i)v, (__m128i)v));
}
#endif

#if defined(__AVX2__)
/// Lanes from -32768 to 32767, clamped to bytes: those of a in bits 0-7, b's in 8-15 and so on.
SOFTGL_INLINE IntV interleave_bytes(IntV a, IntV b, IntV c, IntV d) {
  const __m128i order = _mm_set_epi8(15, 11, 7, 3, 14, 10, 6, 2, 13, 9, 5, 1, 12, 8, 4, 0);
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  const __m512i bytes = _mm512_packus_epi16(_mm512_packs_epi32((__m512i)a, (__m512i)b),
                                            _mm512_packs_epi32((__m512i)c, (__m512i)d));
  return (IntV)_mm512_shuffle_epi8(bytes, _mm512_broadcast_i32x4(order));
#else
  const __m256i bytes = _mm256_packus_epi16(_mm256_packs_epi32((__m256i)a, (__m256i)b),
                                            _mm256_packs_epi32((__m256i)c, (__m256i)d));
  return (IntV)_mm256_shuffle_epi8(bytes,
                                   _mm256_broadcastsi128_si256(order)); // of each half: a0-3 b0-3 c0-3 d0-3
#endif
}
#endif

/// Lane index[i] of v in lane i.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
SOFTGL_INLINE FloatV permute(FloatV v, IntV index) {
  return (FloatV)_mm512_permutexvar_ps((__m512i)index, (__m512)v);
}
SOFTGL_INLINE IntV load_halves(const uint16_t* p) {
  return (IntV)_mm512_cvtepu16_epi32(_mm256_loadu_si256((const __m256i*)p));
}
#elif defined(__AVX2__)
SOFTGL_INLINE FloatV permute(FloatV v, IntV index) {
  return (FloatV)_mm256_permutevar8x32_ps((__m256)v, (__m256i)index);
}
SOFTGL_INLINE IntV load_halves(const uint16_t* p) {
  return (IntV)_mm256_cvtepu16_epi32(_mm_loadu_si128((const __m128i*)p));
}
#else
SOFTGL_INLINE FloatV permute(FloatV v, IntV index) {
  FloatV r;
  for (int i = 0; i < kWidth; ++i) r[i] = v[index[i]];
  return r;
}
SOFTGL_INLINE IntV load_halves(const uint16_t* p) {
  return (IntV)_mm_unpacklo_epi16(_mm_loadl_epi64((const __m128i*)p), _mm_setzero_si128());
}
#endif

/// How many lanes there are in front of the first that equals one before it.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
SOFTGL_INLINE int distinct_lanes(IntV v) {
  const __m512i earlier = _mm512_conflict_epi32((__m512i)v);
  return __builtin_ctz(uint32_t(_mm512_test_epi32_mask(earlier, earlier)) | 1u << kWidth);
}
#else
SOFTGL_INLINE int distinct_lanes(IntV v) {
  // Rotated by up to half of the lanes each one meets all others.
#if defined(__AVX2__)
  auto rotated = [&](int by) __attribute__((always_inline)) {
    const __m256i lane =
        _mm256_and_si256(_mm256_add_epi32(_mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7), _mm256_set1_epi32(by)),
                         _mm256_set1_epi32(7));
    return (IntV)_mm256_permutevar8x32_epi32((__m256i)v, lane);
  };
  const IntV equal = (v == rotated(1)) | (v == rotated(2)) | (v == rotated(3)) | (v == rotated(4));
#else
  const IntV equal = (v == (IntV)_mm_shuffle_epi32((__m128i)v, _MM_SHUFFLE(0, 3, 2, 1))) |
                     (v == (IntV)_mm_shuffle_epi32((__m128i)v, _MM_SHUFFLE(1, 0, 3, 2)));
#endif
  if (!sign_bits(equal)) return kWidth;
  int32_t lane[kWidth];
  memcpy(lane, &v, sizeof v);
  for (int i = 1; i < kWidth; ++i)
    for (int k = 0; k < i; ++k)
      if (lane[k] == lane[i]) return i;
  return kWidth;
}
#endif

/// Floats from p on: of eight each twice where a vector has sixteen lanes.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
SOFTGL_INLINE FloatV load_row(const float* p) { return (FloatV)_mm512_broadcast_f32x8(_mm256_loadu_ps(p)); }
#else
SOFTGL_INLINE FloatV load_row(const float* p) { return load(p); }
#endif

/// Every even lane twice, every odd lane twice.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
SOFTGL_INLINE FloatV even_lanes(FloatV v) { return (FloatV)_mm512_moveldup_ps((__m512)v); }
SOFTGL_INLINE FloatV odd_lanes(FloatV v) { return (FloatV)_mm512_movehdup_ps((__m512)v); }
#elif defined(__AVX2__)
SOFTGL_INLINE FloatV even_lanes(FloatV v) { return (FloatV)_mm256_moveldup_ps((__m256)v); }
SOFTGL_INLINE FloatV odd_lanes(FloatV v) { return (FloatV)_mm256_movehdup_ps((__m256)v); }
#else
SOFTGL_INLINE FloatV even_lanes(FloatV v) {
  return (FloatV)_mm_shuffle_ps((__m128)v, (__m128)v, _MM_SHUFFLE(2, 2, 0, 0));
}
SOFTGL_INLINE FloatV odd_lanes(FloatV v) {
  return (FloatV)_mm_shuffle_ps((__m128)v, (__m128)v, _MM_SHUFFLE(3, 3, 1, 1));
}
#endif

} // namespace SOFTGL_ISA
} // namespace softgl
