// Lines as finished fragments: what the binner gives to the kernel that shades them.
#pragma once

#include <stdint.h>

namespace softgl {

constexpr int kLineValues = 6; // z, 1/w, and the color times 1/w

/// Pixels first .. of a line along its major axis. At the pixel m a value is step * m + start: its plane,
/// whose other gradient is 0. The pixels side by side in a wide line have the same values.
struct LineSpan {
  int32_t first, count;
  float start[kLineValues], step[kLineValues];
};

} // namespace softgl
