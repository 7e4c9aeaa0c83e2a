// From the types of the entry points to the types of the canonical commands (GL 1.5, 2.7 and table 2.9).
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/gl_types.h"
#include "base/normalized.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {

/// Nearest integer of a float parameter, for commands whose parameters are integers; out of range saturates,
/// NaN is 0.
inline GLint round_to_int(float v) {
  if (!(v == v)) return 0;
  if (v >= 2147483648.0f) return 2147483647;
  if (v <= -2147483648.0f) return -2147483647 - 1;
  return GLint(std::lround(v));
}

struct Matrix16 {
  GLfloat m[16];
};
template <class T> Matrix16 matrix_of(const T* m) {
  Matrix16 r;
  for (int i = 0; i < 16; ++i) r.m[i] = GLfloat(m[i]);
  return r;
}
template <class T> Matrix16 transposed(const T* m) {
  Matrix16 r;
  for (int i = 0; i < 16; ++i) r.m[i] = GLfloat(m[SOFTGL_FAULT(transpose_ignored) ? i : i % 4 * 4 + i / 4]);
  return r;
}

/// Which command's parameters a pname belongs to.
enum CountTable {
  kCountOf_material,
  kCountOf_light,
  kCountOf_light_model,
  kCountOf_point,
  kCountOf_texture,
  kCountOf_texture_environment,
  kCountOf_texture_generation,
  kCountOf_fog
};
/// How many values a parameter has; 0 for a name that the command does not know.
size_t count_of(CountTable table, GLenum pname);

/// Parameters of a command converted to float. Integers become colors where the parameter is one (2.7).
struct Parameters {
  GLfloat v[4];
  bool valid; // false: a scalar form was used for a parameter with several values
};
Parameters vector_parameters(CountTable table, GLenum pname, const GLint* values);
Parameters vector_parameters(CountTable table, GLenum pname, const GLdouble* values);
Parameters scalar_parameter(CountTable table, GLenum pname, float value);

} // namespace softgl
