// The pixels that a draw or a clear may change.
#pragma once

#include <algorithm>

#include "context/state.h"
#include "draw/draw_call.h"
#include "shaders/common/surface.h"

namespace softgl {

/// The surface, cut by the scissor box where the scissor test is enabled (GL 1.5, 4.1.2). The scissor box
/// counts from the bottom, and so do the rows of framebuffer objects (Surface::y_up), but not the window's.
inline WindowBox drawn_box(const ScissorState& scissor, const Surface& surface) {
  if (!scissor.enabled) return {0, 0, surface.width, surface.height};
  const int64_t left = scissor.x, right = left + scissor.width;
  const int64_t end =
      surface.y_up ? int64_t(scissor.y) + scissor.height : int64_t(surface.height) - scissor.y;
  const int64_t first = end - scissor.height;
  const auto within = [](int64_t v, int32_t end) { return int32_t(std::clamp<int64_t>(v, 0, end)); };
  return {within(left, surface.width), within(first, surface.height), within(right, surface.width),
          within(end, surface.height)};
}

} // namespace softgl
