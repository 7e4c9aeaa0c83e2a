// Derives what the kernels need to know of a draw.
#pragma once

#include "base/arena.h"
#include "draw/draw_record.h"
#include "shaders/raster/raster_draw.h"

namespace softgl {

RasterDraw make_raster_draw(const DrawRecord& draw);

/// True when make_raster_draw() and the draws of antialiased primitives and of back faces are the same for
/// both; false where that takes long to find out.
bool have_same_raster_draw(const DrawRecord& a, const DrawRecord& b);

} // namespace softgl
