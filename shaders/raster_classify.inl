// Facing, culling, boxes and coverage of small triangles, lane = triangle. As OSMesa 22.3.6 computes: from positions
// snapped to 1/256 pixel.
#pragma once

#include "raster_triangles.h"
#include "simd.h"

namespace softgl {
namespace SOFTGL_ISA {

/// Coordinates up to 65536 pixels are rasterized; a viewport lies well inside. Beyond (or not a number): dropped.
constexpr float kMaxSnapped = 16777216.0f;

/// Rounds (v - 0.5) * 256 to nearest even.
SOFTGL_INLINE FloatV snap_scaled(FloatV v) { return (v - 0.5f) * 256.0f; }

/// Unsigned, because in lanes whose triangle does not fit the sums wrap.
struct EdgeV {
  UintV c, a, b; // inside iff c - 256 * a * dx + 256 * b * dy >= 0; a and b are kept times 256
};
SOFTGL_INLINE EdgeV edge_of(IntV xi, IntV yi, IntV xj, IntV yj) {
  EdgeV e;
  const IntV a = yi - yj, b = xi - xj;
  const IntV included = (a < 0) | ((a == 0) & (b < 0)); // all ones: centres on the edge are inside
  e.c = (UintV)multiply(a, xi) - (UintV)multiply(b, yi) - 1 - (UintV)included;
  e.a = (UintV)a << 8, e.b = (UintV)b << 8;
  return e;
}

/// The part of a box's pixels (bit 8 * dy + dx) that columns 0 .. w and rows 0 .. h have.
SOFTGL_INLINE uint64_t box_pixels(int32_t w, int32_t h) {
  return ((uint64_t(0xff) >> (7 - w)) * 0x0101010101010101u) & (~uint64_t(0) >> (8 * (7 - h)));
}

/// Sorts out the triangles of a batch that can be seen, small and large; finds the pixels of the small ones.
static void classify_triangles(const RasterDraw& draw, const TriangleInput& in, TriangleOutput& out) {
  const RasterConstants& r = *draw.raster;
  out.small = out.large = out.cut = out.negative = 0;
  for (int base = 0; base < in.count; base += kWidth) {
    const int lanes = in.count - base < kWidth ? in.count - base : kWidth;
    IntV x[3], y[3];
    IntV valid = splat(-1);
    for (int k = 0; k < 3; ++k) {
      const float* place[kWidth];
      if (lanes == kWidth)
        for (int i = 0; i < kWidth; ++i) place[i] = in.corner[k][base + i]->v;
      else
        for (int i = 0; i < kWidth; ++i) place[i] = in.corner[k][base + (i < lanes ? i : 0)]->v;
      FloatV p[4];
      load_transposed(place, p);
      const FloatV sx = snap_scaled(p[0]), sy = snap_scaled(p[1]);
      valid &= (sx < kMaxSnapped) & (sx > -kMaxSnapped) & (sy < kMaxSnapped) & (sy > -kMaxSnapped);
      x[k] = round_to_int(sx) & valid, y[k] = round_to_int(sy) & valid; // no sums of lanes that are out of range
    }
    const IntV min_x = min_(min_(x[0], x[1]), x[2]), max_x = max_(max_(x[0], x[1]), x[2]);
    const IntV min_y = min_(min_(y[0], y[1]), y[2]), max_y = max_(max_(y[0], y[1]), y[2]);
    const IntV whole_px0 = (min_x + 255) >> 8, whole_px1 = (max_x - 1) >> 8, whole_py0 = (min_y >> 8) + 1, whole_py1 = max_y >> 8;
    const IntV px0 = max_(whole_px0, splat(r.x0)), px1 = min_(whole_px1, splat(r.x1 - 1));
    const IntV py0 = max_(whole_py0, splat(r.y0)), py1 = min_(whole_py1, splat(r.y1 - 1));
    const IntV w = px1 - px0, h = py1 - py0;
    valid &= (w >= 0) & (h >= 0);
    uint32_t alive = sign_bits(valid) & ((lanes == 32 ? 0u : 1u << lanes) - 1u);
    if (alive == 0) continue;

    // 32 bits hold the area, and edge functions relative to the box, of triangles up to 64 pixels wide and high.
    const IntV extent_fits = ((max_x - min_x) < (1 << 14)) & ((max_y - min_y) < (1 << 14));
    // Where they are larger it may wrap, which only unsigned numbers may do.
    const IntV area = (IntV)((UintV)multiply(x[0] - x[1], y[2] - y[0]) - (UintV)multiply(x[2] - x[0], y[0] - y[1]));
    IntV negative = area < 0;
    const IntV positive = area > 0;
    IntV kept = (negative & splat(r.cull & 2 ? 0 : -1)) | (positive & splat(r.cull & 1 ? 0 : -1));
    uint32_t wide = alive & ~sign_bits(extent_fits);
    alive &= sign_bits(kept) | wide;
    uint32_t negative_bits = sign_bits(negative);
    if (wide) {
      alignas(64) int32_t ax[3][kWidth], ay[3][kWidth];
      for (int k = 0; k < 3; ++k) store(ax[k], x[k]), store(ay[k], y[k]);
      for (uint32_t bits = wide; bits; bits &= bits - 1) {
        const int i = __builtin_ctz(bits);
        const int64_t exact = int64_t(ax[0][i] - ax[1][i]) * (ay[2][i] - ay[0][i]) -
                              int64_t(ax[2][i] - ax[0][i]) * (ay[0][i] - ay[1][i]);
        const bool culled = exact == 0 || (exact > 0 ? r.cull & 1 : r.cull & 2);
        if (culled) alive &= ~(1u << i);
        negative_bits = (negative_bits & ~(1u << i)) | (exact < 0 ? 1u << i : 0u);
      }
    }
    if (alive == 0) continue;
    const IntV fits = extent_fits & (w < kSmallBox) & (h < kSmallBox);
    uint32_t small = draw.small ? alive & sign_bits(fits) : 0;
    const uint32_t large = alive & ~small;
    const uint32_t cut = small & sign_bits((w >= kBlockBox) | (h >= kBlockBox)), whole = small & ~cut;

    if (small) {
      const IntV zero = IntV{}, mine = mask_of_bits(whole);
      const IntV origin_x = px0 << 8, origin_y = py0 << 8;
      const IntV x0 = choose(negative, x[1], x[0]) - origin_x, y0 = choose(negative, y[1], y[0]) - origin_y;
      const IntV x1 = choose(negative, x[0], x[1]) - origin_x, y1 = choose(negative, y[0], y[1]) - origin_y;
      const IntV x2 = x[2] - origin_x, y2 = y[2] - origin_y;
      EdgeV e0 = edge_of(x0, y0, x1, y1), e1 = edge_of(x1, y1, x2, y2), e2 = edge_of(x2, y2, x0, y0);
      if (cut) {
        const EdgeV* const edge[3] = {&e0, &e1, &e2};
        for (int k = 0; k < 3; ++k)
          store(out.edge_c[k] + base, (IntV)edge[k]->c), store(out.edge_a[k] + base, (IntV)edge[k]->a), store(out.edge_b[k] + base, (IntV)edge[k]->b);
        store(out.last_column + base, w), store(out.last_row + base, h);
      }
      int columns = whole != 0, rows = whole != 0;
      while (columns < kBlockBox && sign_bits((w >= columns) & mine)) ++columns;
      while (rows < kBlockBox && sign_bits((h >= rows) & mine)) ++rows;
      IntV mask[2] = {zero, zero};
      for (int dy = 0; dy < rows; ++dy) {
        UintV r0 = e0.c, r1 = e1.c, r2 = e2.c;
        UintV bits = UintV{}; // bit dx, counted from the top
        for (int dx = 0; dx < columns; ++dx) {
          bits = (bits >> 1) | (~(r0 | r1 | r2) & 0x80000000u);
          r0 -= e0.a, r1 -= e1.a, r2 -= e2.a;
        }
        mask[dy >> 2] |= (IntV)((bits >> (32 - columns)) << (8 * (dy & 3)));
        e0.c += e0.b, e1.c += e1.b, e2.c += e2.b;
      }
      store(out.rows0to3 + base, mask[0]), store(out.rows4to7 + base, mask[1]);
      // Edges accept nothing outside the box of the triangle, but they know of no scissor box.
      const IntV clipped = (px1 != whole_px1) | (py1 != whole_py1);
      for (uint32_t bits = whole & sign_bits(clipped); bits; bits &= bits - 1) {
        const int i = __builtin_ctz(bits);
        const uint64_t box = box_pixels(w[i], h[i]);
        out.rows0to3[base + i] &= uint32_t(box), out.rows4to7[base + i] &= uint32_t(box >> 32);
      }
      small &= cut | ~sign_bits((load(out.rows0to3 + base) | load(out.rows4to7 + base)) == zero);
      store(out.position + base, (py0 << 16) + px0);
      store(out.tile + base, multiply(py0 >> 6, splat(in.tiles_x)) + (px0 >> 6));
    }
    out.small |= uint64_t(small) << base, out.large |= uint64_t(large) << base, out.cut |= uint64_t(cut) << base;
    out.negative |= uint64_t(negative_bits) << base;
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
