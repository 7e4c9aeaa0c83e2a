#include "geometry.h"

namespace softgl {

uint32_t assembly_steps(const PrimitiveRange& range) {
  const uint32_t n = range.count;
  switch (range.mode) {
  case GL_POINTS: return n;
  case GL_LINES: return n / 2;
  case GL_LINE_STRIP: return n < 2 ? 0 : n - 1;
  case GL_LINE_LOOP:
    // A loop that continues repeats its first vertex in front, for the closing line only.
    if (range.begins) return n < 2 ? 0 : n - 1 + range.ends;
    return n < 2 ? 0 : n - 2 + range.ends;
  case GL_TRIANGLES: return n / 3;
  case GL_TRIANGLE_STRIP:
  case GL_TRIANGLE_FAN:
  case GL_POLYGON: return n < 3 ? 0 : n - 2;
  case GL_QUADS: return n / 4;
  case GL_QUAD_STRIP: return n < 4 ? 0 : (n - 2) / 2;
  default: return 0;
  }
}

} // namespace softgl
