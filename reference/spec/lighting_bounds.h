// The equations of lighting.h with intervals in place of numbers: what a correct implementation may give.
// A branch that the accuracy of 2.1.1 does not decide gives both of its results.
#pragma once

#include <span>

#include "interval.h"
#include "lighting.h"

namespace softgl::spec {

/// A light and where it is: the position divided by w, or the direction if `parameters.position.w` is 0.
struct LightBounds {
  Light parameters;
  Vec3Interval position, spot_direction; // eye coordinates
};

struct LitBounds {
  Interval primary[4], secondary[3]; // not clamped
};

/// c_pri and c_sec of 2.14.1, for GL's half vector and all terms. `vertex` is in eye coordinates, divided by
/// w.
LitBounds light_vertex_bounds(const LightModel& model, std::span<const LightBounds> lights,
                              const Material& material, Vec3Interval vertex, Vec3Interval normal);

} // namespace softgl::spec
