// Which diagonal cuts the quadrilaterals of a draw.
#pragma once

#include "context/context.h"
#include "draw/draw_record.h"

namespace softgl {

/// Where GL_QUADS of the draw are cut (GL 1.5, 2.6.1 leaves it open): by the shade model, which is what
/// OSMesa does with most draws, or as OSMesa 22.3.6 does with this one.
Diagonal diagonal_of_quadrilaterals(const Context& c, const DrawCall& call, const FragmentProgram& program);

} // namespace softgl
