// A drawing as pixels.
#pragma once

#include "figure/drawing.h"

namespace softgl::cli {

// RGB on white, `scale` pixels for a unit. A picture keeps its pixels, from the one on that is nearest to its
// place.
Picture paint(const Drawing& drawing, double scale);

// The scale at which the drawing's pictures keep their size; 2 without pictures.
double natural_scale(const Drawing& drawing);

} // namespace softgl::cli
