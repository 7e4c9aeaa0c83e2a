// What the operations on fragments share with those on the whole framebuffer (4.1, 4.2).
#pragma once

#include "expect/state.h"

namespace softgl::suite {

inline bool in_scissor(const ScissorState& s, int x, int y) { // 4.1.2
  return !s.test || (x >= s.box[0] && y >= s.box[1] && x < s.box[0] + s.box[2] && y < s.box[1] + s.box[3]);
}

/// Red, green, blue or alpha.
inline double component(const Vec4& color, int i) {
  return i == 0 ? color.x : i == 1 ? color.y : i == 2 ? color.z : color.w;
}

/// A color that is written: dithering takes one of the two nearest steps (4.1.9).
inline Interval dithered(const ColorBufferState& buffer, Interval color, double half_step) {
  return buffer.dither ? spec::clamped(spec::widened(color, half_step), 0, 1) : color;
}

} // namespace softgl::suite
