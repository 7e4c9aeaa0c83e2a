// Set-up of points of any size, and of point sprites.
#pragma once

#include "raster_draw.h"

namespace softgl {

/// False: the point covers nothing.
bool setup_point(const RasterDraw& draw, const ShadedVertices::Slot* corner, bool back, RasterPrimitive& out);

} // namespace softgl
