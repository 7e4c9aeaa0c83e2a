// What set-up and coverage need of the state: an immutable snapshot per draw.
#pragma once

#include <stdint.h>

namespace softgl {

struct RasterConstants {
  int32_t x0, y0, x1, y1; // pixels that may change: surface and scissor box intersected; its rows, half open
  uint8_t
      cull; // bit 0: positive areas (counter-clockwise where rows go down) are culled, bit 1: negative ones
  uint8_t back;   // 1: positive areas are back-facing, 0: negative ones are
  bool flat;      // corner 2's colors without interpolation
  bool two_sided; // the vertices carry back colors
  bool offset;    // polygon offset of filled polygons
  bool point_sprite;
  uint8_t sprite_units;   // texture units whose coordinates a point sprite replaces
  bool sprite_lower_left; // t is 0 at the last row
  bool top_edge_rule; // centers on a level edge are inside where it is the first row's, not the last one's
  bool offset_floats; // the resolvable step depends on the primitive's largest depth
  float offset_units; // units times the resolvable step; with offset_floats the units alone
  float offset_factor;
  float line_width, point_size;
  const uint64_t* stipple; // null, or the pattern of polygons: 4 x 4 blocks of 8x8 pixels, again and again
                           // from the surface's corner on
};

} // namespace softgl
