// Facing, culling and boxes of triangles, and the pixels of tiny ones, lane = triangle.
#pragma once

#include "shaders/raster/raster_snap.inl"
#include "shaders/raster/sample_points.h"

namespace softgl {
namespace SOFTGL_ISA {

/// Positions and boxes of a batch, for a second look at them.
struct SnappedBatch {
  alignas(64) int32_t x[3][kSetupBatch], y[3][kSetupBatch];            // corners
  alignas(64) int32_t column[kSetupBatch], row[kSetupBatch];           // the box's first pixel
  alignas(64) int32_t last_column[kSetupBatch], last_row[kSetupBatch]; // counted from there
};

/// Triangles of at most so many pixels a side are shaded side by side, larger ones by strips or blocks. Both
/// take the same time there, by measurement: with stages where triangles are 32 (vectors of 4), 34 (textures
/// that look for a level) or 48 pixels wide and high, without them at 14 to 16, or at 30 where words are
/// replaced. Those with stages were measured before interpolate_triangles(), which makes small ones faster.
/// With several samples strips are never faster: a million textured pixels in triangles 20, 27 and 35 pixels
/// wide and high take 40, 36 and 32 ms by strips, 31, 30 and 30 as small ones.
SOFTGL_INLINE int32_t small_box(const RasterDraw& draw) {
  const FragmentProgram& program = *draw.program;
  if (draw.raster->samples > 1) return kSmallBox;
  if (program.step_count) return kWidth == 4 || program.lod_units ? 32 : kSmallBox;
  return kWidth > 4 && draw.replaces_words ? 28 : 16;
}

/// Sorts out the triangles of a batch that can be seen, small and large.
static void classify_triangles(const RasterDraw& draw, const TriangleInput& in, SnappedBatch& batch,
                               TriangleOutput& out) {
  const RasterConstants& r = *draw.raster;
  out.small = out.large = out.negative = 0;
  const int32_t box = draw.small ? small_box(draw) : draw.drops_uncovered ? kSeenBox : 0;
  uint64_t beyond = 0; // small ones with more pixels a side than kTinyBox
  IntV box_pixels = IntV{};
  const EdgeRule rule(r);
  for (int base = 0; base < in.count; base += kWidth) {
    const int lanes = in.count - base < kWidth ? in.count - base : kWidth;
    IntV x[3], y[3];
    IntV valid = splat(-1);
    for (int k = 0; k < 3; ++k) {
      const ShadedVertices::Slot* const* corner = in.corner[k] + base;
      FloatV p[4];
      if (lanes == kWidth)
        load_transposed(
            [&](int i) __attribute__((always_inline)) { return corner[i]->v; }, p);
      else
        load_transposed(
            [&](int i) __attribute__((always_inline)) { return corner[i < lanes ? i : 0]->v; }, p);
      const FloatV sx = snap_scaled(p[0], r.pixel_center), sy = snap_scaled(p[1], r.pixel_center);
      valid &= (sx < kMaxSnapped) & (sx > -kMaxSnapped) & (sy < kMaxSnapped) & (sy > -kMaxSnapped);
      x[k] = round_to_int(sx) & valid,
      y[k] = round_to_int(sy) & valid; // no sums of lanes that are out of range
    }
    const IntV column = max_(first_column(x, rule), splat(r.x0)), row = max_(first_row(y, rule), splat(r.y0));
    const IntV w = min_(last_column(x), splat(r.x1 - 1)) - column,
               h = min_(last_row(y, rule), splat(r.y1 - 1)) - row;
    valid &= (w >= 0) & (h >= 0);
    uint32_t alive = sign_bits(valid) & ((lanes == 32 ? 0u : 1u << lanes) - 1u);
    if (alive == 0) continue;

    // 32 bits hold the area, and edge functions relative to the box, of triangles up to 64 pixels wide and
    // high.
    const IntV extent_fits = ((greatest(x) - least(x)) < (1 << 14)) & ((greatest(y) - least(y)) < (1 << 14));
    // Where they are larger it may wrap, which only unsigned numbers may do.
    const IntV area =
        (IntV)((UintV)multiply(x[0] - x[1], y[2] - y[0]) - (UintV)multiply(x[2] - x[0], y[0] - y[1]));
    const IntV negative = area<0, positive = area> 0;
    const IntV kept = (negative & splat(r.cull & 2 ? 0 : -1)) | (positive & splat(r.cull & 1 ? 0 : -1));
    const uint32_t wide = alive & ~sign_bits(extent_fits);
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
    const uint32_t small = alive & sign_bits(extent_fits & (w < box) & (h < box));
    if (small) {
      beyond |= uint64_t(small & sign_bits((w >= kTinyBox) | (h >= kTinyBox))) << base;
      box_pixels += multiply(w + 1, h + 1) & mask_of_bits(small);
      const IntV last_x = column + w, last_y = row + h;
      store(out.tile + base, multiply(row >> 6, splat(in.tiles_x)) + (column >> 6));
      store(out.further + base, (((column ^ last_x) >> 6 != 0) & 1) | (((row ^ last_y) >> 6 != 0) & 2));
      for (int k = 0; k < 3; ++k) store(batch.x[k] + base, x[k]), store(batch.y[k] + base, y[k]);
      store(batch.column + base, column), store(batch.row + base, row);
      store(batch.last_column + base, w), store(batch.last_row + base, h);
    }
    out.small |= uint64_t(small) << base, out.large |= uint64_t(alive & ~small) << base,
        out.negative |= uint64_t(negative_bits) << base;
  }
  int32_t sum = 0;
  for (int i = 0; i < kWidth; ++i) sum += box_pixels[i];
  out.tiny = !beyond && sum < in.tiny_pixels * __builtin_popcountll(out.small);
}

/// Unsigned, because in lanes that are not alive the sums may wrap.
struct EdgeV {
  UintV c, a, b; // inside iff c - 256 * a * dx + 256 * b * dy >= 0; a and b are kept times 256
};
SOFTGL_INLINE EdgeV edge_of(IntV xi, IntV yi, IntV xj, IntV yj, const EdgeRule& rule) {
  EdgeV e;
  const IntV a = yi - yj, b = xi - xj;
  const IntV included = edge_included(a, b, rule);
  e.c = (UintV)multiply(a, xi) - (UintV)multiply(b, yi) - 1 - (UintV)included;
  e.a = (UintV)a << 8, e.b = (UintV)b << 8;
  return e;
}

/// The part of a box's pixels (bit 8 * dy + dx) that columns 0 .. w and rows 0 .. h have.
SOFTGL_INLINE uint64_t box_pixels(int32_t w, int32_t h) {
  return ((uint64_t(0xff) >> (7 - w)) * 0x0101010101010101u) & (~uint64_t(0) >> (8 * (7 - h)));
}

/// Finds the pixels of the small triangles of a tiny batch: bit 8 * dy + dx of their boxes. Those without any
/// are small no more. Of pixels with samples one is enough.
static void cover_tiny(const RasterDraw& draw, const SnappedBatch& batch, int count, TriangleOutput& out) {
  const EdgeRule rule(*draw.raster);
  const uint64_t small_before = out.small;
  out.small = 0;
  for (int base = 0; base < count; base += kWidth) {
    constexpr uint64_t kAll = (uint64_t(1) << (kWidth - 1) << 1) - 1;
    const uint32_t small = uint32_t(small_before >> base & kAll);
    if (!small) continue;
    const IntV negative = mask_of_bits(uint32_t(out.negative >> base)), mine = mask_of_bits(small),
               zero = IntV{};
    const IntV column = load(batch.column + base), row = load(batch.row + base),
               w = load(batch.last_column + base), h = load(batch.last_row + base);
    IntV x[3], y[3];
    for (int k = 0; k < 3; ++k) x[k] = load(batch.x[k] + base), y[k] = load(batch.y[k] + base);
    // Edges accept nothing outside the box of the triangle, but they know of no scissor box.
    const IntV clipped = (column + w != last_column(x)) | (row + h != last_row(y, rule));
    for (int k = 0; k < 3; ++k) x[k] -= column << 8, y[k] -= row << 8;
    const IntV x0 = choose(negative, x[1], x[0]), y0 = choose(negative, y[1], y[0]),
               x1 = choose(negative, x[0], x[1]), y1 = choose(negative, y[0], y[1]);
    const EdgeV edge[3] = {edge_of(x0, y0, x1, y1, rule), edge_of(x1, y1, x[2], y[2], rule),
                           edge_of(x[2], y[2], x0, y0, rule)};
    int columns = 1, rows = 1;
    while (columns < kTinyBox && sign_bits((w >= columns) & mine)) ++columns;
    while (rows < kTinyBox && sign_bits((h >= rows) & mine)) ++rows;
    IntV mask[2] = {zero, zero};
    for (int sample = 0; sample < (draw.raster->per_sample ? kSamples : 1); ++sample) {
      UintV first[3];
      for (int k = 0; k < 3; ++k) {
        first[k] = edge[k].c;
        if (draw.raster->per_sample)
          first[k] += (UintV)((IntV)edge[k].b >> 8) * uint32_t(kSampleY[sample]) -
                      (UintV)((IntV)edge[k].a >> 8) * uint32_t(kSampleX[sample]);
      }
      for (int dy = 0; dy < rows; ++dy) {
        UintV r0 = first[0], r1 = first[1], r2 = first[2];
        UintV bits = UintV{}; // bit dx, counted from the top
        for (int dx = 0; dx < columns; ++dx) {
          bits = (bits >> 1) | (~(r0 | r1 | r2) & 0x80000000u);
          r0 -= edge[0].a, r1 -= edge[1].a, r2 -= edge[2].a;
        }
        mask[dy >> 2] |= (IntV)((bits >> (32 - columns)) << (8 * (dy & 3)));
        for (int k = 0; k < 3; ++k) first[k] += edge[k].b;
      }
    }
    store(out.rows0to3 + base, mask[0]), store(out.rows4to7 + base, mask[1]);
    for (uint32_t bits = small & sign_bits(clipped); bits; bits &= bits - 1) {
      const int i = __builtin_ctz(bits);
      const uint64_t box = box_pixels(w[i], h[i]);
      out.rows0to3[base + i] &= uint32_t(box), out.rows4to7[base + i] &= uint32_t(box >> 32);
    }
    const uint32_t none = sign_bits((load(out.rows0to3 + base) | load(out.rows4to7 + base)) == zero);
    store(out.position + base, (row << 16) + column);
    out.small |= uint64_t(small & ~none) << base;
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
