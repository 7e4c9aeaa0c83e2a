// Set-up of what is a box of pixels: points of any size, point sprites, pixel rectangles.
#pragma once

#include "draw/draw_call.h"
#include "shaders/raster/raster_draw.h"

namespace softgl {

struct PixelRectangle; // frame/draw_record.h

/// Where a point lies.
struct PointPlace {
  WindowBox box;     // of pixels that may change
  float size;        // 0 to 255 pixels
  int32_t width;     // in 1/256 pixel
  int32_t left, top; // in 1/256 pixel, of those that are squares of the exact size
};

/// False: the point covers nothing.
bool place_point(const RasterDraw& draw, const ShadedVertices::Slot* corner, PointPlace& out);

/// False: the point covers nothing.
bool setup_point(const RasterDraw& draw, const ShadedVertices::Slot* corner, bool back, RasterPrimitive& out);
/// The same of a point that place_point() has placed.
bool setup_placed_point(const RasterDraw& draw, const ShadedVertices::Slot* corner, const PointPlace& place,
                        bool back, RasterPrimitive& out);

/// A box of pixels whose fragments all have the values of one vertex, but for `back`. False: it is empty.
bool setup_box(const RasterDraw& draw, const ShadedVertices::Slot* corner, const WindowBox& box,
               RasterPrimitive& out);

/// False: the rectangle covers nothing.
bool setup_rectangle(const RasterDraw& draw, const PixelRectangle& rectangle, RasterPrimitive& out);

} // namespace softgl
