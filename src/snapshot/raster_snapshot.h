// From State to the constants of set-up and coverage.
#pragma once

#include "base/arena.h"
#include "shaders/raster/raster_constants.h"

namespace softgl {

struct Context;

/// Culling, offset, scissor and sizes as the context's state has them, in `arena`.
const RasterConstants* make_raster_constants(const Context& context, Arena& arena);

} // namespace softgl
