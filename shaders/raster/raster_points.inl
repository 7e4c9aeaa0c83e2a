// Points that are finished fragments before there are tiles.
#pragma once

#include "shaders/common/simd.h"
#include "shaders/fragment/fragment_pack.inl"
#include "shaders/raster/raster_draw.h"

namespace softgl {
namespace SOFTGL_ISA {

/// The planes of a point are constant: its color is that of the vertex, times and over w.
static void shade_points(const RasterDraw& draw, const ShadedVertices::Slot* const* corner, int32_t count,
                         uint32_t* depth, uint32_t* color) {
  const float scale = depth_scale(draw.program->key);
  const Varying& varying = draw.varying[0];
  for (int32_t first = 0; first < count; first += kWidth) {
    const int32_t last = count - first - 1;
    auto place = [&](int i) __attribute__((always_inline)) { return corner[first + (i < last ? i : last)]; };
    FloatV position[4], value[4];
    load_transposed(
        [&](int i) __attribute__((always_inline)) { return place(i)->v; }, position);
    load_transposed(
        [&](int i) __attribute__((always_inline)) { return place(i)[varying.slot].v; }, value);
    const FloatV w = position[3], rw = splat(1.0f) / w;
    if (!varying.flat)
      for (FloatV& v : value) v = v * w * rw;
    store(depth + first, depth_bits(position[2], scale));
    store(color + first, draw.opaque ? pack_opaque(value[0], value[1], value[2])
                                     : pack_color(value[0], value[1], value[2], value[3]));
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
