// Which pixels small triangles cover in a tile: one span a row, lane = triangle. As OSMesa 22.3.6 computes:
// from positions snapped to 1/256 pixel.
#pragma once

#include "shaders/raster/raster_interpolate.inl"
#include "shaders/raster/sample_points.h"

namespace softgl {
namespace SOFTGL_ISA {

/// Where the pixels of kWidth small triangles are, listed triangle by triangle: bits 0-5 x, 6-11 y in the
/// tile, 12-15 the triangle.
struct SmallPixels {
  static constexpr int kMost = kWidth * kSmallBox * kSmallBox;
  alignas(64) uint16_t place[kMost + kSmallBox];
  int32_t end[kWidth]; // of each triangle's
};

/// The same where pixels have several samples; of each pixel the covered ones. Some have none.
struct SampledPixels : SmallPixels {
  alignas(64) uint16_t samples[kMost + kSmallBox];
};

/// pixel_in_tile() of the pixels at the places of SmallPixels.
SOFTGL_INLINE IntV pixels_in_tile(IntV place) {
  return (place & 0xe07) | ((place >> 3) & 0x38) | ((place << 3) & 0x1c0);
}
/// Makes lanes [lane, lane + kWidth) of the block those pixels, and sets the numbers of their triangles.
SOFTGL_INLINE void put_places(IntV place, const TileTarget& tile, int lane, int32_t* number_of,
                              FragmentBlock& block) {
  store(block.x + lane, (place & 63) + tile.x), store(block.y + lane, ((place >> 6) & 63) + tile.y);
  store(number_of + lane, place >> 12);
}

/// A side that bounds spans. With t = (value + 0.5) / a pixels up to floor(t) are inside, or, on the left,
/// from ceil(t) on: that is the test value - a * x >= 0 of whole numbers, since t is 1 / (2 |a|) > 2^-16 off
/// every integer, and its rounding errors are below 2^-16 up to 128.
struct SpanSide {
  IntV a, b, c;   // a point is inside where c - 256 a x + 256 b y >= 0
  FloatV inverse; // 1 / a

