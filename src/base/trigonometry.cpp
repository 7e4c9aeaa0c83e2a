// OSMesa asks the C library, and since glibc 2.28 that means the polynomials of Arm's optimized routines
// (within 0.56 units in the last place). Correct rounding would give another float for 1.3 % of the
// arguments, so the same polynomials are evaluated here, in plain doubles; the answers agreed with those of a
// host with FMA for all of 25 million arguments.
#include "base/trigonometry.h"

#include <cstdint>
#include <cstring>

namespace softgl {
namespace {

struct Reduced {
  double r;     // within about pi/4 of zero
  int quadrant; // x = r + quadrant * pi/2 (mod 2 pi)
};

// 2/pi in binary: the first word holds the first 32 bits behind the point.
constexpr uint32_t kTwoOverPi[] = {0xA2F9836E, 0x4E441529, 0xFC2757D1, 0xF534DDC0,
                                   0xDB629599, 0x3C439041, 0xFE5163AB};

uint32_t two_over_pi_bits(int first) { // 32 bits from bit `first` on; bits before the point are zero
  uint64_t pair = 0;
  for (int i = 0; i < 64; ++i) {
    const int bit = (first & ~31) + i;
    pair = pair << 1 | (bit < 0 ? 0u : kTwoOverPi[bit / 32] >> (31 - bit % 32) & 1u);
  }
  return uint32_t(pair << (first & 31) >> 32);
}

// |x| >= 120: mantissa times the 96 bits of 2/pi that matter, modulo 4, in units of 2^-62.
Reduced reduce_large(uint32_t bits) {
  const int exponent = int(bits >> 23 & 0xff) - 150; // |x| = mantissa * 2^exponent
  // Eight exponents share a window, and the mantissa is shifted within it: the bits cut off below decide the
  // last bits of the result.
  const int shift = int(bits >> 23 & 7);
  const uint32_t mantissa = ((bits & 0x7fffffu) | 0x800000u) << shift;
  const int first = exponent - shift - 2;
  const uint64_t high = uint64_t(uint32_t(mantissa * two_over_pi_bits(first))) << 32;
  const uint64_t middle = uint64_t(mantissa) * two_over_pi_bits(first + 32);
  const uint64_t low = uint64_t(mantissa) * two_over_pi_bits(first + 64);
  const uint64_t product = (high | low >> 32) + middle;
  const uint64_t quadrant = (product + (uint64_t(1) << 61)) >> 62;
  return {double(int64_t(product - (quadrant << 62))) * 0x1.921FB54442D18p-62, int(quadrant)};
}

Reduced reduce(float x) {
  constexpr double kQuadrantsIn24Bits = 0x1.45F306DC9C883p+23; // 2/pi * 2^24
  const int n = (int(double(x) * kQuadrantsIn24Bits) + 0x800000) >> 24;
  // With FMA the product with pi/2 is not rounded: here it is the sum of two exact ones. It matters close to
  // a zero.
  return {(double(x) - n * 0x1.921FB54440000p0) - n * 0x2.D18p-40, n};
}

double sine_near_zero(double x, double x2) {
  const double x3 = x * x2;
  const double upper = 0x1.1107605230bc4p-7 + x2 * -0x1.994eb3774cf24p-13;
  const double x5 = x3 * x2;
  return (x + x3 * -0x1.555545995a603p-3) + x5 * upper;
}

double cosine_near_zero(double x2) {
  const double x4 = x2 * x2;
  const double upper = -0x1.6c087e89a359dp-10 + x2 * 0x1.99343027bf8c3p-16;
  const double lower = 1.0 + x2 * -0x1.ffffffd0c621cp-2;
  const double x6 = x4 * x2;
  return (lower + x4 * 0x1.55553e1068f19p-5) + x6 * upper;
}

float evaluate(double r, int quadrant) {
  const double value = quadrant & 1 ? cosine_near_zero(r * r) : sine_near_zero(r, r * r);
  return float(quadrant & 2 ? -value : value);
}

uint32_t bits_of(float x) {
  uint32_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

/// The arctangent of x >= 0, in the plain floats of glibc's atanf before 2.41: from 7/16 on it is taken
/// relative to that of 1/2, 1, 3/2 or infinity.
float arctangent(float x) {
  struct Reference {
    float high, low; // its arctangent
  };
  constexpr Reference kReferences[] = {{0x1.dac670p-2f, 0x1.586ed2p-28f},
                                       {0x1.921fb4p-1f, 0x1.4442d0p-25f},
                                       {0x1.f730bcp-1f, 0x1.281f68p-25f},
                                       {0x1.921fb4p+0f, 0x1.4442d0p-24f}};
  if (x >= 0x1p34f) return kReferences[3].high + kReferences[3].low;
  if (x < 0x1p-29f) return x;
  const Reference* from = nullptr;
  if (x >= 2.4375f)
    from = &kReferences[3], x = -1.0f / x;
  else if (x >= 1.1875f)
    from = &kReferences[2], x = (x - 1.5f) / (1.0f + 1.5f * x);
  else if (x >= 0.6875f)
    from = &kReferences[1], x = (x - 1.0f) / (x + 1.0f);
  else if (x >= 0.4375f)
    from = &kReferences[0], x = (2.0f * x - 1.0f) / (2.0f + x);
  constexpr float kSeries[] = {0x1.555556p-2f, -0x1.99999ap-3f, 0x1.24924ap-3f, -0x1.c71c70p-4f,
                               0x1.745cdcp-4f, -0x1.3b0f2ap-4f, 0x1.10d66ap-4f, -0x1.dde2d6p-5f,
                               0x1.97b4b2p-5f, -0x1.2b4442p-5f, 0x1.0ad3aep-6f};
  const float x2 = x * x, x4 = x2 * x2;
  float even = kSeries[10], odd = kSeries[9];
  for (int i = 8; i >= 0; i -= 2) even = kSeries[i] + x4 * even;
  for (int i = 7; i >= 1; i -= 2) odd = kSeries[i] + x4 * odd;
  const float less = x * (x2 * even + x4 * odd);
  return from ? from->high - ((less - from->low) - x) : x - less;
}

} // namespace

float angle_of(float y, float x) {
  constexpr float kPi = 0x1.921fb6p+1f, kPiRest = -0x1.777a5cp-24f, kHalfPi = 0x1.921fb6p+0f;
  const bool below = bits_of(y) >> 31, left = bits_of(x) >> 31;
  const float height = below ? -y : y, width = left ? -x : x;
  float angle = 0;
  if (height != 0) angle = height >= width * 0x1p25f ? kHalfPi : arctangent(height / width);
  if (left && width != 0) angle = kPi - (angle - kPiRest);
  return below ? -angle : angle;
}

float sine(float x) {
  const uint32_t bits = bits_of(x), magnitude = bits & 0x7fffffffu;
  if (magnitude < 0x39800000u) return x;              // 2^-12
  if (magnitude < 0x3f400000u) return evaluate(x, 0); // below pi/4 by its exponent and upper 3 bits
  if (magnitude >= 0x7f800000u) return x - x;         // infinity, NaN
  if (magnitude < 0x42f00000u) {                      // 120
    const Reduced a = reduce(x);
    return evaluate(a.r, a.quadrant);
  }
  const Reduced a = reduce_large(bits);
  const float s = evaluate(a.r, a.quadrant);
  return bits >> 31 ? -s : s;
}

float cosine(float x) {
  const uint32_t bits = bits_of(x), magnitude = bits & 0x7fffffffu;
  if (magnitude < 0x39800000u) return 1.0f;
  if (magnitude < 0x3f400000u) return evaluate(x, 1);
  if (magnitude >= 0x7f800000u) return x - x;
  const Reduced a = magnitude < 0x42f00000u ? reduce(x) : reduce_large(bits & 0x7fffffffu);
  return evaluate(a.r, a.quadrant + 1);
}

} // namespace softgl
