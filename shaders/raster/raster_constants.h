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
  // Where pixels are looked at: at their centers, or, with multisampling, at sample points, which count from
  // the pixel's corner (sample_points.h).
  bool per_sample;
  uint8_t sample_mask;    // bit s: sample s may be written
  bool alpha_to_coverage; // samples are left out where alpha is small
  bool alpha_to_one;      // alpha becomes 1 before it is blended
  int32_t samples;        // of a pixel of the surface
  float pixel_center;     // 0.5, or 0: the origin of snapped positions and of planes in a pixel
  int32_t to_first_pixel; // 255, or 0: added to the least coordinate / 256 for the first pixel
  int32_t edge_shift;     // 8, or 0: how far the constant of an edge function is shifted
  bool offset_floats;     // the resolvable step depends on the primitive's largest depth
  float offset_units;     // units times the resolvable step; with offset_floats the units alone
  float offset_factor;
  float line_width, point_size;
  const uint64_t* stipple; // null, or the pattern of polygons: 4 x 4 blocks of 8x8 pixels, again and again
                           // from the surface's corner on
};

} // namespace softgl
