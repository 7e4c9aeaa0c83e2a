// Curves and surfaces for the tests of evaluators (5.1).
#pragma once

#include "special/scenes.h"

namespace softgl::suite {

/// The curve of vertices through the window; it is enabled.
void arch(Script& s, double from = 0, double to = 1);
/// Colors along the arch.
void arch_colors(Script& s);
/// A curved surface of vertices over the window, of order 4 in u and 3 in v; it is enabled.
void hill(Script& s, double u1 = 0, double u2 = 1, double v1 = 0, double v2 = 1);
/// Colors over the hill, of order 2 in both directions.
void hill_colors(Script& s);

} // namespace softgl::suite
