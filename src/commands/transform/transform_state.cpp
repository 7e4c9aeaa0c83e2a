// Viewport, depth range, clip control and user clip planes (GL 1.5, 2.11.1 and 2.12; GL_ARB_clip_control).
#include <algorithm>
#include <utility>

#include "commands/generated/commands.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"

namespace softgl::gl {

void Viewport(Context& c, GLint x, GLint y, GLsizei width, GLsizei height) {
  if (const char* wrong = first_wrong({{"width", width < 0}, {"height", height < 0}}))
    return SOFTGL_FAULT(negative_viewport_silent) ? void() : set_error(c, GL_INVALID_VALUE, wrong);
  if (SOFTGL_FAULT(viewport_outside_refused) && x < 0) return set_error(c, GL_INVALID_VALUE, "x");
  if (SOFTGL_FAULT(viewport_offset_ignored)) x = y = 0;
  // OSMesa 22.3.6 keeps the corner within its viewport bounds range.
  constexpr GLint kBounds = 32768;
  ViewportState& v = edit<&State::viewport>(c);
  v.x = std::clamp(x, -kBounds, kBounds - 1);
  v.y = std::clamp(y, -kBounds, kBounds - 1);
  v.width = SOFTGL_FAULT(viewport_not_clamped) ? width : std::min(width, kMaxViewportDimension);
  v.height = std::min(height, kMaxViewportDimension);
}

void DepthRange(Context& c, GLdouble n, GLdouble f) {
  const auto clamp = [](double v) { return v > 0.0 ? (v > 1.0 ? 1.0 : v) : 0.0; };
  ViewportState& v = edit<&State::viewport>(c);
  if (SOFTGL_FAULT(depth_range_ignored)) return;
  v.near_depth = SOFTGL_FAULT(depth_range_not_clamped) ? n : clamp(n);
  v.far_depth = SOFTGL_FAULT(depth_range_not_clamped) ? f : clamp(f);
  if (SOFTGL_FAULT(depth_range_sorted) && n > f) std::swap(v.near_depth, v.far_depth);
}

void ClipControl(Context& c, GLenum origin, GLenum depth) {
  if (const char* wrong =
          first_wrong({{"origin", origin != GL_LOWER_LEFT && origin != GL_UPPER_LEFT},
                       {"depth", depth != GL_NEGATIVE_ONE_TO_ONE && depth != GL_ZERO_TO_ONE}}))
    return set_error(c, GL_INVALID_ENUM, wrong);
  edit<&State::clip_control>(c) = {origin, depth};
}

void ClipPlane(Context& c, GLenum plane, const GLdouble* equation) {
  const GLenum i = plane - GL_CLIP_PLANE0;
  if (i >= GLenum(kMaxClipPlanes)) return set_error(c, GL_INVALID_ENUM, "plane");
  const Vec4 v{float(equation[0]), float(equation[1]), float(equation[2]), float(equation[3])};
  if (SOFTGL_FAULT(plane_not_transformed)) {
    edit<&State::transform>(c).clip_plane[i] = v;
    return;
  }
  if (SOFTGL_FAULT(plane_by_modelview)) {
    edit<&State::transform>(c).clip_plane[i] = c.matrices.modelview.top().m * v;
    return;
  }
  edit<&State::transform>(c).clip_plane[i] = transform_plane(v, inverse(c.matrices.modelview.top()));
}

void GetClipPlane(Context& c, GLenum plane, GLdouble* equation) {
  const GLenum i = plane - GL_CLIP_PLANE0;
  if (i >= GLenum(kMaxClipPlanes)) return set_error(c, GL_INVALID_ENUM, "plane");
  for (int k = 0; k < 4; ++k) equation[k] = c.state.transform.clip_plane[i][k];
}

} // namespace softgl::gl
