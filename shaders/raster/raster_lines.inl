// Lines that are finished fragments before there are tiles.
#pragma once

#include "shaders/common/simd.h"
#include "shaders/fragment/fragment_pack.inl"
#include "shaders/raster/raster_draw.h"
#include "shaders/raster/raster_lines.h"

namespace softgl {
namespace SOFTGL_ISA {

/// Depths and colors of all lines, one behind the other; room for a vector behind the last.
static void shade_lines(const RasterDraw& draw, const LineSpan* line, int32_t count, uint32_t* depth,
                        uint32_t* color) {
  const float scale = depth_scale(draw.program->key);
  const bool flat = draw.varying[0].flat;
  FloatV lane;
  for (int i = 0; i < kWidth; ++i) lane[i] = float(i);
  for (const LineSpan* const end = line + count; line < end; ++line) {
    const FloatV first = splat(float(line->first)) + lane;
    for (int32_t i = 0; i < line->count; i += kWidth) {
      const FloatV m = first + float(i);
      auto value = [&](int k) __attribute__((always_inline)) { return line->step[k] * m + line->start[k]; };
      store(depth + i, depth_bits(value(0), scale));
      const FloatV r = flat ? splat(1.0f) : splat(1.0f) / value(1);
      const FloatV red = value(2) * r, green = value(3) * r, blue = value(4) * r;
      store(color + i,
            draw.opaque ? pack_opaque(red, green, blue) : pack_color(red, green, blue, value(5) * r));
    }
    depth += line->count, color += line->count;
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
