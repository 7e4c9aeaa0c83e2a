// Window positions on the grid of 1/256 pixel, on which OSMesa 22.3.6 finds coverage. Pixel centres are whole
// pixels.
#pragma once

#include "shaders/common/simd.h"
#include "shaders/raster/raster_triangles.h"

namespace softgl {
namespace SOFTGL_ISA {

/// Coordinates up to 65536 pixels are rasterized; a viewport lies well inside. Beyond (or not a number):
/// dropped.
constexpr float kMaxSnapped = 16777216.0f;

/// (v - 0.5) * 256, to be rounded to nearest even.
SOFTGL_INLINE FloatV snap_scaled(FloatV v) { return (v - 0.5f) * 256.0f; }

SOFTGL_INLINE IntV least(const IntV v[3]) { return min_(min_(v[0], v[1]), v[2]); }
SOFTGL_INLINE IntV greatest(const IntV v[3]) { return max_(max_(v[0], v[1]), v[2]); }

// The box of pixels that a triangle may cover: centres on its left and lower border are inside.
SOFTGL_INLINE IntV first_column(const IntV x[3]) { return (least(x) + 255) >> 8; }
SOFTGL_INLINE IntV last_column(const IntV x[3]) { return (greatest(x) - 1) >> 8; }
SOFTGL_INLINE IntV first_row(const IntV y[3]) { return (least(y) >> 8) + 1; }
SOFTGL_INLINE IntV last_row(const IntV y[3]) { return greatest(y) >> 8; }

} // namespace SOFTGL_ISA
} // namespace softgl
