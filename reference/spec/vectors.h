// Vectors, colors and matrices in double, with the operators of GL 1.5, 2.14.1.
#pragma once

#include <algorithm>
#include <cmath>

namespace softgl::spec {

struct Vec3 {
  double x = 0, y = 0, z = 0;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
/// The product of two colors, component by component.
constexpr Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
/// The unit vector in a's direction. The zero vector has none and stays zero.
inline Vec3 unit(Vec3 a) {
  const double l = length(a);
  return l > 0 ? (1 / l) * a : a;
}
/// max(a . b, 0), the operator that the specification writes as a circled dot.
constexpr double clamped_dot(Vec3 a, Vec3 b) { return std::max(dot(a, b), 0.0); }

/// A homogeneous point: w = 0 is a point at infinity, in the direction (x, y, z).
struct Vec4 {
  double x = 0, y = 0, z = 0, w = 1;
  constexpr Vec3 xyz() const { return {x, y, z}; }
  constexpr Vec3 divided() const { return {x / w, y / w, z / w}; }
};

/// A matrix as OpenGL stores it: column after column.
struct Matrix4 {
  double m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  constexpr double operator()(int row, int column) const { return m[4 * column + row]; }
};

constexpr Vec4 operator*(const Matrix4& m, Vec4 v) {
  double r[4] = {};
  for (int i = 0; i < 4; i++) r[i] = m(i, 0) * v.x + m(i, 1) * v.y + m(i, 2) * v.z + m(i, 3) * v.w;
  return {r[0], r[1], r[2], r[3]};
}

} // namespace softgl::spec
