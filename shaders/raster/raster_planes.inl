// Attribute planes of triangles, lane = triangle. As OSMesa 22.3.6 computes: from positions that are not
// snapped.
#pragma once

#include "shaders/common/simd.h"
#include "shaders/fragment/fragment_pack.inl"
#include "shaders/raster/raster_triangles.h"

namespace softgl {
namespace SOFTGL_ISA {

/// Deltas of the corners' window positions, scaled by 1 / area; the base of every plane.
struct PlaneBasis {
  FloatV dx01, dy01, dx20, dy20, x0, y0; // x0, y0: corner 0 from the planes' origin
  FloatV inverse_area, raw_dx01, raw_dy01, raw_dx20, raw_dy20;
};

SOFTGL_INLINE PlaneBasis plane_basis(const FloatV p0[4], const FloatV p1[4], const FloatV p2[4],
                                     float center) {
  PlaneBasis b;
  b.raw_dx01 = p0[0] - p1[0], b.raw_dy01 = p0[1] - p1[1];
  b.raw_dx20 = p2[0] - p0[0], b.raw_dy20 = p2[1] - p0[1];
  const FloatV r = splat(1.0f) / (b.raw_dx01 * b.raw_dy20 - b.raw_dy01 * b.raw_dx20);
  b.inverse_area = r;
  b.dx01 = b.raw_dx01 * r, b.dy01 = b.raw_dy01 * r;
  b.dx20 = b.raw_dx20 * r, b.dy20 = b.raw_dy20 * r;
  b.x0 = p0[0] - center, b.y0 = p0[1] - center;
  return b;
}

struct PlaneV {
  FloatV a, gx, gy;
};

SOFTGL_INLINE PlaneV plane_of(const PlaneBasis& b, FloatV a0, FloatV a1, FloatV a2) {
  PlaneV p;
  const FloatV d01 = a0 - a1, d20 = a2 - a0;
  p.gx = d01 * b.dy20 - d20 * b.dy01;
  p.gy = d20 * b.dx01 - d01 * b.dx20;
  p.a = a0 - (p.gx * b.x0 + p.gy * b.y0);
  return p;
}

SOFTGL_INLINE FloatV value_at(const PlaneV& p, FloatV x, FloatV y) { return p.gy * y + (p.gx * x + p.a); }

/// What floats of depths up to `z` resolve: their exponent less the 23 bits of the mantissa, as a float.
SOFTGL_INLINE FloatV float_step(FloatV z) {
  return (FloatV)max_(((IntV)z & 0x7f800000) - (23 << 23), IntV{});
}

/// max(|dz/dx|, |dz/dy|) * factor + units.
SOFTGL_INLINE FloatV depth_offset(const PlaneBasis& b, FloatV z0, FloatV z1, FloatV z2,
                                  const RasterConstants& r) {
  const FloatV dz01 = z0 - z1, dz20 = z2 - z0;
  const IntV absolute = splat(0x7fffffff);
  const FloatV zx = (FloatV)((IntV)((dz20 * b.raw_dy01 - b.raw_dy20 * dz01) * b.inverse_area) & absolute);
  const FloatV zy = (FloatV)((IntV)((b.raw_dx20 * dz01 - dz20 * b.raw_dx01) * b.inverse_area) & absolute);
  const FloatV steepest = choose(~(zx <= zy), zx, zy);
  if (!r.offset_floats) return splat(r.offset_units) + steepest * r.offset_factor;
  const auto size = [&](FloatV z) { return (FloatV)((IntV)z & absolute); };
  return float_step(max_(max_(size(z0), size(z1)), size(z2))) * r.offset_units + steepest * r.offset_factor;
}

/// Triangles of a batch.
SOFTGL_INLINE void find_corners(const RasterDraw& draw, const TriangleInput& in, const TriangleOutput& batch,
                                const uint8_t* number, SmallTriangle triangle[kWidth]) {
  for (int i = 0; i < kWidth; ++i) {
    const int n = number[i], swapped = int(batch.negative >> n & 1);
    triangle[i] = {{in.corner[swapped][n], in.corner[swapped ^ 1][n], in.corner[2][n]},
                   draw.raster->back != swapped};
  }
}

/// The next kWidth of `count` triangles; if fewer are left these, and copies of the first of them, in
/// `padded`. Those behind them are fetched, which another processor may have shaded.
SOFTGL_INLINE const SmallTriangle* whole_group(const SmallTriangle* triangle, int32_t count,
                                               SmallTriangle padded[kWidth]) {
  if (count >= 2 * kWidth)
    for (int i = 0; i < kWidth; ++i)
      for (int k = 0; k < 3; ++k) __builtin_prefetch(triangle[kWidth + i].corner[k]);
  if (count >= kWidth) return triangle;
  for (int i = 0; i < kWidth; ++i) padded[i] = triangle[i < count ? i : 0];
  return padded;
}

/// Loads slot `slot` (`back_slot` where the triangle is back-facing) of the three corners of kWidth
/// triangles.
SOFTGL_INLINE void load_slot(const SmallTriangle* t, int slot, int back_slot, FloatV out[3][4]) {
  for (int k = 0; k < 3; ++k) {
    if (slot == back_slot)
      load_transposed(
          [&](int i) __attribute__((always_inline)) { return t[i].corner[k][slot].v; }, out[k]);
    else
      load_transposed(
          [&](int i)
              __attribute__((always_inline)) { return t[i].corner[k][t[i].back ? back_slot : slot].v; },
          out[k]);
  }
}

/// Planes made from the corners of each lane's triangle.
struct CornerPlanes {
  const SmallTriangle* triangle; // kWidth of them
  FloatV position[3][4], slot[3][4];
  PlaneBasis basis;

