#include "geometry/line_stipple.h"

#include <cmath>
#include <cstring>

#include "shaders/fragment/fragment_program.h"
#include "shaders/raster/raster_constants.h"
#include "shaders/vertex/vertex_program.h"

namespace softgl {

LineStipple::LineStipple(const DrawRecord& draw, Arena& arena)
    : draw_(draw), arena_(arena), smooth_(draw.smooth && draw.smooth->line),
      pattern_(draw.vertex->stipple_pattern), factor_(draw.vertex->stipple_factor) {}

float LineStipple::length_of(const Slot* const end[2]) const {
  const float dx = std::fabs(end[0]->v[0] - end[1]->v[0]), dy = std::fabs(end[0]->v[1] - end[1]->v[1]);
  return smooth_ ? std::sqrt(dx * dx + dy * dy) : dx > dy ? dx : dy;
}

uint32_t LineStipple::steps_of(float length) const {
  // No line inside the view volume is longer than a few viewports.
  return length >= 0 && length < 1e6f ? uint32_t(std::ceil(length)) : 0;
}

void LineStipple::skip(const Slot* const end[2]) { counter_ += steps_of(length_of(end)); }

const LineStipple::Slot* LineStipple::between(float t, const Slot* const end[2]) {
  const ShadedLayout& l = draw_.layout;
  Slot* out = arena_.allocate_array<Slot>(l.slots);
  for (int s = 0; s < l.slots; ++s)
    for (int i = 0; i < 4; ++i) out[s].v[i] = end[0][s].v[i] + t * (end[1][s].v[i] - end[0][s].v[i]);
  if (draw_.raster->flat) { // GL 1.5, 2.14.7; OSMesa interpolates here
    if (l.color >= 0) out[l.color] = end[1][l.color];
    if (l.secondary >= 0) std::memcpy(out[l.secondary].v, end[1][l.secondary].v, sizeof(float[3]));
  }
  return out;
}

} // namespace softgl
