// Set-up of antialiased points, lines and polygons (GL 1.5, 3.3.1, 3.4.4, 3.5.6).
#pragma once

#include "base/arena.h"
#include "draw/draw_record.h"
#include "shaders/raster/raster_draw.h"

namespace softgl {

/// Fills in what draws the antialiased primitives of the draw.
void add_smooth_draws(const DrawRecord& draw, RasterDraw& raster, Arena& arena);

/// False: the point covers nothing.
bool setup_smooth_point(const RasterDraw& draw, const ShadedVertices::Slot* corner, bool back,
                        RasterPrimitive& out);

/// The corners of the rectangle that an antialiased line is: two at each end. Their slots are those of the
/// line's ends, and the coverage numbers behind them. A line without length covers nothing: all its fragments
/// have the coverage 0.
void smooth_line_corners(const RasterDraw& draw, const ShadedVertices::Slot* const end[2], Arena& arena,
                         const ShadedVertices::Slot* corner[4]);

/// The corners of a triangle in 1/256 pixel, in the order of set-up.
struct SmoothTriangle {
  int32_t x[3], y[3];
  bool negative; // area; corners 0 and 1 are exchanged
};
/// False: it covers nothing or is culled.
bool snap_smooth_triangle(const RasterDraw& draw, const ShadedVertices::Slot* const corner[3],
                          SmoothTriangle& out);
/// Lets a triangle that is set up take in all pixels whose squares it touches, across the edges that are not
/// inner ones (bit k: that from corner k to the next, before they were exchanged).
void widen_smooth_triangle(const RasterDraw& draw, const SmoothTriangle& triangle, uint32_t inner,
                           RasterPrimitive& out);

} // namespace softgl
