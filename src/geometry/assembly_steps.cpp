#include "geometry/geometry.h"

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

ElementRange elements_of_steps(const DrawRecord& draw, const PrimitiveRange& range, uint32_t first_step,
                               uint32_t step_count) {
  switch (range.mode) {
  case GL_POINTS: return {first_step, step_count};
  case GL_LINES: return {2 * first_step, 2 * step_count};
  case GL_LINE_STRIP: return {first_step, step_count + 1};
  case GL_TRIANGLES: return {3 * first_step, 3 * step_count};
  case GL_TRIANGLE_STRIP: return {first_step, step_count + 2};
  case GL_QUADS:
    if (draw.diagonal == Diagonal::Unclipped02) return {0, 0}; // asks for the vertices of the batch
    return {4 * first_step, 4 * step_count};
  default:
    return {0,
            0}; // hubs, closing lines; strips of quadrilaterals ask whether any of their vertices is clipped
  }
}

} // namespace softgl
