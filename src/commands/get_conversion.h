// How a state value becomes the type that was asked for (GL 1.5, 6.1.2).
#pragma once

#include <cmath>

#include "context/state.h"

namespace softgl {

/// Normal values map linearly from [-1, 1] to all integers; Float ones are rounded. Uint says that the value
/// is unsigned and wants to be cut to the largest GLint.
enum class Conversion : uint8_t { Bool, Int, Uint, Enum, Float, Normal };

/// The nearest integer that the conversion asks for; what GLint cannot hold becomes its nearest end.
inline GLint to_integer(double value, Conversion conversion) {
  if (conversion == Conversion::Normal)
    value = std::trunc(value * 2147483647.0);
  else if (conversion == Conversion::Float)
    value = std::round(value);
  if (!(value > -2147483648.0)) return value != value ? 0 : INT32_MIN;
  if (value >= 2147483647.0) return INT32_MAX;
  return GLint(value);
}

/// The same of GetInteger64v (GL_ARB_sync, 6.1.2).
inline GLint64 to_integer64(double value, Conversion conversion) {
  constexpr double kEnd = 9223372036854775808.0;
  if (conversion == Conversion::Normal)
    value = std::trunc(value * kEnd);
  else if (conversion == Conversion::Float)
    value = std::round(value);
  if (!(value > -kEnd)) return value != value ? 0 : INT64_MIN;
  return value >= kEnd ? INT64_MAX : GLint64(value);
}

struct Context;
/// How many values glGet gives for a name; 0 if there is no such state.
int state_value_count(Context& context, GLenum pname);

} // namespace softgl
