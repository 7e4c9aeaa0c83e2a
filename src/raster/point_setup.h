// Set-up of what is a box of pixels: points of any size, point sprites, pixel rectangles.
#pragma once

#include "shaders/raster/raster_draw.h"

namespace softgl {

struct PixelRectangle; // frame/draw_record.h

/// False: the point covers nothing.
bool setup_point(const RasterDraw& draw, const ShadedVertices::Slot* corner, bool back, RasterPrimitive& out);

/// False: the rectangle covers nothing.
bool setup_rectangle(const RasterDraw& draw, const PixelRectangle& rectangle, RasterPrimitive& out);

} // namespace softgl