  /// value + 0.5 for the points (sample_x, sample_y) / 256 of the pixels of row `y`.
  SOFTGL_MEMBER FloatV value(IntV y, int sample_x, int sample_y) const {
    const IntV at_sample = c + multiply(b, splat(sample_y)) - multiply(a, splat(sample_x));
    return to_float((at_sample >> 8) + multiply(b, y)) + 0.5f;
  }
  SOFTGL_MEMBER FloatV step() const { return to_float(b); } // of the value from row to row
};

SOFTGL_INLINE SpanSide choose(IntV mask, const SpanSide& a, const SpanSide& b) {
  return {choose(mask, a.a, b.a), choose(mask, a.b, b.b), choose(mask, a.c, b.c),
          choose(mask, a.inverse, b.inverse)};
}

/// The edge from corner i to corner j of a triangle with positive area; `right` is set where it bounds the
/// right.
SOFTGL_INLINE SpanSide side_of(IntV xi, IntV yi, IntV xj, IntV yj, const EdgeRule& rule, IntV& right) {
  const IntV a = yi - yj, b = xi - xj;
  const IntV included = edge_included(a, b, rule);
  right = a >= 0;
  // All numbers are small: a side is at most 64 pixels long, and no more than that away from the tile. A
  // level side accepts or refuses the whole row.
  return {a, b, multiply(a, xi) - multiply(b, yi) - 1 - included,
          choose(a == 0, splat(128.0f), splat(1.0f) / to_float(a))};
}

constexpr int kRowPlaces = 16;

/// Spans by row and lane: the first pixel's place, and how many there are in the upper half. With several
/// samples also where, counted from the first pixel, those of each sample begin, and in the upper half end.
template <int Samples> struct Spans {
  alignas(64) uint32_t span[kSmallBox][kWidth];
  alignas(64) uint32_t part[Samples > 1 ? kSmallBox : 1][Samples][kWidth];
};

/// Puts the places of the spans of triangle `lane` behind each other from `next` on, a row as a whole: it has
/// at most `parts` times kRowPlaces pixels; `samples`: where those go, if there are several. Gives their end.
template <int Samples, class Parts> SOFTGL_INLINE uint16_t* list_rows(const Spans<Samples>& spans, int lane,
                                                                      int32_t rows, Parts parts,
                                                                      uint16_t* next, uint16_t* samples) {
  typedef uint16_t Row __attribute__((vector_size(2 * kRowPlaces)));
  constexpr int kTogether = kWidth == 4 ? 8 : 16; // comparisons of longer vectors GCC 12 takes apart
  typedef int16_t Columns __attribute__((vector_size(2 * kTogether)));
  constexpr Row kColumns = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  Columns column_numbers;
  memcpy(&column_numbers, &kColumns, sizeof column_numbers);
  // By eights: how many rows a triangle has is hard to predict.
  for (int32_t row = 0; row < rows; row += 8)
#pragma GCC unroll 8
    for (int32_t k = 0; k < 8; ++k) {
      const uint32_t s = spans.span[row + k][lane];
      for (int part = 0; part < parts; ++part) {
        const Row places = kColumns + uint16_t(s + uint32_t(part * kRowPlaces));
        memcpy(next + part * kRowPlaces, &places, sizeof places);
        if constexpr (Samples > 1)
          for (int first = part * kRowPlaces; first < (part + 1) * kRowPlaces; first += kTogether) {
            const Columns column = column_numbers + int16_t(first);
            Columns covered = {};
            for (int n = 0; n < Samples; ++n) {
              const uint32_t of_sample = spans.part[row + k][n][lane];
              covered |=
                  (column >= int16_t(of_sample)) & (column < int16_t(of_sample >> 16)) & int16_t(1 << n);
            }
            memcpy(samples + first, &covered, sizeof covered);
          }
      }
      next += s >> 16;
      if constexpr (Samples > 1) samples += s >> 16;
    }
  return next;
}

/// Lists the pixels of `count` triangles (at most kWidth, the other lanes repeat one of them); p: their
/// corners' positions. `samples`: with several samples of a pixel those that are covered.
template <int Samples> static void list_pixels(const RasterConstants& r, const TileTarget& tile,
                                               const FloatV p[3][4], int count, SmallPixels& out,
                                               uint16_t* samples) {
  IntV x[3], y[3];
  for (int k = 0; k < 3; ++k) {
    x[k] = round_to_int(snap_scaled(p[k][0], r.pixel_center)) - 256 * tile.x;
    y[k] = round_to_int(snap_scaled(p[k][1], r.pixel_center)) - 256 * tile.y;
  }
  auto within = [](int32_t v, int32_t most) { return v < 0 ? 0 : v < most ? v : most; };
  const int32_t left = within(r.x0 - tile.x, kTileSize), top = within(r.y0 - tile.y, kTileSize);
  const int32_t right = within(r.x1 - tile.x, kTileSize), bottom = within(r.y1 - tile.y, kTileSize);
  const EdgeRule rule(r);
  const IntV first = max_(first_row(y, rule), splat(top)), last = min_(last_row(y, rule), splat(bottom - 1));

  IntV is_right[3];
  const SpanSide side[3] = {side_of(x[0], y[0], x[1], y[1], rule, is_right[0]),
                            side_of(x[1], y[1], x[2], y[2], rule, is_right[1]),
                            side_of(x[2], y[2], x[0], y[0], rule, is_right[2])};
  // Going round, one side at least bounds each way (a level one counts as right); the third may be another of
  // either.
  const SpanSide open_right = {IntV{}, IntV{}, splat(1 << 28), splat(1.0f)},
                 open_left = {IntV{}, IntV{}, splat(1 << 28), splat(-1.0f)};
  const SpanSide r0 = choose(is_right[0], side[0], choose(is_right[1], side[1], side[2]));
  const SpanSide l0 = choose(is_right[0], choose(is_right[1], side[2], side[1]), side[0]);
  const IntV third_right =
      (is_right[0] & is_right[1]) | (is_right[0] & is_right[2]) | (is_right[1] & is_right[2]);
  const SpanSide third = choose(third_right, choose(is_right[0] & is_right[1], side[1], side[2]),
                                choose(is_right[0] | is_right[1], side[2], side[1]));
  const SpanSide r1 = choose(third_right, third, open_right), l1 = choose(third_right, open_left, third);

  const FloatV most = splat(float(right) - 0.5f), least = splat(float(left) - 0.5f);
  const IntV rows = last - first + 1;
  int32_t lane_rows[kWidth];
  memcpy(lane_rows, &rows, sizeof rows);
  int32_t all_rows = 0;
  for (int i = 0; i < kWidth; ++i) all_rows = lane_rows[i] > all_rows ? lane_rows[i] : all_rows;

  struct Values {
    FloatV r0, r1, l0, l1;
  } value[Samples];
  for (int s = 0; s < Samples; ++s) {
    const int dx = Samples > 1 ? kSampleX[s] : 0, dy = Samples > 1 ? kSampleY[s] : 0;
    value[s] = {r0.value(first, dx, dy), r1.value(first, dx, dy), l0.value(first, dx, dy),
                l1.value(first, dx, dy)};
  }
  const FloatV r0_step = r0.step(), r1_step = r1.step(), l0_step = l0.step(), l1_step = l1.step();
  Spans<Samples> spans;
  alignas(64) static constexpr int32_t kLane[16] = {0,        1 << 12,  2 << 12,  3 << 12, 4 << 12,  5 << 12,
                                                    6 << 12,  7 << 12,  8 << 12,  9 << 12, 10 << 12, 11 << 12,
                                                    12 << 12, 13 << 12, 14 << 12, 15 << 12};
  IntV place = load(kLane) + (first << 6) + 1; // of the pixel with number 0 of a row, counted from -1
  for (int32_t row = 0; row < all_rows; ++row) {
    IntV begin[Samples], end[Samples], before = splat(kTileSize), behind = splat(-1);
    for (int s = 0; s < Samples; ++s) {
      Values& v = value[s];
      end[s] = floor_off_integers(min_(min_(v.r0 * r0.inverse, v.r1 * r1.inverse), most));
      begin[s] = // the last pixel outside
          floor_off_integers(max_(max_(v.l0 * l0.inverse, v.l1 * l1.inverse), least));
      v.r0 += r0_step, v.r1 += r1_step, v.l0 += l0_step, v.l1 += l1_step;
      if constexpr (Samples > 1) {
        const IntV none = begin[s] >= end[s];
        begin[s] = choose(none, splat(kTileSize), begin[s]), end[s] = choose(none, splat(-1), end[s]);
        before = min_(before, begin[s]), behind = max_(behind, end[s]);
      } else {
        before = begin[s], behind = end[s];
      }
    }
    const IntV pixels = max_(behind - before, IntV{}) & (splat(row) < rows);
    store(spans.span[row], (pixels << 16) | ((place + before) & 0xffff));
    for (int s = 0; Samples > 1 && s < Samples; ++s)
      store(spans.part[row][s], ((end[s] - before) << 16) | ((begin[s] - before) & 0xffff));
    place += 64;
  }
  for (int32_t row = all_rows; row & 7; ++row) store(spans.span[row], IntV{});

  const IntV columns = last_column(x) - first_column(x, rule);
  auto list = [&](auto parts) __attribute__((always_inline)) {
    uint16_t* next = out.place;
    for (int i = 0; i < count; ++i) {
      next = list_rows(spans, i, lane_rows[i], parts, next,
                       Samples > 1 ? samples + (next - out.place) : nullptr);
      out.end[i] = int32_t(next - out.place);
    }
  };
  if (!any(columns >= splat(kRowPlaces)))
    list(Count<1>());
  else if (!any(columns >= splat(2 * kRowPlaces)))
    list(Count<2>());
  else
    list(Count<kSmallBox / kRowPlaces>());
}

} // namespace SOFTGL_ISA
} // namespace softgl
