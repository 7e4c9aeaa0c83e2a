// A 4x4 matrix that remembers what kinds of transformation it was made of.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace softgl {

/// The history of a matrix: what it may contain, as OSMesa tracks it. Commands add bits. glLoadMatrix and
/// glMultMatrix ask for a classification by value at the next settle_history(). glLoadIdentity leaves the
/// bits as they are. The bits choose the inverse and the space of lighting, so they decide the last bits of
/// lit colors.
enum MatrixFlag : uint32_t {
  kMatrixGeneral = 0x01,
  kMatrixRotation = 0x02,
  kMatrixTranslation = 0x04,
  kMatrixUniformScale = 0x08,
  kMatrixGeneralScale = 0x10,
  kMatrixGeneral3D = 0x20,
  kMatrixPerspective = 0x40,
  kMatrixSingular = 0x80,
  kMatrixGeometry = 0xff,
  kMatrixKindDirty = 0x100,    // `kind` is out of date
  kMatrixFlagsDirty = 0x200,   // the flags must be found from the values
  kMatrixInverseDirty = 0x400, // `inverse` is out of date
  kMatrixDirty = 0x700,
  kMatrix3D =
      kMatrixRotation | kMatrixTranslation | kMatrixUniformScale | kMatrixGeneralScale | kMatrixGeneral3D
};

enum class MatrixKind : uint8_t {
  General,
  Identity,
  NoRotation3D,
  Perspective,
  Planar,
  NoRotation2D,
  Affine
};

struct Matrix {
  glm::mat4 m{1.0f};
  glm::mat4 inverted{1.0f}; // valid after settle_history()
  uint32_t flags = 0;       // MatrixFlag
  MatrixKind kind = MatrixKind::Identity;

  float* data() { return &m[0][0]; }
  const float* data() const { return &m[0][0]; }
};

/// Where an element lies: a matrix is stored by columns (GL 1.5, 2.11.2).
constexpr int element(int row, int column) { return column * 4 + row; }

/// Brings flags, kind and inverse up to date with the commands so far. Call it where OSMesa looks at a
/// matrix, and nowhere else: when a matrix is pushed, at a spot direction, a clip plane or an eye plane, and
/// before a draw (modelview; projection only with clip planes enabled). The moment matters, because a later
/// command adds its bits to what was found here.
void settle_history(Matrix& matrix);

/// settle_history() and the inverse; the identity if the matrix is singular.
inline const glm::mat4& inverse(Matrix& matrix) {
  settle_history(matrix);
  return matrix.inverted;
}

/// True if only rotations and translations were multiplied. Call settle_history() first.
inline bool is_length_preserving(const Matrix& matrix) {
  return (matrix.flags & kMatrixGeometry & ~uint32_t(kMatrixRotation | kMatrixTranslation)) == 0;
}

/// a * b with the flags of both; the sums are ((x + y) + z) + w in float.
Matrix product(const Matrix& a, const Matrix& b);

/// A plane equation (a row vector) times a matrix, which is the inverse of what points are multiplied with.
inline glm::vec4 transform_plane(const glm::vec4& v, const glm::mat4& m) {
  glm::vec4 u;
  for (int i = 0; i < 4; ++i) u[i] = v[0] * m[i][0] + v[1] * m[i][1] + v[2] * m[i][2] + v[3] * m[i][3];
  return u;
}

// The commands' effect on a matrix (GL 1.5, 2.11.2), arguments already valid.
void set_identity(Matrix& matrix);
void load(Matrix& matrix, const float m[16]);
void multiply(Matrix& matrix, const float m[16]);
void rotate(Matrix& matrix, float degrees, float x, float y, float z);
void translate(Matrix& matrix, float x, float y, float z);
void scale(Matrix& matrix, float x, float y, float z);
void frustum(Matrix& matrix, float left, float right, float bottom, float top, float near_value,
             float far_value);
void ortho(Matrix& matrix, float left, float right, float bottom, float top, float near_value,
           float far_value);

} // namespace softgl
