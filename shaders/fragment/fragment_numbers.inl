// The numbers that colors are stored as where they are not four bytes (ColorEncoding), and their arithmetic,
// which is that of OSMesa 22.3.6.
#pragma once

#include "shaders/fragment/fragment_merge.inl"

namespace softgl {
namespace SOFTGL_ISA {

namespace { // so that no member is visible outside

/// Numbers of [0, 1]: integers of 16 bits, of which the greatest one is 1.
struct UnsignedArithmetic {
  using T = IntV;
  static constexpr bool kFloat = false, kSigned = false;
  static constexpr int32_t kOne = 0xffff;
  SOFTGL_MEMBER static T one() { return splat(kOne); }
  SOFTGL_MEMBER static T stored(FloatV v) { return round_to_int(unit_range(v) * float(kOne)); }
  SOFTGL_MEMBER static T limited(T v) { return min_(max_(v, T{}), one()); }
  SOFTGL_MEMBER static T product(T a, T b) {
    const UintV p = (UintV)multiply(a, b);
    return (T)((p + (p >> 16) + 0x8000u) >> 16);
  }
  SOFTGL_MEMBER static T wide_product(T a, T b) { return product(a, b); }
  SOFTGL_MEMBER static T room(T alpha) { return kOne - alpha; }
  /// Of the product, which may not fit, the 16 bits are right that count.
  SOFTGL_MEMBER static T mix(T weight, T from, T to) {
    return (from + (T)((UintV)multiply(weight + (weight >> 15), to - from) >> 16)) & kOne;
  }
};

/// Numbers of [-1, 1].
template <int kBits> struct SignedArithmetic {
  using T = IntV;
  static constexpr bool kFloat = false, kSigned = true;
  static constexpr int32_t kOne = (1 << (kBits - 1)) - 1;
  SOFTGL_MEMBER static T one() { return splat(kOne); }
  /// Bytes become -128 where a color is less than -1 (GL_EXT_texture_snorm reads it as -1, too).
  SOFTGL_MEMBER static T stored(FloatV v) {
    const float least = kBits == 8 ? -128.0f / float(kOne) : -1.0f;
    return round_to_int(min_(max_(v, splat(least)), splat(1.0f)) * float(kOne));
  }
  SOFTGL_MEMBER static T limited(T v) { return min_(max_(v, splat(-kOne - 1)), one()); }
  /// Products have twice as many bits, and wrap around.
  SOFTGL_MEMBER static T doubled(UintV v) { return (T)(v << (32 - 2 * kBits)) >> (32 - 2 * kBits); }
  SOFTGL_MEMBER static T wide_product(T a, T b) {
    const T exact = multiply(a, b), p = doubled((UintV)exact + (UintV)(exact >> (kBits - 1)));
    const T half = choose(p < 0, splat(-(1 << (kBits - 2))), splat(1 << (kBits - 2)));
    return doubled((UintV)p + (UintV)half) >> (kBits - 1);
  }
  SOFTGL_MEMBER static T product(T a, T b) { return limited(wide_product(a, b)); }
  SOFTGL_MEMBER static T room(T alpha) { return kOne - max_(alpha, T{}); }
  SOFTGL_MEMBER static T mix(T weight, T from, T to) {
    return limited(from + wide_product(weight, to - from));
  }
};

struct FloatArithmetic {
  using T = FloatV;
  static constexpr bool kFloat = true, kSigned = true;
  SOFTGL_MEMBER static T one() { return splat(1.0f); }
  SOFTGL_MEMBER static T stored(FloatV v) { return v; }
  SOFTGL_MEMBER static T limited(T v) { return v; }
  SOFTGL_MEMBER static T product(T a, T b) { return a * b; }
  SOFTGL_MEMBER static T room(T alpha) { return 1.0f - alpha; }
  SOFTGL_MEMBER static T mix(T weight, T from, T to) { return weight * (to - from) + from; }
};

} // namespace

/// drawn_number() of vectors.
template <int kWide> SOFTGL_INLINE IntV drawn_numbers(IntV v, int bits) {
  if (bits == kWide) return v;
  const int rest = kWide - bits;
  IntV n;
  if (bits == 4 && kWide == 8) {
    const IntV more = v + 8;
    n = ((more << 8) - (more << 4) + more) >> 12; // by 17
  } else if (rest <= bits) {
    n = v >> rest;
  } else {
    const IntV upper = v >> bits;
    n = ((upper << bits) - upper + (1 << (rest - 1))) >> rest;
  }
  IntV filled = n << rest;
  for (int m = bits; m < kWide; m *= 2) filled |= filled >> m;
  return filled;
}

#if defined(__F16C__)
/// Halves towards zero, but for numbers that are none.
SOFTGL_INLINE FloatV cut_to_halves(FloatV v) {
  constexpr int kTowardsZero = _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC;
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  return (FloatV)_mm512_cvtph_ps(_mm512_cvtps_ph((__m512)v, kTowardsZero));
#else
  return (FloatV)_mm256_cvtph_ps(_mm256_cvtps_ph((__m256)v, kTowardsZero));
#endif
}
#endif

/// drawn_float() of vectors.
SOFTGL_INLINE FloatV drawn_floats(FloatV v, int bits) {
  if (bits == 32) return v;
#if defined(__F16C__)
  if (bits == 16) {
    const IntV none = ((IntV)v & INT32_MIN) | 0x7fc00000;
    return choose((IntV)(v == v), cut_to_halves(v), (FloatV)none);
  }
#endif
  const int mantissa = bits == 16 ? 10 : bits - 5;
  const int32_t mask = ~int32_t((1u << (23 - mantissa)) - 1), infinity = 0x7f800000;
  const IntV word = (IntV)v, magnitude = word & 0x7fffffff, most = splat(0x47000000 | (0x7fffff & mask));
  const float steps = float(1u << (14 + mantissa));
  const IntV small = (IntV)(to_float(truncate((FloatV)magnitude * steps)) * (1.0f / steps));
  IntV n = choose(magnitude < 0x38800000, small, min_(magnitude & mask, most));
  n = choose(magnitude == infinity, magnitude, n);
  n = bits == 16 ? n | (word & INT32_MIN) : n & ~(word >> 31);
  const IntV none = bits == 16 ? (word & INT32_MIN) | 0x7fc00000 : splat(0x7fc00000);
  return (FloatV)choose(magnitude > infinity, none, n);
}

} // namespace SOFTGL_ISA
} // namespace softgl
