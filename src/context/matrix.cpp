#include "context/matrix.h"

#include <cmath>
#include <cstring>

#include "base/bits.h"
#include "base/trigonometry.h"

namespace softgl {
namespace {

bool only(const Matrix& matrix, uint32_t allowed) { return (matrix.flags & kMatrixGeometry & ~allowed) == 0; }

void multiply_full(float* out, const float* a, const float* b) {
  float p[16];
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      p[element(row, column)] =
          a[element(row, 0)] * b[element(0, column)] + a[element(row, 1)] * b[element(1, column)] +
          a[element(row, 2)] * b[element(2, column)] + a[element(row, 3)] * b[element(3, column)];
  std::memcpy(out, p, sizeof p);
}

// Both have the last row 0 0 0 1; leaving out the products with it keeps infinities from becoming NaN.
void multiply_affine(float* out, const float* a, const float* b) {
  float p[16];
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column)
      p[element(row, column)] = a[element(row, 0)] * b[element(0, column)] +
                                a[element(row, 1)] * b[element(1, column)] +
                                a[element(row, 2)] * b[element(2, column)];
    p[element(row, 3)] += a[element(row, 3)];
  }
  for (int column = 0; column < 4; ++column) p[element(3, column)] = column == 3 ? 1.0f : 0.0f;
  std::memcpy(out, p, sizeof p);
}

void multiply_with_flags(Matrix& matrix, const float* m, uint32_t flags) {
  matrix.flags |= flags | kMatrixKindDirty | kMatrixInverseDirty;
  if (only(matrix, kMatrix3D))
    multiply_affine(matrix.data(), matrix.data(), m);
  else
    multiply_full(matrix.data(), matrix.data(), m);
}

} // namespace

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result;
  result.flags = a.flags | b.flags | kMatrixKindDirty | kMatrixInverseDirty;
  if (only(result, kMatrix3D))
    multiply_affine(result.data(), a.data(), b.data());
  else
    multiply_full(result.data(), a.data(), b.data());
  return result;
}

void set_identity(Matrix& matrix) {
  matrix.m = matrix.inverted = glm::mat4(1.0f);
  matrix.kind = MatrixKind::Identity;
  matrix.flags &= ~uint32_t(kMatrixDirty);
}

void load(Matrix& matrix, const float m[16]) {
  if (same_bits(m, matrix.data(), 16 * sizeof(float))) return; // OSMesa keeps the flags of an equal matrix
  std::memcpy(matrix.data(), m, 16 * sizeof(float));
  matrix.flags = kMatrixGeneral | kMatrixDirty;
}

void multiply(Matrix& matrix, const float m[16]) {
  const glm::mat4 identity(1.0f);
  if (same_bits(m, &identity, sizeof identity)) return;
  matrix.flags |= kMatrixGeneral | kMatrixDirty;
  multiply_full(matrix.data(), matrix.data(), m);
}

void rotate(Matrix& matrix, float degrees, float x, float y, float z) {
  if (degrees == 0.0f) return;
  const float radians = float(degrees * 3.14159265358979323846 / 180.0);
  const float s = sine(radians), c = cosine(radians);
  float m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  // A rotation about a coordinate axis writes only cosines and sines.
  int axis = -1;
  float direction = 0;
  if (x == 0 && y == 0 && z != 0)
    axis = 2, direction = z;
  else if (x == 0 && y != 0 && z == 0)
    axis = 1, direction = y;
  else if (x != 0 && y == 0 && z == 0)
    axis = 0, direction = x;
  if (axis >= 0) {
    const int i = (axis + 1) % 3, k = (axis + 2) % 3;
    m[element(i, i)] = m[element(k, k)] = c;
    m[element(i, k)] = direction < 0 ? s : -s;
    m[element(k, i)] = direction < 0 ? -s : s;
  } else {
    const float length = std::sqrt(x * x + y * y + z * z);
    if (length <= 1.0e-4f) return;
    x /= length;
    y /= length;
    z /= length;
    const float xx = x * x, yy = y * y, zz = z * z, xy = x * y, yz = y * z, zx = z * x;
    const float xs = x * s, ys = y * s, zs = z * s, rest = 1.0f - c;
    m[element(0, 0)] = rest * xx + c;
    m[element(0, 1)] = rest * xy - zs;
    m[element(0, 2)] = rest * zx + ys;
    m[element(1, 0)] = rest * xy + zs;
    m[element(1, 1)] = rest * yy + c;
    m[element(1, 2)] = rest * yz - xs;
    m[element(2, 0)] = rest * zx - ys;
    m[element(2, 1)] = rest * yz + xs;
    m[element(2, 2)] = rest * zz + c;
  }
  multiply_with_flags(matrix, m, kMatrixRotation);
}

void translate(Matrix& matrix, float x, float y, float z) {
  float* m = matrix.data();
  for (int row = 0; row < 4; ++row) m[12 + row] = m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row];
  matrix.flags |= kMatrixTranslation | kMatrixKindDirty | kMatrixInverseDirty;
}

void scale(Matrix& matrix, float x, float y, float z) {
  float* m = matrix.data();
  for (int row = 0; row < 4; ++row) m[row] *= x, m[4 + row] *= y, m[8 + row] *= z;
  const bool uniform = std::fabs(x - y) < 1e-8f && std::fabs(x - z) < 1e-8f;
  matrix.flags |=
      (uniform ? kMatrixUniformScale : kMatrixGeneralScale) | kMatrixKindDirty | kMatrixInverseDirty;
}

void frustum(Matrix& matrix, float left, float right, float bottom, float top, float near_value,
             float far_value) {
  float m[16] = {};
  m[element(0, 0)] = (2.0f * near_value) / (right - left);
  m[element(1, 1)] = (2.0f * near_value) / (top - bottom);
  m[element(0, 2)] = (right + left) / (right - left);
  m[element(1, 2)] = (top + bottom) / (top - bottom);
  m[element(2, 2)] = -(far_value + near_value) / (far_value - near_value);
  m[element(2, 3)] = -(2.0f * far_value * near_value) / (far_value - near_value);
  m[element(3, 2)] = -1.0f;
  multiply_with_flags(matrix, m, kMatrixPerspective);
}

void ortho(Matrix& matrix, float left, float right, float bottom, float top, float near_value,
           float far_value) {
  float m[16] = {};
  m[element(0, 0)] = 2.0f / (right - left);
  m[element(1, 1)] = 2.0f / (top - bottom);
  m[element(2, 2)] = -2.0f / (far_value - near_value);
  m[element(0, 3)] = -(right + left) / (right - left);
  m[element(1, 3)] = -(top + bottom) / (top - bottom);
  m[element(2, 3)] = -(far_value + near_value) / (far_value - near_value);
  m[element(3, 3)] = 1.0f;
  multiply_with_flags(matrix, m, kMatrixGeneralScale | kMatrixTranslation);
}

} // namespace softgl
