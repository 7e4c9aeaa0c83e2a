// Facing, culling, boxes, coverage of small triangles (lane = triangle) and attribute planes.
// All of it as OSMesa 22.3.6 computes: positions snapped to 1/256 pixel for coverage, unsnapped for planes.
#pragma once

#include "raster_triangles.h"
#include "simd.h"

namespace softgl {
namespace SOFTGL_ISA {

/// Coordinates up to 65536 pixels are rasterized; a viewport lies well inside. Beyond (or not a number): dropped.
constexpr float kMaxSnapped = 16777216.0f;

/// Deltas of the corners' window positions, scaled by 1 / area; the base of every plane.
struct PlaneBasis {
  FloatV dx01, dy01, dx20, dy20, x0, y0; // x0, y0: corner 0 minus half a pixel
  FloatV inverse_area, raw_dx01, raw_dy01, raw_dx20, raw_dy20;
};

SOFTGL_INLINE PlaneBasis plane_basis(const FloatV p0[4], const FloatV p1[4], const FloatV p2[4]) {
  PlaneBasis b;
  b.raw_dx01 = p0[0] - p1[0], b.raw_dy01 = p0[1] - p1[1];
  b.raw_dx20 = p2[0] - p0[0], b.raw_dy20 = p2[1] - p0[1];
  const FloatV r = splat(1.0f) / (b.raw_dx01 * b.raw_dy20 - b.raw_dy01 * b.raw_dx20);
  b.inverse_area = r;
  b.dx01 = b.raw_dx01 * r, b.dy01 = b.raw_dy01 * r;
  b.dx20 = b.raw_dx20 * r, b.dy20 = b.raw_dy20 * r;
  b.x0 = p0[0] - 0.5f, b.y0 = p0[1] - 0.5f;
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

/// max(|dz/dx|, |dz/dy|) * factor + units.
SOFTGL_INLINE FloatV depth_offset(const PlaneBasis& b, FloatV z0, FloatV z1, FloatV z2, const RasterConstants& r) {
  const FloatV dz01 = z0 - z1, dz20 = z2 - z0;
  const IntV absolute = splat(0x7fffffff);
  const FloatV zx = (FloatV)((IntV)((dz20 * b.raw_dy01 - b.raw_dy20 * dz01) * b.inverse_area) & absolute);
  const FloatV zy = (FloatV)((IntV)((b.raw_dx20 * dz01 - dz20 * b.raw_dx01) * b.inverse_area) & absolute);
  const FloatV steepest = choose(~(zx <= zy), zx, zy);
  return splat(r.offset_units) + steepest * r.offset_factor;
}

SOFTGL_INLINE float depth_scale(const FragmentKey& key) {
  return key.depth_format == uint64_t(DepthFormat::Z16) ? 65535.0f : 16777215.0f;
}
SOFTGL_INLINE IntV depth_bits(FloatV z, float scale) { return round_to_int(unit_range(z) * scale); }
SOFTGL_INLINE IntV color_byte(FloatV c) { return round_to_int(unit_range(c) * 255.0f); }
#if defined(__AVX2__) && !defined(__AVX512F__)
/// Saturating packs clamp below: not a number and everything too negative become the most negative integer, then 0.
SOFTGL_INLINE IntV pack_color(FloatV r, FloatV g, FloatV b, FloatV a) {
  const FloatV one = splat(1.0f);
  const IntV ri = round_to_int(min_(one, r) * 255.0f), gi = round_to_int(min_(one, g) * 255.0f);
  const IntV bi = round_to_int(min_(one, b) * 255.0f), ai = round_to_int(min_(one, a) * 255.0f);
  const __m256i rg = _mm256_packs_epi32((__m256i)ri, (__m256i)gi), ba = _mm256_packs_epi32((__m256i)bi, (__m256i)ai);
  const __m256i planes = _mm256_packus_epi16(rg, ba); // r0-3 g0-3 b0-3 a0-3, then the same of lanes 4-7
  const __m256i order = _mm256_set_epi8(15, 11, 7, 3, 14, 10, 6, 2, 13, 9, 5, 1, 12, 8, 4, 0, 15, 11, 7, 3, 14, 10, 6, 2, 13, 9, 5, 1, 12, 8, 4, 0);
  return (IntV)_mm256_shuffle_epi8(planes, order);
}
#else
SOFTGL_INLINE IntV pack_color(FloatV r, FloatV g, FloatV b, FloatV a) {
  return color_byte(r) | (color_byte(g) << 8) | (color_byte(b) << 16) | (color_byte(a) << 24);
}
#endif

/// Rounds (v - 0.5) * 256 to nearest even.
SOFTGL_INLINE FloatV snap_scaled(FloatV v) { return (v - 0.5f) * 256.0f; }

struct EdgeV {
  IntV c, a, b; // inside iff c - 256 * a * dx + 256 * b * dy >= 0; a and b are kept times 256
};
SOFTGL_INLINE EdgeV edge_of(IntV xi, IntV yi, IntV xj, IntV yj) {
  EdgeV e;
  const IntV a = yi - yj, b = xi - xj;
  const IntV included = (a < 0) | ((a == 0) & (b < 0)); // all ones: centres on the edge are inside
  e.c = multiply(a, xi) - multiply(b, yi) - 1 - included;
  e.a = a << 8, e.b = b << 8;
  return e;
}

/// The pixels (bit 8 * dy + dx) of a box of w + 1 by h + 1.
SOFTGL_INLINE uint64_t small_box_mask(int32_t w, int32_t h) {
  return ((uint64_t(0xff) >> (7 - w)) * 0x0101010101010101u) & (~uint64_t(0) >> (8 * (7 - h)));
}

/// Classifies a batch. Small triangles give their covered pixels in out.x, out.y, out.triangle.
static void classify_triangles(const RasterDraw& draw, const TriangleInput& in, TriangleOutput& out) {
  const RasterConstants& r = *draw.raster;
  out.fragment_count = out.large_count = 0;
  int32_t fragments = 0;
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
      x[k] = round_to_int(sx), y[k] = round_to_int(sy);
    }
    const IntV min_x = min_(min_(x[0], x[1]), x[2]), max_x = max_(max_(x[0], x[1]), x[2]);
    const IntV min_y = min_(min_(y[0], y[1]), y[2]), max_y = max_(max_(y[0], y[1]), y[2]);
    const IntV px0 = max_((min_x + 255) >> 8, splat(r.x0)), px1 = min_((max_x - 1) >> 8, splat(r.x1 - 1));
    const IntV py0 = max_((min_y >> 8) + 1, splat(r.y0)), py1 = min_(max_y >> 8, splat(r.y1 - 1));
    const IntV w = px1 - px0, h = py1 - py0;
    valid &= (w >= 0) & (h >= 0);
    uint32_t alive = sign_bits(valid) & ((lanes == 32 ? 0u : 1u << lanes) - 1u);
    if (alive == 0) continue;

    // 32 bits hold the area, and edge functions relative to the box, of triangles up to 64 pixels wide and high.
    const IntV extent_fits = ((max_x - min_x) < (1 << 14)) & ((max_y - min_y) < (1 << 14));
    const IntV area = multiply(x[0] - x[1], y[2] - y[0]) - multiply(x[2] - x[0], y[0] - y[1]);
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
    const IntV fits = extent_fits & (w < kSmallBox) & (h < kSmallBox) & (multiply(w + 1, h + 1) <= kSmallArea);
    uint32_t small = draw.small ? alive & sign_bits(fits) : 0;
    const uint32_t large = alive & ~small;

    alignas(64) int32_t upper[kWidth], lower[kWidth], wide_by[kWidth], high_by[kWidth], ox[kWidth], oy[kWidth];
    if (small) {
      const IntV zero = IntV{}, mine = mask_of_bits(small);
      const IntV origin_x = px0 << 8, origin_y = py0 << 8;
      const IntV x0 = choose(negative, x[1], x[0]) - origin_x, y0 = choose(negative, y[1], y[0]) - origin_y;
      const IntV x1 = choose(negative, x[0], x[1]) - origin_x, y1 = choose(negative, y[0], y[1]) - origin_y;
      const IntV x2 = x[2] - origin_x, y2 = y[2] - origin_y;
      EdgeV e0 = edge_of(x0, y0, x1, y1), e1 = edge_of(x1, y1, x2, y2), e2 = edge_of(x2, y2, x0, y0);
      int columns = 1, rows = 1;
      while (columns < kSmallBox && sign_bits((w >= columns) & mine)) ++columns;
      while (rows < kSmallBox && sign_bits((h >= rows) & mine)) ++rows;
      IntV mask[2] = {zero, zero};
      for (int dy = 0; dy < rows; ++dy) {
        IntV r0 = e0.c, r1 = e1.c, r2 = e2.c;
        UintV bits = UintV{}; // bit dx, counted from the top
        for (int dx = 0; dx < columns; ++dx) {
          bits = (bits >> 1) | ((UintV)~(r0 | r1 | r2) & 0x80000000u);
          r0 -= e0.a, r1 -= e1.a, r2 -= e2.a;
        }
        mask[dy >> 2] |= (IntV)((bits >> (32 - columns)) << (8 * (dy & 3)));
        e0.c += e0.b, e1.c += e1.b, e2.c += e2.b;
      }
      small &= ~sign_bits((mask[0] | mask[1]) == zero);
      store(upper, mask[0]), store(lower, mask[1]);
      store(wide_by, w), store(high_by, h);
      store(ox, px0), store(oy, py0);
    }
    for (uint32_t bits = small | large; bits; bits &= bits - 1) {
      const int i = __builtin_ctz(bits);
      const uint32_t swapped = negative_bits >> i & 1;
      out.corner[base + i][0] = in.corner[swapped][base + i]->v;
      out.corner[base + i][1] = in.corner[swapped ^ 1][base + i]->v;
      out.corner[base + i][2] = in.corner[2][base + i]->v;
      out.back[base + i] = (r.back != 0) != (swapped != 0);
      if (large >> i & 1) {
        out.large[out.large_count++] = uint8_t(base + i);
        continue;
      }
      const int32_t left = ox[i], top = oy[i];
      for (uint64_t m = (uint64_t(uint32_t(lower[i])) << 32 | uint32_t(upper[i])) & small_box_mask(wide_by[i], high_by[i]); m; m &= m - 1) {
        const int bit = __builtin_ctzll(m);
        out.x[fragments] = left + (bit & 7);
        out.y[fragments] = top + (bit >> 3);
        out.triangle[fragments++] = uint8_t(base + i);
      }
    }
  }
  out.fragment_count = fragments;
}

/// Pointers to the corners of kWidth triangles.
struct CornerPlaces {
  const float* p[3][kWidth];
  bool back[kWidth];
};

SOFTGL_INLINE void find_corners(const TriangleOutput& batch, const uint8_t* triangle, CornerPlaces& c) {
  for (int i = 0; i < kWidth; ++i) {
    const int t = triangle[i];
    for (int k = 0; k < 3; ++k) c.p[k][i] = batch.corner[t][k];
    c.back[i] = batch.back[t];
  }
}

/// Loads slot `slot` (`back_slot` where the triangle is back-facing) of the three corners.
SOFTGL_INLINE void load_slot(const CornerPlaces& c, int slot, int back_slot, FloatV out[3][4]) {
  if (slot != back_slot) {
    const float* place[kWidth];
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < kWidth; ++i) place[i] = c.p[k][i] + 4 * (c.back[i] ? back_slot : slot);
      load_transposed(place, out[k]);
    }
    return;
  }
  for (int k = 0; k < 3; ++k) load_transposed(c.p[k], out[k], 4 * slot);
}

