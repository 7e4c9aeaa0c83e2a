// Random numbers that are the same with every compiler and library.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>

namespace softgl::test {

using Float2 = std::array<float, 2>;
using Float3 = std::array<float, 3>;
using Float4 = std::array<float, 4>;

/// SplitMix64. Draw one number per statement (or inside braces): the order of evaluation of call arguments is
/// open.
class Random {
public:
  explicit Random(uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 0x1234567u) {}
  uint64_t bits() {
    uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// An integer in [low, high].
  int integer(int low, int high) { return low + int(bits() % uint64_t(int64_t(high) - low + 1)); }
  /// True in `percent` of a hundred cases.
  bool chance(int percent) { return integer(1, 100) <= percent; }
  /// A float in [low, high).
  float real(float low, float high) {
    return low + (high - low) * (float(bits() >> 40) * (1.0f / 16777216.0f));
  }
  template <class T> T pick(std::initializer_list<T> values) {
    return values.begin()[integer(0, int(values.size()) - 1)];
  }
  template <class T, size_t N> const T& pick(const std::array<T, N>& values) {
    return values[integer(0, int(N) - 1)];
  }
  /// Components in [0,1), sometimes exactly 0 or 1.
  Float4 color() {
    Float4 c;
    for (float& x : c) x = chance(10) ? float(integer(0, 1)) : real(0, 1);
    return c;
  }
  Float3 direction() {
    for (;;) {
      Float3 d{real(-1, 1), real(-1, 1), real(-1, 1)};
      float length2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      if (length2 > 0.01f && length2 < 1) return d;
    }
  }

private:
  uint64_t state_;
};

} // namespace softgl::test
