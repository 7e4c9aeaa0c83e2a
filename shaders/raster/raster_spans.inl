// Which pixels small triangles cover in a tile: one span a row, lane = triangle. As OSMesa 22.3.6 computes:
// from positions snapped to 1/256 pixel.
#pragma once

#include "shaders/raster/raster_interpolate.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Where the pixels of kWidth small triangles are, listed triangle by triangle: bits 0-5 x, 6-11 y in the
/// tile, 12-15 the triangle.
struct SmallPixels {
  static constexpr int kMost = kWidth * kSmallBox * kSmallBox;
  alignas(64) uint16_t place[kMost + kSmallBox];
  int32_t end[kWidth]; // of each triangle's
};

/// A side that bounds spans. With t = (value + 0.5) / a pixels up to floor(t) are inside, or, on the left,
/// from ceil(t) on: that is the test value - a * x >= 0 of whole numbers, since t is 1 / (2 |a|) > 2^-16 off
/// every integer, and its rounding errors are below 2^-16 up to 128.
struct SpanSide {
  FloatV value, step, inverse; // value + 0.5 at a row, its change from row to row, 1 / a

  SOFTGL_MEMBER FloatV bound() const { return value * inverse; }
  SOFTGL_MEMBER void next_row() { value += step; }
};

SOFTGL_INLINE SpanSide choose(IntV mask, const SpanSide& a, const SpanSide& b) {
  return {choose(mask, a.value, b.value), choose(mask, a.step, b.step), choose(mask, a.inverse, b.inverse)};
}

/// The edge from corner i to corner j of a triangle with positive area, at row `y`; `right` is set where it
/// bounds the right.
SOFTGL_INLINE SpanSide side_of(IntV xi, IntV yi, IntV xj, IntV yj, IntV y, const EdgeRule& rule,
                               IntV& right) {
  const IntV a = yi - yj, b = xi - xj;
  const IntV included = edge_included(a, b, rule);
  // All numbers are small: a side is at most 64 pixels long, and no more than that away from the tile.
  const IntV value = ((multiply(a, xi) - multiply(b, yi) - 1 - included) >> 8) + multiply(b, y);
  right = a >= 0;
  // A level side accepts or refuses the whole row.
  return {to_float(value) + 0.5f, to_float(b), choose(a == 0, splat(128.0f), splat(1.0f) / to_float(a))};
}

constexpr int kRowPlaces = 16;

/// Puts the places of the spans of triangle `lane` behind each other from `next` on, a row as a whole: it has
/// at most `parts` times kRowPlaces pixels. Gives their end.
template <class Parts> SOFTGL_INLINE uint16_t* list_rows(const uint32_t (*span)[kWidth], int lane,
                                                         int32_t rows, Parts parts, uint16_t* next) {
  typedef uint16_t Row __attribute__((vector_size(2 * kRowPlaces)));
  constexpr Row kColumns = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  // By eights: how many rows a triangle has is hard to predict.
  for (int32_t row = 0; row < rows; row += 8)
#pragma GCC unroll 8
    for (int32_t k = 0; k < 8; ++k) {
      const uint32_t s = span[row + k][lane];
      for (int part = 0; part < parts; ++part) {
        const Row places = kColumns + uint16_t(s + uint32_t(part * kRowPlaces));
        memcpy(next + part * kRowPlaces, &places, sizeof places);
      }
      next += s >> 16;
    }
  return next;
}

/// Lists the pixels of `count` triangles (at most kWidth, the other lanes repeat one of them); p: their
/// corners' positions.
static void list_pixels(const RasterConstants& r, const TileTarget& tile, const FloatV p[3][4], int count,
                        SmallPixels& out) {
  IntV x[3], y[3];
  for (int k = 0; k < 3; ++k) {
    x[k] = round_to_int(snap_scaled(p[k][0])) - 256 * tile.x;
    y[k] = round_to_int(snap_scaled(p[k][1])) - 256 * tile.y;
  }
  auto within = [](int32_t v, int32_t most) { return v < 0 ? 0 : v < most ? v : most; };
  const int32_t left = within(r.x0 - tile.x, kTileSize), top = within(r.y0 - tile.y, kTileSize);
  const int32_t right = within(r.x1 - tile.x, kTileSize), bottom = within(r.y1 - tile.y, kTileSize);
  const EdgeRule rule(r);
  const IntV first = max_(first_row(y, rule), splat(top)), last = min_(last_row(y, rule), splat(bottom - 1));

  IntV is_right[3];
  const SpanSide side[3] = {side_of(x[0], y[0], x[1], y[1], first, rule, is_right[0]),
                            side_of(x[1], y[1], x[2], y[2], first, rule, is_right[1]),
                            side_of(x[2], y[2], x[0], y[0], first, rule, is_right[2])};
  // Going round, one side at least bounds each way (a level one counts as right); the third may be another of
  // either.
  const SpanSide open_right = {splat(float(1 << 20)), FloatV{}, splat(1.0f)},
                 open_left = {splat(float(1 << 20)), FloatV{}, splat(-1.0f)};
  SpanSide r0 = choose(is_right[0], side[0], choose(is_right[1], side[1], side[2]));
  SpanSide l0 = choose(is_right[0], choose(is_right[1], side[2], side[1]), side[0]);
  const IntV third_right =
      (is_right[0] & is_right[1]) | (is_right[0] & is_right[2]) | (is_right[1] & is_right[2]);
  const SpanSide third = choose(third_right, choose(is_right[0] & is_right[1], side[1], side[2]),
                                choose(is_right[0] | is_right[1], side[2], side[1]));
  SpanSide r1 = choose(third_right, third, open_right), l1 = choose(third_right, open_left, third);

  const FloatV most = splat(float(right) - 0.5f), least = splat(float(left) - 0.5f);
  const IntV rows = last - first + 1;
  int32_t lane_rows[kWidth];
  memcpy(lane_rows, &rows, sizeof rows);
  int32_t all_rows = 0;
  for (int i = 0; i < kWidth; ++i) all_rows = lane_rows[i] > all_rows ? lane_rows[i] : all_rows;

  // Spans by row and lane: the first pixel's place, and how many there are in the upper half.
  alignas(64) uint32_t span[kSmallBox][kWidth];
  alignas(64) static constexpr int32_t kLane[16] = {0,        1 << 12,  2 << 12,  3 << 12, 4 << 12,  5 << 12,
                                                    6 << 12,  7 << 12,  8 << 12,  9 << 12, 10 << 12, 11 << 12,
                                                    12 << 12, 13 << 12, 14 << 12, 15 << 12};
  IntV place = load(kLane) + (first << 6) + 1; // of the pixel with number 0 of a row, counted from -1
  for (int32_t row = 0; row < all_rows; ++row) {
    const IntV end = floor_off_integers(min_(min_(r0.bound(), r1.bound()), most));
    const IntV before =
        floor_off_integers(max_(max_(l0.bound(), l1.bound()), least)); // the last pixel outside
    r0.next_row(), r1.next_row(), l0.next_row(), l1.next_row();
    const IntV pixels = max_(end - before, IntV{}) & (splat(row) < rows);
    store(span[row], (pixels << 16) | ((place + before) & 0xffff));
    place += 64;
  }
  for (int32_t row = all_rows; row & 7; ++row) store(span[row], IntV{});

  const IntV columns = last_column(x) - first_column(x, rule);
  auto list = [&](auto parts) __attribute__((always_inline)) {
    uint16_t* next = out.place;
    for (int i = 0; i < count; ++i) {
      next = list_rows(span, i, lane_rows[i], parts, next);
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