/// Sets up the large triangles of a batch: planes and edges into *record[i].
static void setup_triangles(const RasterDraw& draw, const TriangleOutput& batch, RasterPrimitive* const* record) {
  const RasterConstants& r = *draw.raster;
  alignas(64) float planes[kMaxPlanes][3][kWidth];
  alignas(64) float offset[kWidth];
  alignas(64) int32_t x[3][kWidth], y[3][kWidth];
  for (int32_t base = 0; base < batch.large_count; base += kWidth) {
    const int lanes = batch.large_count - base < kWidth ? batch.large_count - base : kWidth;
    uint8_t numbers[kWidth];
    for (int i = 0; i < kWidth; ++i) numbers[i] = batch.large[base + (i < lanes ? i : 0)];
    CornerPlaces c;
    find_corners(batch, numbers, c);
    FloatV p[3][4];
    load_slot(c, 0, 0, p);
    for (int k = 0; k < 3; ++k) {
      store(x[k], round_to_int(snap_scaled(p[k][0])));
      store(y[k], round_to_int(snap_scaled(p[k][1])));
    }
    const PlaneBasis basis = plane_basis(p[0], p[1], p[2]);
    store(offset, r.offset ? depth_offset(basis, p[0][2], p[1][2], p[2][2], r) : FloatV{});
    auto put = [&](int index, const PlaneV& v) {
      store(planes[index][0], v.a), store(planes[index][1], v.gx), store(planes[index][2], v.gy);
    };
    const FloatV w0 = p[0][3], w1 = p[1][3], w2 = p[2][3];
    put(kPlaneZ, plane_of(basis, p[0][2], p[1][2], p[2][2]));
    const PlaneV w = plane_of(basis, w0, w1, w2);
    put(kPlaneW, w);
    auto attributes = [&](const Varying& v) {
      FloatV a[3][4];
      load_slot(c, v.slot, v.back_slot, a);
      for (int k = 0; k < v.components; ++k) {
        const int channel = v.first + k;
        if (v.flat) put(v.plane + k, PlaneV{a[2][channel], FloatV{}, FloatV{}});
        else put(v.plane + k, plane_of(basis, a[0][channel] * w0, a[1][channel] * w1, a[2][channel] * w2));
      }
    };
    for (int i = 0; i < draw.varying_count; ++i) attributes(draw.varying[i]);
    for (int u = 0; u < kBlockTextureUnits; ++u)
      if (draw.unit_plane[u] >= 0) attributes(coordinates_of_unit(draw, u));
    for (int i = 0; i < lanes; ++i) {
      RasterPrimitive& q = *record[base + i];
      for (int k = 0; k < draw.plane_count; ++k) q.plane[k] = {planes[k][0][i], planes[k][1][i], planes[k][2][i]};
      q.w_is_one = q.plane[kPlaneW].a == 1.0f && q.plane[kPlaneW].gx == 0.0f && q.plane[kPlaneW].gy == 0.0f;
      q.depth_offset = offset[i];
      q.edges = 3;
      int32_t min_x = x[0][i], max_x = min_x, min_y = y[0][i], max_y = min_y;
      for (int k = 0; k < 3; ++k) {
        const int j = k == 2 ? 0 : k + 1;
        const int32_t ea = y[k][i] - y[j][i], eb = x[k][i] - x[j][i];
        const int64_t ec = int64_t(ea) * x[k][i] - int64_t(eb) * y[k][i] + ((ea < 0 || (ea == 0 && eb < 0)) ? 1 : 0);
        q.a[k] = ea, q.b[k] = eb, q.c[k] = (ec - 1) >> 8;
        min_x = x[k][i] < min_x ? x[k][i] : min_x, max_x = x[k][i] > max_x ? x[k][i] : max_x;
        min_y = y[k][i] < min_y ? y[k][i] : min_y, max_y = y[k][i] > max_y ? y[k][i] : max_y;
      }
      q.a[3] = q.b[3] = 0, q.c[3] = 0;
      const int32_t px0 = (min_x + 255) >> 8, px1 = ((max_x - 1) >> 8) + 1;
      const int32_t py0 = (min_y >> 8) + 1, py1 = (max_y >> 8) + 1;
      q.x0 = px0 > r.x0 ? px0 : r.x0, q.x1 = px1 < r.x1 ? px1 : r.x1;
      q.y0 = py0 > r.y0 ? py0 : r.y0, q.y1 = py1 < r.y1 ? py1 : r.y1;
    }
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
