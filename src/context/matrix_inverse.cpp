// settle_history(): which kind of matrix this is, and its inverse by that kind. The order of operations is
// OSMesa 22.3.6's, because the inverse transforms normals, lights and clip planes.
#include <cmath>
#include <initializer_list>
#include <utility>

#include "context/matrix.h"

namespace softgl {
namespace {

float square(float x) { return x * x; }
float dot3(const float* a, const float* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
float dot2(const float* a, const float* b) { return a[0] * b[0] + a[1] * b[1]; }

constexpr float kTolerance = 1e-6f * 1e-6f;

bool zero(const float* m, std::initializer_list<int> elements) {
  for (int i : elements)
    if (m[i] != 0.0f) return false;
  return true;
}
bool last_row_affine(const float* m) { return zero(m, {3, 7, 11}) && m[15] == 1.0f; }

uint32_t flags_by_value_planar(const float* m) {
  uint32_t flags = 0;
  if (square(dot2(m, m) - 1) > kTolerance || square(dot2(m + 4, m + 4) - 1) > kTolerance)
    flags |= kMatrixGeneralScale;
  return flags | (square(dot2(m, m + 4)) > kTolerance ? kMatrixGeneral3D : kMatrixRotation);
}

uint32_t flags_by_value_affine(const float* m) {
  uint32_t flags = 0;
  const float c1 = dot3(m, m), c2 = dot3(m + 4, m + 4), c3 = dot3(m + 8, m + 8);
  if (square(c1 - c2) < kTolerance && square(c1 - c3) < kTolerance) {
    if (square(c1 - 1.0f) > kTolerance) flags |= kMatrixUniformScale;
  } else {
    flags |= kMatrixGeneralScale;
  }
  if (square(dot3(m, m + 4)) < kTolerance) {
    const float* u = m;
    const float* v = m + 4;
    const float difference[3] = {u[1] * v[2] - u[2] * v[1] - m[8], u[2] * v[0] - u[0] * v[2] - m[9],
                                 u[0] * v[1] - u[1] * v[0] - m[10]};
    return flags | (dot3(difference, difference) < kTolerance ? kMatrixRotation : kMatrixGeneral3D);
  }
  return flags | kMatrixGeneral3D;
}

void classify_by_value(Matrix& matrix) {
  const float* m = matrix.data();
  uint32_t flags = zero(m, {12, 13, 14}) ? 0u : uint32_t(kMatrixTranslation);
  const bool affine = last_row_affine(m);
  const bool flat = affine && zero(m, {8, 9, 2, 6, 14}) && m[10] == 1.0f; // z stays as it is
  if (flat && zero(m, {4, 1, 12, 13}) && m[0] == 1.0f && m[5] == 1.0f) {
    matrix.kind = MatrixKind::Identity;
  } else if (flat && zero(m, {4, 1})) {
    matrix.kind = MatrixKind::NoRotation2D;
    if (!(m[0] == 1.0f && m[5] == 1.0f)) flags |= kMatrixGeneralScale;
  } else if (flat) {
    matrix.kind = MatrixKind::Planar;
    flags |= flags_by_value_planar(m);
  } else if (affine && zero(m, {4, 8, 1, 9, 2, 6})) {
    matrix.kind = MatrixKind::NoRotation3D;
    if (square(m[0] - m[5]) < kTolerance && square(m[0] - m[10]) < kTolerance) {
      if (square(m[0] - 1.0f) > kTolerance) flags |= kMatrixUniformScale;
    } else {
      flags |= kMatrixGeneralScale;
    }
  } else if (affine) {
    matrix.kind = MatrixKind::Affine;
    flags |= flags_by_value_affine(m);
  } else {
    const bool perspective = zero(m, {4, 12, 1, 13, 2, 6, 3, 7, 15}) && m[11] == -1.0f;
    matrix.kind = perspective ? MatrixKind::Perspective : MatrixKind::General;
    flags |= kMatrixGeneral;
  }
  matrix.flags = (matrix.flags & ~uint32_t(kMatrixGeometry)) | flags;
}

void classify_by_flags(Matrix& matrix) {
  const float* m = matrix.data();
  const uint32_t geometry = matrix.flags & kMatrixGeometry;
  if (geometry == 0) {
    matrix.kind = MatrixKind::Identity;
  } else if ((geometry & ~uint32_t(kMatrixTranslation | kMatrixUniformScale | kMatrixGeneralScale)) == 0) {
    matrix.kind = m[10] == 1.0f && m[14] == 0.0f ? MatrixKind::NoRotation2D : MatrixKind::NoRotation3D;
  } else if ((geometry & ~uint32_t(kMatrix3D)) == 0) {
    const bool flat = zero(m, {8, 9, 2, 6, 14}) && m[10] == 1.0f;
    matrix.kind = flat ? MatrixKind::Planar : MatrixKind::Affine;
  } else {
    const bool perspective = zero(m, {4, 12, 1, 13, 2, 6, 3, 7, 15}) && m[11] == -1.0f;
    matrix.kind = perspective ? MatrixKind::Perspective : MatrixKind::General;
  }
}

// Gauss elimination with partial pivoting of [m | 1]. The order of every operation counts.
bool invert_general(float* out, const float* m) {
  float rows[4][8];
  float* r[4];
  for (int i = 0; i < 4; ++i) {
    r[i] = rows[i];
    for (int k = 0; k < 4; ++k) r[i][k] = m[element(i, k)], r[i][4 + k] = i == k ? 1.0f : 0.0f;
  }
  for (int column = 0; column < 3; ++column) {
    for (int i = 3; i > column; --i)
      if (std::fabs(r[i][column]) > std::fabs(r[i - 1][column])) std::swap(r[i], r[i - 1]);
    if (r[column][column] == 0.0f) return false;
    for (int i = column + 1; i < 4; ++i) {
      const float factor = r[i][column] / r[column][column];
      for (int k = column + 1; k < 8; ++k) {
        const float s = r[column][k];
        // Zeros of the right half are skipped while the first two variables are eliminated.
        if (k < 4 || column == 2 || s != 0.0f) r[i][k] -= factor * s;
      }
    }
  }
  if (r[3][3] == 0.0f) return false;
  const float last = 1.0f / r[3][3];
  for (int k = 4; k < 8; ++k) r[3][k] *= last;
  for (int i = 2; i >= 0; --i) {
    // Row i has already lost the rows below i + 1.
    const float below = r[i][i + 1], s = 1.0f / r[i][i];
    for (int k = 4; k < 8; ++k) r[i][k] = s * (r[i][k] - r[i + 1][k] * below);
    for (int above = i - 1; above >= 0; --above) {
      const float factor = r[above][i + 1];
      for (int k = 4; k < 8; ++k) r[above][k] -= r[i + 1][k] * factor;
    }
  }
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) out[element(i, k)] = r[i][4 + k];
  return true;
}

void invert_translation(float* out, const float* in) {
  for (int i = 0; i < 3; ++i)
    out[element(i, 3)] = -(in[element(0, 3)] * out[element(i, 0)] + in[element(1, 3)] * out[element(i, 1)] +
                           in[element(2, 3)] * out[element(i, 2)]);
}

// Adjugate over determinant; positive and negative products of the determinant are summed apart.
bool invert_affine_general(float* out, const float* in) {
  const auto e = [in](int row, int column) { return in[element(row, column)]; };
  float positive = 0.0f, negative = 0.0f;
  const float terms[6] = {e(0, 0) * e(1, 1) * e(2, 2),  e(1, 0) * e(2, 1) * e(0, 2),
                          e(2, 0) * e(0, 1) * e(1, 2),  -e(2, 0) * e(1, 1) * e(0, 2),
                          -e(1, 0) * e(0, 1) * e(2, 2), -e(0, 0) * e(2, 1) * e(1, 2)};
  for (float t : terms) (t >= 0.0f ? positive : negative) += t;
  float determinant = positive + negative;
  if (std::fabs(determinant) < 1e-25f) return false;
  determinant = 1.0f / determinant;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      // Cofactor (k, i): rows and columns without k and i, in ascending order.
      const int r0 = k == 0 ? 1 : 0, r1 = k == 2 ? 1 : 2, c0 = i == 0 ? 1 : 0, c1 = i == 2 ? 1 : 2;
      const float minor = e(r0, c0) * e(r1, c1) - e(r1, c0) * e(r0, c1);
      out[element(i, k)] = ((i + k) & 1 ? -minor : minor) * determinant;
    }
  invert_translation(out, in);
  return true;
}

bool invert_affine(float* out, const Matrix& matrix) {
  const float* in = matrix.data();
  constexpr uint32_t angle_preserving = kMatrixRotation | kMatrixTranslation | kMatrixUniformScale;
  if (matrix.flags & kMatrixGeometry & ~angle_preserving) return invert_affine_general(out, in);
  if (matrix.flags & kMatrixUniformScale) {
    float s = in[element(0, 0)] * in[element(0, 0)] + in[element(0, 1)] * in[element(0, 1)] +
              in[element(0, 2)] * in[element(0, 2)];
    if (s == 0.0f) return false;
    s = 1.0f / s;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) out[element(i, k)] = s * in[element(k, i)];
  } else if (matrix.flags & kMatrixRotation) {
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) out[element(i, k)] = in[element(k, i)];
  } else {
    for (int i = 0; i < 3; ++i) out[element(i, 3)] = -in[element(i, 3)];
    return true;
  }
  if (matrix.flags & kMatrixTranslation)
    invert_translation(out, in);
  else
    out[12] = out[13] = out[14] = 0.0f;
  return true;
}

