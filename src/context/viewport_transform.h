// From normalized device coordinates to the window (GL 1.5, 2.11.1; GL_ARB_clip_control, 13.6).
#pragma once

#include "context/state.h"

namespace softgl {

/// window = coordinate * scale + offset; y up. The order of operations is OSMesa's.
struct ViewportTransform {
  float scale[3], offset[3];
};

inline bool depths_from_zero(const State& s) { return s.clip_control.depth_mode == GL_ZERO_TO_ONE; }

inline ViewportTransform viewport_transform(const State& s) {
  const ViewportState& v = s.viewport;
  const float half_width = 0.5f * float(v.width), half_height = 0.5f * float(v.height);
  const bool upside_down = s.clip_control.origin == GL_UPPER_LEFT;
  ViewportTransform t{{half_width, upside_down ? -half_height : half_height, 0},
                      {half_width + float(v.x), half_height + float(v.y), 0}};
  if (depths_from_zero(s)) {
    t.scale[2] = float(v.far_depth - v.near_depth);
    t.offset[2] = float(v.near_depth);
  } else {
    t.scale[2] = float(0.5 * (v.far_depth - v.near_depth));
    t.offset[2] = float(0.5 * (v.near_depth + v.far_depth));
  }
  return t;
}

/// Whether polygons whose vertices go counter-clockwise in the window, y up, are front-facing: an origin
/// above turns the sign of the area round (GL_ARB_clip_control, 14.6.1).
inline bool counter_clockwise_is_front(const State& s) {
  return (s.polygon.front_face == GL_CCW) == (s.clip_control.origin == GL_LOWER_LEFT);
}

} // namespace softgl
