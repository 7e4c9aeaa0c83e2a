// The matrices, their stacks, and the viewport (2.11).
#include <numbers>
#include <utility>

#include "expect/calls.h"

namespace softgl::suite {
namespace {

Matrix4 operator*(const Matrix4& a, const Matrix4& b) {
  Matrix4 c;
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 4; j++) {
      c.m[4 * j + i] = 0;
      for (int k = 0; k < 4; k++) c.m[4 * j + i] += a(i, k) * b(k, j);
    }
  return c;
}

// 2.11.2
Matrix4 rotation(double degrees, const Vec3& axis) {
  const Vec3 u = spec::unit(axis);
  const double a = degrees * std::numbers::pi / 180, c = std::cos(a), s = std::sin(a);
  const double r[9] = {
      u.x * u.x * (1 - c) + c,       u.x * u.y * (1 - c) - u.z * s, u.x * u.z * (1 - c) + u.y * s,
      u.y * u.x * (1 - c) + u.z * s, u.y * u.y * (1 - c) + c,       u.y * u.z * (1 - c) - u.x * s,
      u.z * u.x * (1 - c) - u.y * s, u.z * u.y * (1 - c) + u.x * s, u.z * u.z * (1 - c) + c};
  Matrix4 m;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) m.m[4 * j + i] = r[3 * i + j];
  return m;
}

Matrix4 orthographic(double l, double r, double b, double t, double n, double f) {
  Matrix4 m;
  m.m[0] = 2 / (r - l), m.m[5] = 2 / (t - b), m.m[10] = -2 / (f - n);
  m.m[12] = -(r + l) / (r - l), m.m[13] = -(t + b) / (t - b), m.m[14] = -(f + n) / (f - n);
  return m;
}

Matrix4 frustum(double l, double r, double b, double t, double n, double f) {
  Matrix4 m;
  m.m[0] = 2 * n / (r - l), m.m[5] = 2 * n / (t - b), m.m[8] = (r + l) / (r - l), m.m[9] = (t + b) / (t - b);
  m.m[10] = -(f + n) / (f - n), m.m[11] = -1, m.m[14] = -2 * f * n / (f - n), m.m[15] = 0;
  return m;
}

Matrix4 transposed(const Matrix4& a) {
  Matrix4 t;
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 4; j++) t.m[4 * i + j] = a(i, j);
  return t;
}

Matrix4 matrix_of(const std::vector<double>& numbers) {
  Matrix4 m;
  std::copy(numbers.begin(), numbers.end(), m.m);
  return m;
}

} // namespace

// By Gauss and Jordan, with the greatest pivot.
Matrix4 inverse(Matrix4 a) {
  Matrix4 b;
  for (int column = 0; column < 4; column++) {
    int pivot = column;
    for (int row = column; row < 4; row++)
      if (std::abs(a(row, column)) > std::abs(a(pivot, column))) pivot = row;
    if (a(pivot, column) == 0) throw std::logic_error("a matrix that has no inverse");
    for (int j = 0; j < 4; j++)
      std::swap(a.m[4 * j + pivot], a.m[4 * j + column]), std::swap(b.m[4 * j + pivot], b.m[4 * j + column]);
    const double scale = 1 / a(column, column);
    for (int j = 0; j < 4; j++) a.m[4 * j + column] *= scale, b.m[4 * j + column] *= scale;
    for (int row = 0; row < 4; row++) {
      if (row == column) continue;
      const double times = a(row, column);
      for (int j = 0; j < 4; j++)
        a.m[4 * j + row] -= times * a(column, j), b.m[4 * j + row] -= times * b(column, j);
    }
  }
  return b;
}

std::vector<Matrix4>& Machine::matrices() {
  switch (state_.transform.matrix_mode) {
  case GL_PROJECTION: return state_.projection;
  case GL_TEXTURE: return state_.texture_matrix[state_.texture.active];
  }
  return state_.modelview;
}

// "the plane is transformed by the inverse of the modelview matrix when it is set" (2.12)
void Machine::clip_plane(int plane, const std::vector<double>& p) {
  const Matrix4 m = inverse(state_.modelview.back());
  double eye[4];
  for (int j = 0; j < 4; j++) eye[j] = p[0] * m(0, j) + p[1] * m(1, j) + p[2] * m(2, j) + p[3] * m(3, j);
  state_.transform.clip_plane[plane] = {eye[0], eye[1], eye[2], eye[3]};
}

bool Machine::play_matrices(const Call& call) {
  const auto n = [&](size_t i) { return call.n(i); };
  Matrix4 m;
  switch (call.command) {
  case Command::MatrixMode: state_.transform.matrix_mode = call.e(0); return true;
  case Command::PushMatrix: matrices().push_back(Matrix4(matrices().back())); return true;
  case Command::PopMatrix:
    if (matrices().size() == 1) throw std::logic_error("glPopMatrix of the last matrix");
    matrices().pop_back();
    return true;
  case Command::LoadIdentity: matrices().back() = {}; return true;
  case Command::DepthRange:
    state_.viewport.near = std::clamp(n(0), 0.0, 1.0), state_.viewport.far = std::clamp(n(1), 0.0, 1.0);
    return true;
  case Command::ClipPlane: clip_plane(int(call.e(0) - GL_CLIP_PLANE0), call.v(1)); return true;
  case Command::LoadTransposeMatrixf:
  case Command::LoadTransposeMatrixd: matrices().back() = transposed(matrix_of(call.v(0))); return true;
  case Command::LoadMatrixd:
  case Command::LoadMatrixf: matrices().back() = matrix_of(call.v(0)); return true;
  case Command::Viewport:
    for (size_t i = 0; i < 4; i++) state_.viewport.box[i] = int(n(i));
    return true;
  case Command::MultTransposeMatrixf:
  case Command::MultTransposeMatrixd: m = transposed(matrix_of(call.v(0))); break;
  case Command::MultMatrixd:
  case Command::MultMatrixf: m = matrix_of(call.v(0)); break;
  case Command::Translated:
  case Command::Translatef: m.m[12] = n(0), m.m[13] = n(1), m.m[14] = n(2); break;
  case Command::Scaled:
  case Command::Scalef: m.m[0] = n(0), m.m[5] = n(1), m.m[10] = n(2); break;
  case Command::Rotated:
  case Command::Rotatef: m = rotation(n(0), {n(1), n(2), n(3)}); break;
  case Command::Ortho: m = orthographic(n(0), n(1), n(2), n(3), n(4), n(5)); break;
  case Command::Frustum: m = frustum(n(0), n(1), n(2), n(3), n(4), n(5)); break;
  default: return false;
  }
  matrices().back() = matrices().back() * m;
  return true;
}

} // namespace softgl::suite