bool invert_without_rotation(float* out, const Matrix& matrix, int dimensions) {
  const float* in = matrix.data();
  for (int i = 0; i < dimensions; ++i)
    if (in[element(i, i)] == 0.0f) return false;
  for (int i = 0; i < dimensions; ++i) {
    out[element(i, i)] = 1.0f / in[element(i, i)];
    if (matrix.flags & kMatrixTranslation) out[element(i, 3)] = -(in[element(i, 3)] * out[element(i, i)]);
  }
  return true;
}

bool invert(float* out, const Matrix& matrix) {
  switch (matrix.kind) {
  case MatrixKind::Identity: return true;
  case MatrixKind::NoRotation3D: return invert_without_rotation(out, matrix, 3);
  case MatrixKind::NoRotation2D: return invert_without_rotation(out, matrix, 2);
  case MatrixKind::Planar:
  case MatrixKind::Affine: return invert_affine(out, matrix);
  default: return invert_general(out, matrix.data());
  }
}

} // namespace

void settle_history(Matrix& matrix) {
  if (!(matrix.flags & kMatrixDirty)) return;
  if (matrix.flags & kMatrixKindDirty) {
    if (matrix.flags & kMatrixFlagsDirty)
      classify_by_value(matrix);
    else
      classify_by_flags(matrix);
  }
  if (matrix.flags & kMatrixInverseDirty) {
    glm::mat4 result(1.0f);
    if (invert(&result[0][0], matrix)) {
      matrix.flags &= ~uint32_t(kMatrixSingular);
      matrix.inverted = result;
    } else {
      matrix.flags |= kMatrixSingular;
      matrix.inverted = glm::mat4(1.0f);
    }
  }
  matrix.flags &= ~uint32_t(kMatrixDirty);
}

} // namespace softgl
