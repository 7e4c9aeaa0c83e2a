// Attribute values at pixels: into a FragmentBlock, from the planes of one primitive.
#pragma once

#include "raster_setup.inl"

namespace softgl {
namespace SOFTGL_ISA {

SOFTGL_INLINE FloatV at(const Plane& p, FloatV x, FloatV y) { return splat(p.gy) * y + (splat(p.gx) * x + splat(p.a)); }

/// Left and right, upper and lower neighbours of each lane's 2x2 quad in a strip of 8x2 pixels.
SOFTGL_INLINE void quad_differences(const float* value, float* dx, float* dy) {
  for (int q = 0; q < 8; q += 2) {
    const float x = value[q + 1] - value[q], y = value[q + 8] - value[q];
    dx[q] = dx[q + 1] = dx[q + 8] = dx[q + 9] = x;
    dy[q] = dy[q + 1] = dy[q + 8] = dy[q + 9] = y;
  }
}

/// Fills the inputs of lanes [0, block.lanes); block.x and block.y are set.
static void interpolate_block(const RasterDraw& draw, const RasterPrimitive& p, FragmentBlock& block) {
  const FragmentProgram& program = *draw.program;
  for (int i = 0; i < block.lanes; i += kWidth) {
    const FloatV x = to_float(load(block.x + i)), y = to_float(load(block.y + i));
    const FloatV w = splat(1.0f) / at(p.plane[kPlaneW], x, y);
    const Plane* q = p.plane + kPlaneColor;
    if (p.flat) {
      for (int c = 0; c < 4; ++c) store(block.color[c] + i, splat(q[c].a));
    } else {
      for (int c = 0; c < 4; ++c) store(block.color[c] + i, at(q[c], x, y) * w);
    }
    if (draw.secondary_plane >= 0) {
      q = p.plane + draw.secondary_plane;
      for (int c = 0; c < 3; ++c) store(block.secondary[c] + i, p.flat ? splat(q[c].a) : at(q[c], x, y) * w);
    }
    if (draw.fog_plane >= 0) store(block.fog + i, at(p.plane[draw.fog_plane], x, y) * w);
    for (int u = 0; u < kBlockTextureUnits; ++u) {
      if (draw.unit_plane[u] < 0) continue;
      q = p.plane + draw.unit_plane[u];
      const FloatV rq = splat(1.0f) / (at(q[3], x, y) * w);
      BlockCoordinates& t = block.unit[u];
      store(t.s + i, (at(q[0], x, y) * w) * rq);
      store(t.t + i, (at(q[1], x, y) * w) * rq);
      store(t.r + i, (at(q[2], x, y) * w) * rq);
    }
  }
  for (int u = 0; u < kBlockTextureUnits; ++u) {
    if (draw.unit_plane[u] < 0) continue;
    BlockCoordinates& t = block.unit[u];
    for (int i = 0; i < block.lanes; i += kStripLanes) {
      quad_differences(t.s + i, t.ds_dx + i, t.ds_dy + i);
      quad_differences(t.t + i, t.dt_dx + i, t.dt_dy + i);
      quad_differences(t.r + i, t.dr_dx + i, t.dr_dy + i);
    }
  }
  if (program.keeps_primary) memcpy(block.primary, block.color, sizeof block.primary);
}

} // namespace SOFTGL_ISA
} // namespace softgl
