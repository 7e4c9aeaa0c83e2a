// Clipping to the view volume and the planes of the user (2.12).
#pragma once

#include "expect/primitive.h"

namespace softgl::suite {

/// Whether the point is in the clip volume: points and raster positions. Throws std::logic_error if it lies
/// so near to a plane that a GL may decide either way.
bool is_inside(const State& state, const LitVertex& vertex);
/// Cuts the line to the clip volume; false if nothing is left.
bool clip_line(const State& state, LitVertex& a, LitVertex& b);
/// The part of a convex polygon in the clip volume; empty if nothing is left.
std::vector<LitVertex> clip_polygon(const State& state, std::vector<LitVertex> polygon);

} // namespace softgl::suite
