// Set-up of lines of any width.
#pragma once

#include "shaders/raster/raster_draw.h"

namespace softgl {

/// A line without multisampling. Its body is a parallelogram: between its ends, in 1/256 of a pixel, half of
/// the width to both sides along the minor axis.
struct SnappedLine {
  int32_t ax, ay, bx, by; // a is the right end of an x-major line, the upper one of a y-major line
  int32_t half_width;
  bool x_major;
  float dx, dy, length2; // from the second vertex to the first, before the ends were snapped
};

/// False: the line covers nothing.
bool snap_line(const RasterConstants& r, const float* v1, const float* v2, SnappedLine& out);

/// False: the line covers nothing. `corner1` is the provoking vertex.
bool setup_line(const RasterDraw& draw, const ShadedVertices::Slot* corner0,
                const ShadedVertices::Slot* corner1, bool back, RasterPrimitive& out);

} // namespace softgl
