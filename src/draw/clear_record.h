// A glClear, as it waits in a frame.
#pragma once

#include <cstdint>

namespace softgl {

/// A glClear in the order of the frame. Values are already the numbers that the surface's format stores
/// (colors: 0-255, 0-65535, 5-6-5 bits or the floats themselves).
struct ClearRecord {
  bool color, depth, stencil;
  bool color_mask[4];
  float color_value[4];
  uint32_t depth_value, stencil_value, stencil_write_mask;
  int32_t x0, y0, x1, y1; // window, y down, half open: scissor box and surface intersected
};

} // namespace softgl
