// Which way polygons go to the raster (GL 1.5, 3.5).
#pragma once

#include "context/state.h"

namespace softgl {

/// True where polygons are culled, colored and offset at their vertices before they come to the raster:
/// where not all are filled or they are stippled or antialiased, and, as in OSMesa 22.3.6, where points or
/// lines could be smooth or stippled.
inline bool polygons_before_raster(const State& s) {
  if (!s.polygon.all_filled() || s.polygon.stipple || s.polygon.smooth) return true;
  const bool staged = s.line.smooth || (s.point.smooth && !s.point.sprite) ||
                      (s.line.stipple && s.line.stipple_pattern != 0xffff);
  const bool changed = (s.lighting.enabled && s.lighting.two_side) || s.polygon.offset_fill ||
                       s.polygon.offset_line || s.polygon.offset_point;
  return staged && changed;
}

} // namespace softgl
