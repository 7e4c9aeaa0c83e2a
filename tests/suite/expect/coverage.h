// How much of a pixel's square a primitive covers (3.2). The specification lets a GL approximate it: what is
// known is that none of the square is covered, or all.
#pragma once

#include <vector>

#include "spec/vectors.h"

namespace softgl::suite {

enum class Coverage { None, Some, All };

/// Of the pixel (x, y) by a convex polygon in window coordinates, which may be off by `slack` pixels.
Coverage covered_by_polygon(const std::vector<spec::Vec3>& polygon, int x, int y, double slack);
/// The same by a circle.
Coverage covered_by_circle(const spec::Vec3& center, double radius, int x, int y, double slack);

} // namespace softgl::suite
