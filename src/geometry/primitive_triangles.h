// The triangles of a primitive (GL 1.5, 2.6.1), with corners in the order that OSMesa 22.3.6 hands to set-up.
#pragma once

#include <cstdint>

#include "base/gl_types.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {

// Element number within the primitive -> vertex number.
struct NoIndices {
  uint32_t first;
  uint32_t operator[](uint32_t element) const { return first + element; }
};
template <class T> struct Indices {
  const T* index;
  uint32_t operator[](uint32_t element) const { return index[element]; }
};

/// Calls emit(triangle, v0, v1, v2) with the vertices of triangles 0, 1, ... n - 1 of steps [step, ...), v2
/// provoking; returns n. Two triangles a step for quadrilaterals.
template <class Elements, class Emit> int for_each_triangle(GLenum mode, bool from_1_to_3, bool right_first,
                                                            const Elements e, uint32_t step, uint32_t steps,
                                                            Emit emit) {
  const int n = int(steps);
  switch (mode) {
  case GL_TRIANGLES:
    for (int i = 0; i < n; ++i) {
      const uint32_t k = 3 * (step + uint32_t(i));
      emit(i, e[k], e[k + 1], e[k + 2]);
    }
    return n;
  case GL_TRIANGLE_STRIP:
    for (int i = 0; i < n; ++i) {
      const uint32_t k = step + uint32_t(i), odd = SOFTGL_FAULT(strip_not_turned) ? 0 : k & 1;
      emit(i, e[k + odd], e[k + 1 - odd], e[k + 2]);
    }
    return n;
  case GL_TRIANGLE_FAN:
    for (int i = 0; i < n; ++i) {
      const uint32_t k = step + uint32_t(i);
      emit(i, e[SOFTGL_FAULT(fan_is_strip) ? k : 0], e[k + 1], e[k + 2]);
    }
    return n;
  case GL_POLYGON:
    for (int i = 0; i < n; ++i) {
      const uint32_t k = step + uint32_t(i);
      emit(i, e[k + 1], e[k + 2], e[0]);
    }
    return n;
  case GL_QUADS:
    for (int i = 0; i < n; ++i) {
      const uint32_t k = 4 * (step + uint32_t(i));
      const uint32_t first = e[k], second = e[k + 1], third = e[k + 2], fourth = e[k + 3];
      emit(2 * i, first, second, from_1_to_3 ? fourth : third);
      emit(2 * i + 1, from_1_to_3 ? second : first, third, fourth);
    }
    return 2 * n;
  default: // GL_QUAD_STRIP
    for (int i = 0; i < n; ++i) {
      const uint32_t k = 2 * (step + uint32_t(i)), crossed = SOFTGL_FAULT(quad_strip_crossed);
      const uint32_t first = e[k], second = e[k + 1], third = e[k + 2 + crossed], fourth = e[k + 3 - crossed];
      if (right_first) emit(2 * i, first, second, fourth);
      emit(2 * i + right_first, third, first, fourth);
      if (!right_first) emit(2 * i + 1, first, second, fourth);
    }
    return 2 * n;
  }
}

/// The same where the first vertex provokes: it comes last, too, and the others keep their turn around it. Of
/// quadrilaterals it never does.
template <class Elements, class Emit>
int for_each_triangle_of_first(GLenum mode, const Elements e, uint32_t step, uint32_t steps, Emit emit) {
  const int n = int(steps);
  for (int i = 0; i < n; ++i) {
    const uint32_t k = step + uint32_t(i);
    switch (mode) {
    case GL_TRIANGLES: emit(i, e[3 * k + 1], e[3 * k + 2], e[3 * k]); break;
    case GL_TRIANGLE_STRIP: emit(i, e[k + 1 + (k & 1)], e[k + 2 - (k & 1)], e[k]); break;
    case GL_TRIANGLE_FAN: emit(i, e[k + 2], e[0], e[k + 1]); break;
    default: emit(i, e[k + 1], e[k + 2], e[0]); // GL_POLYGON
    }
  }
  return n;
}

} // namespace softgl
