// Every number that a correct implementation may give, as the interval from the least to the greatest. Each
// operation widens its result by the accuracy that GL 1.5, 2.1.1 asks for.
#pragma once

#include <algorithm>
#include <cmath>

#include "vectors.h"

namespace softgl::spec {

/// 2.1.1: "individual results of floating-point operations are accurate to about 1 part in 10^5".
constexpr double kAccuracy = 1e-5;

struct Interval {
  double low = 0, high = 0;
  constexpr Interval() = default;
  constexpr Interval(double exact) : low(exact), high(exact) {}
  constexpr Interval(double least, double greatest) : low(least), high(greatest) {}
  constexpr double middle() const { return (low + high) / 2; }
  constexpr bool contains(double x) const { return low <= x && x <= high; }
};

/// The result of an operation: as exact as 2.1.1 asks for, no more.
inline Interval rounded(Interval a) {
  return {a.low - kAccuracy * std::abs(a.low), a.high + kAccuracy * std::abs(a.high)};
}
/// The interval with `margin` more at both ends.
constexpr Interval widened(Interval a, double margin) { return {a.low - margin, a.high + margin}; }
/// The least interval that holds both.
constexpr Interval hull(Interval a, Interval b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

inline Interval operator-(Interval a) { return {-a.high, -a.low}; }
inline Interval operator+(Interval a, Interval b) { return rounded({a.low + b.low, a.high + b.high}); }
inline Interval operator-(Interval a, Interval b) { return a + -b; }
inline Interval operator*(Interval a, Interval b) {
  const auto [least, greatest] =
      std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return rounded({least, greatest});
}
/// 1 / a for an interval above 0; what holds 0 has no upper end.
inline Interval reciprocal(Interval a) {
  return rounded({1 / std::max(a.high, 1e-18), 1 / std::max(a.low, 1e-18)});
}
inline Interval square_root(Interval a) {
  return rounded({std::sqrt(std::max(a.low, 0.0)), std::sqrt(std::max(a.high, 0.0))});
}
/// a to a power that is 0 or more; a is cut at 0, and the power 0 is 1.
inline Interval power(Interval a, double exponent) {
  if (exponent == 0) return 1;
  return rounded({std::pow(std::max(a.low, 0.0), exponent), std::pow(std::max(a.high, 0.0), exponent)});
}
constexpr Interval clamped(Interval a, double least, double greatest) {
  return {std::clamp(a.low, least, greatest), std::clamp(a.high, least, greatest)};
}

struct Vec3Interval {
  Interval x, y, z;
  constexpr Vec3Interval() = default;
  constexpr Vec3Interval(Interval x_, Interval y_, Interval z_) : x(x_), y(y_), z(z_) {}
  constexpr Vec3Interval(Vec3 exact) : x(exact.x), y(exact.y), z(exact.z) {}
};

inline Vec3Interval operator-(Vec3Interval a) { return {-a.x, -a.y, -a.z}; }
inline Vec3Interval operator+(Vec3Interval a, Vec3Interval b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3Interval operator-(Vec3Interval a, Vec3Interval b) { return a + -b; }
inline Vec3Interval operator*(Interval s, Vec3Interval a) { return {s * a.x, s * a.y, s * a.z}; }
inline Interval dot(Vec3Interval a, Vec3Interval b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Interval square(Interval a) {
  const double l = a.low * a.low, h = a.high * a.high;
  return rounded({a.contains(0) ? 0 : std::min(l, h), std::max(l, h)});
}
inline Interval length(Vec3Interval a) { return square_root(square(a.x) + square(a.y) + square(a.z)); }
/// The unit vector in a's direction. The zero vector has none and stays zero, as in vectors.h.
inline Vec3Interval unit(Vec3Interval a) {
  const Interval l = length(a);
  if (l.high == 0) return a;
  if (l.low <= 0) return {{-1, 1}, {-1, 1}, {-1, 1}};
  const Vec3Interval u = reciprocal(l) * a;
  return {clamped(u.x, -1 - kAccuracy, 1 + kAccuracy), clamped(u.y, -1 - kAccuracy, 1 + kAccuracy),
          clamped(u.z, -1 - kAccuracy, 1 + kAccuracy)};
}

} // namespace softgl::spec