  /// `center`: RasterConstants::pixel_center.
  SOFTGL_MEMBER explicit CornerPlanes(const SmallTriangle* t, float center = 0.5f) : triangle(t) {
    load_slot(t, 0, 0, position);
    basis = plane_basis(position[0], position[1], position[2], center);
  }
  SOFTGL_MEMBER PlaneV z() const { return plane_of(basis, position[0][2], position[1][2], position[2][2]); }
  SOFTGL_MEMBER PlaneV w() const { return plane_of(basis, position[0][3], position[1][3], position[2][3]); }
  SOFTGL_MEMBER FloatV offset(const RasterConstants& r) const {
    return r.offset ? depth_offset(basis, position[0][2], position[1][2], position[2][2], r) : FloatV{};
  }
  SOFTGL_MEMBER IntV back() const {
    IntV v;
    for (int i = 0; i < kWidth; ++i) v[i] = -int32_t(triangle[i].back);
    return v;
  }
  /// To be called before the planes of a varying are asked for.
  SOFTGL_MEMBER void select(const Varying& v) { load_slot(triangle, v.slot, v.back_slot, slot); }
  SOFTGL_MEMBER PlaneV plane(const Varying& v, int component) const {
    const int k = v.first + component;
    if (v.flat) return {slot[2][k], FloatV{}, FloatV{}};
    return plane_of(basis, slot[0][k] * position[0][3], slot[1][k] * position[1][3],
                    slot[2][k] * position[2][3]);
  }
};

/// All planes of kWidth triangles in memory.
struct StoredPlanes {
  alignas(64) float plane[kMaxPlanes][3][kWidth];
  alignas(64) float offset[kWidth];
  alignas(64) int32_t back[kWidth];

  SOFTGL_MEMBER void put(int index, const PlaneV& v) {
    store(plane[index][0], v.a), store(plane[index][1], v.gx), store(plane[index][2], v.gy);
  }
};

static void store_planes(const RasterDraw& draw, CornerPlanes& p, StoredPlanes& out) {
  store(out.offset, p.offset(*draw.raster));
  store(out.back, p.back());
  out.put(kPlaneZ, p.z());
  out.put(kPlaneW, p.w());
  auto varying = [&](const Varying& v) {
    p.select(v);
    for (int k = 0; k < v.components; ++k) out.put(v.plane + k, p.plane(v, k));
  };
  for (int i = 0; i < draw.varying_count; ++i) varying(draw.varying[i]);
  for (int u = 0; u < kMaxTextureUnits; ++u)
    if (draw.unit_plane[u] >= 0) varying(coordinates_of_unit(draw, u));
}

} // namespace SOFTGL_ISA
} // namespace softgl
