// Window positions on the grid of 1/256 pixel, on which OSMesa 22.3.6 finds coverage. Pixel centers are whole
// pixels.
#pragma once

#include "shaders/common/simd.h"
#include "shaders/raster/raster_triangles.h"

namespace softgl {
namespace SOFTGL_ISA {

/// Coordinates up to 65536 pixels are rasterized; a viewport lies well inside. Beyond (or not a number):
/// dropped.
constexpr float kMaxSnapped = 16777216.0f;

/// (v - center) * 256, to be rounded to nearest even.
SOFTGL_INLINE FloatV snap_scaled(FloatV v, float center = 0.5f) { return (v - center) * 256.0f; }

SOFTGL_INLINE IntV least(const IntV v[3]) { return min_(min_(v[0], v[1]), v[2]); }
SOFTGL_INLINE IntV greatest(const IntV v[3]) { return max_(max_(v[0], v[1]), v[2]); }

/// Which centers on level edges are inside. Where rows go down from the top of the window: those on lower
/// edges; where they go up: those on the edges of the first row. Both are the lower edges of GL.
struct EdgeRule {
  IntV flip;     // all ones: the sign of a level edge means the other thing
  IntV last_row; // 1 where centers on the last row's level edge are inside, else 0
  IntV to_first; // RasterConstants::to_first_pixel
  SOFTGL_MEMBER explicit EdgeRule(const RasterConstants& r)
      : flip(splat(r.top_edge_rule ? -1 : 0)), last_row(splat(r.top_edge_rule ? 0 : 1)),
        to_first(splat(r.to_first_pixel)) {}
};

/// All ones where centers on the edge (a, b) are inside.
SOFTGL_INLINE IntV edge_included(IntV a, IntV b, const EdgeRule& rule) {
  return (a < 0) | ((a == 0) & ((b ^ rule.flip) < 0));
}

// The box of pixels that a triangle may cover: centers on its left border are inside.
SOFTGL_INLINE IntV first_column(const IntV x[3], const EdgeRule& rule) {
  return (least(x) + rule.to_first) >> 8;
}
SOFTGL_INLINE IntV last_column(const IntV x[3]) { return (greatest(x) - 1) >> 8; }
SOFTGL_INLINE IntV first_row(const IntV y[3], const EdgeRule& rule) {
  return (least(y) + (rule.last_row + rule.to_first)) >> 8;
}
SOFTGL_INLINE IntV last_row(const IntV y[3], const EdgeRule& rule) {
  return (greatest(y) + (rule.last_row - 1)) >> 8;
}

} // namespace SOFTGL_ISA
} // namespace softgl
