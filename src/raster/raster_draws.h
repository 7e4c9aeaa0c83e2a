// Derives what the kernels need to know of a draw.
#pragma once

#include "base/arena.h"
#include "draw/draw_record.h"
#include "shaders/raster/raster_draw.h"

namespace softgl {

RasterDraw make_raster_draw(const DrawRecord& draw);

} // namespace softgl
