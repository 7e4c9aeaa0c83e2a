// Small triangles: shading with lane = fragment, planes in registers.
#pragma once

#include "fragment_interpolate.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Shades fragments [0, out.fragment_count) that classify_triangles found.
static void shade_small(const RasterDraw& draw, const TriangleInput& in, TriangleOutput& out, FragmentBlock& block) {
  const FragmentProgram& program = *draw.program;
  const RasterConstants& r = *draw.raster;
  const FragmentKey& key = program.key;
  const float scale = depth_scale(key);
  const int32_t count = out.fragment_count;
  for (int i = 0; i < kWidth; ++i) { // the last vector is filled up with copies of the first fragment
    out.x[count + i] = out.x[0], out.y[count + i] = out.y[0];
    out.triangle[count + i] = out.triangle[0];
  }
  for (int32_t first = 0; first < count; first += kLanes) {
    const int lanes = count - first < kLanes ? count - first : kLanes;
    for (int j = 0; j < lanes; j += kWidth) {
      const int32_t f = first + j;
      CornerPlaces c;
      find_corners(out, out.triangle + f, c);
      FloatV p[3][4], a[3][4];
      load_slot(c, 0, 0, p);
      const IntV px = load(out.x + f), py = load(out.y + f);
      const FloatV x = to_float(px), y = to_float(py);
      store(out.tile + f, multiply(py >> 6, splat(in.tiles_x)) + (px >> 6));
      store(out.pixel + f, ((py & 56) << 6) | ((px & 56) << 3) | ((py & 7) << 3) | (px & 7));
      const PlaneBasis basis = plane_basis(p[0], p[1], p[2]);
      FloatV z = value_at(plane_of(basis, p[0][2], p[1][2], p[2][2]), x, y);
      z += r.offset ? depth_offset(basis, p[0][2], p[1][2], p[2][2], r) : FloatV{};
      store(out.depth + f, depth_bits(z, scale));
      const FloatV w0 = p[0][3], w1 = p[1][3], w2 = p[2][3];
      const FloatV w = splat(1.0f) / value_at(plane_of(basis, w0, w1, w2), x, y);
      auto perspective = [&](FloatV a0, FloatV a1, FloatV a2) { return value_at(plane_of(basis, a0 * w0, a1 * w1, a2 * w2), x, y) * w; };
      for (int i = 0; i < draw.varying_count; ++i) {
        const Varying& v = draw.varying[i];
        load_slot(c, v.slot, v.back_slot, a);
        FloatV value[4];
        for (int k = 0; k < v.components; ++k) {
          const int channel = v.first + k;
          value[k] = v.flat ? a[2][channel] : perspective(a[0][channel], a[1][channel], a[2][channel]);
        }
        if (program.step_count == 0) store(out.color + f, pack_color(value[0], value[1], value[2], value[3]));
        else for (int k = 0; k < v.components; ++k) store(lanes_of(block, v, k) + j, value[k]);
      }
      if (program.step_count == 0) continue;
      for (int u = 0; u < kBlockTextureUnits; ++u) {
        if (draw.unit_plane[u] < 0) continue;
        load_slot(c, draw.layout.texcoord[u], draw.layout.texcoord[u], a);
        PlaneV q[4];
        for (int k = 0; k < 4; ++k) q[k] = plane_of(basis, a[0][k] * w0, a[1][k] * w1, a[2][k] * w2);
        interpolate_unit(block.unit[u], j, coordinates_read(program, u), plane_of(basis, w0, w1, w2), q, load(out.x + f), load(out.y + f));
      }
      store(block.x + j, load(out.x + f));
      store(block.y + j, load(out.y + f));
      store(block.depth + j, load(out.depth + f));
    }
    if (program.step_count == 0) continue;
    block.lanes = (lanes + kStripLanes - 1) & ~(kStripLanes - 1);
    for (int j = 0; j < kLanes; ++j) block.live[j] = j < lanes ? ~uint32_t(0) : 0;
    // Lanes past the last fragment hold values of an earlier block or copies: finite, as far as those are.
    if (program.keeps_primary) memcpy(block.primary, block.color, sizeof block.primary);
    for (int i = 0; i < program.step_count; ++i) program.step[i].stage(block, *program.constants, program.step[i].unit);
    for (int j = 0; j < lanes; j += kWidth) {
      store(out.color + first + j, pack_color(load(block.color[0] + j), load(block.color[1] + j), load(block.color[2] + j), load(block.color[3] + j)));
      store(out.live + first + j, load(block.live + j));
    }
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
