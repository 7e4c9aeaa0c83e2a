// Set-up of lines of any width.
#pragma once

#include "shaders/raster/raster_draw.h"

namespace softgl {

/// False: the line covers nothing. `corner1` is the provoking vertex.
bool setup_line(const RasterDraw& draw, const ShadedVertices::Slot* corner0,
                const ShadedVertices::Slot* corner1, bool back, RasterPrimitive& out);

} // namespace softgl
