// Set-up of what is a box of pixels: points of any size, point sprites, pixel rectangles.
#pragma once

#include "shaders/raster/raster_draw.h"

namespace softgl {

struct PixelRectangle; // frame/draw_record.h
struct WindowBox;      // draw/draw_call.h

/// False: the point covers nothing.
bool setup_point(const RasterDraw& draw, const ShadedVertices::Slot* corner, bool back, RasterPrimitive& out);

/// A box of pixels whose fragments all have the values of one vertex, but for `back`. False: it is empty.
bool setup_box(const RasterDraw& draw, const ShadedVertices::Slot* corner, const WindowBox& box,
               RasterPrimitive& out);

/// False: the rectangle covers nothing.
bool setup_rectangle(const RasterDraw& draw, const PixelRectangle& rectangle, RasterPrimitive& out);

} // namespace softgl
