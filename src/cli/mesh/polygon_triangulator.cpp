#include "mesh/polygon_triangulator.h"

#include <algorithm>
#include <cmath>

namespace softgl::cli {
namespace {

// How much work a polygon may be, in steps of about 2 ns along its corners. Nearly all take less than a
// hundred looks a corner.
constexpr uint64_t kLook = 4; // steps for a look at a corner that may lie in an ear
constexpr uint64_t kStepsEach = 80 * kLook, kSpareStepsEach = 40 * kLook, kMostStepsEach = 2000 * kLook;
constexpr uint32_t kNone = 0xffffffff;

} // namespace

void PolygonTriangulator::triangulate(const double* corners, uint32_t size, uint32_t* triangles) {
  size_ = size;
  out_ = triangles;
  if (size > 3 && project(corners, size) && !is_convex()) {
    clip_ears();
    return;
  }
  for (uint32_t i = 1; i + 1 < size; ++i) {
    *out_++ = 0;
    *out_++ = i;
    *out_++ = i + 1;
  }
}

// Newell's normal decides the axis to drop; the two left over are ordered so that the polygon runs
// counterclockwise.
bool PolygonTriangulator::project(const double* corners, uint32_t size) {
  double low[3] = {corners[0], corners[1], corners[2]}, high[3] = {corners[0], corners[1], corners[2]};
  for (uint32_t i = 1; i < size; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], corners[3 * i + axis]);
      high[axis] = std::max(high[axis], corners[3 * i + axis]);
    }
  const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  if (!(extent > 0)) return false;
  const double scale = 1 / extent; // into 0..1, so that no product leaves the range of double
  const auto coordinate = [&](uint32_t i, int axis) { return (corners[3 * i + axis] - low[axis]) * scale; };
  double normal[3] = {0, 0, 0};
  for (uint32_t i = 0, j = size - 1; i < size; j = i++)
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      normal[axis] += (coordinate(j, u) - coordinate(i, u)) * (coordinate(j, v) + coordinate(i, v));
    }
  const double size_of[3] = {std::fabs(normal[0]), std::fabs(normal[1]), std::fabs(normal[2])};
  int dropped = 2;
  if (size_of[0] > size_of[1] && size_of[0] > size_of[2])
    dropped = 0;
  else if (size_of[1] > size_of[2])
    dropped = 1;
  if (!(size_of[dropped] > 1e-300)) return false;
  int u = (dropped + 1) % 3, v = (dropped + 2) % 3;
  if (normal[dropped] < 0) std::swap(u, v);
  x_.truncate(0);
  y_.truncate(0);
  x_.extend(size);
  y_.extend(size);
  extent_ = 1;
  for (uint32_t i = 0; i < size; ++i) {
    x_[i] = coordinate(i, u);
    y_[i] = coordinate(i, v);
  }
  return true;
}

double PolygonTriangulator::turn(uint32_t a, uint32_t b, uint32_t c) const {
  return (x_[b] - x_[a]) * (y_[c] - y_[a]) - (x_[c] - x_[a]) * (y_[b] - y_[a]);
}

bool PolygonTriangulator::is_convex() const {
  int changes_x = 0, last_sign = 0, first_sign = 0;
  for (uint32_t i = 0; i < size_; ++i) {
    const uint32_t j = i + 1 < size_ ? i + 1 : 0, k = j + 1 < size_ ? j + 1 : 0;
    if (turn(i, j, k) < 0) return false;
    const double dx = x_[j] - x_[i];
    const int sign = (dx > 0) - (dx < 0);
    if (sign == 0) continue;
    if (first_sign == 0) first_sign = sign;
    changes_x += last_sign != 0 && sign != last_sign;
    last_sign = sign;
  }
  changes_x += last_sign != first_sign;
  return changes_x <= 2; // more: it winds around itself
}

// Which way the polygon bends at a corner. Rounding of the coordinates must not make a straight corner
// reflex.
int PolygonTriangulator::bend(uint32_t corner) const {
  const uint32_t a = previous_[corner], c = next_[corner];
  const double value = turn(a, corner, c);
  const double lengths = std::fabs(x_[corner] - x_[a]) + std::fabs(y_[corner] - y_[a]) +
                         std::fabs(x_[c] - x_[corner]) + std::fabs(y_[c] - y_[corner]);
  const double noise = 1e-15 * extent_ * lengths;
  return value > noise ? 1 : value < -noise ? -1 : 0;
}

uint32_t PolygonTriangulator::cell_of(double value, int axis) const {
  const double cell = (value - grid_origin_[axis]) * grid_scale_[axis];
  return cell <= 0 ? 0 : std::min(columns_ - 1, uint32_t(cell));
}

void PolygonTriangulator::build_grid() {
  double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
  for (uint32_t i = 0; i < size_; ++i) {
    if (bend_[i] >= 0) continue;
    low[0] = std::min(low[0], x_[i]);
    high[0] = std::max(high[0], x_[i]);
    low[1] = std::min(low[1], y_[i]);
    high[1] = std::max(high[1], y_[i]);
  }
  columns_ = std::clamp(uint32_t(std::sqrt(reflex_count_ * 0.5)), 1u, 2048u);
  for (int axis = 0; axis < 2; ++axis) {
    grid_origin_[axis] = low[axis];
    grid_scale_[axis] = high[axis] > low[axis] ? columns_ / (high[axis] - low[axis]) : 0;
  }
  const size_t cells = size_t(columns_) * columns_;
  cell_start_.truncate(0);
  cell_start_.fill(cells + 1, 0);
  cell_corners_.truncate(0);
  cell_corners_.extend(reflex_count_);
  const auto cell = [&](uint32_t i) { return cell_of(y_[i], 1) * columns_ + cell_of(x_[i], 0); };
  for (uint32_t i = 0; i < size_; ++i)
    if (bend_[i] < 0) ++cell_start_[cell(i) + 1];
  for (size_t i = 0; i < cells; ++i) cell_start_[i + 1] += cell_start_[i];
  for (uint32_t i = size_; i-- > 0;) // from behind, so that each cell's start comes out right afterwards
    if (bend_[i] < 0) cell_corners_[--cell_start_[cell(i) + 1]] = {x_[i], y_[i], i};
  for (size_t i = 0; i < cells; ++i) cell_start_[i] = cell_start_[i + 1];
  cell_start_[cells] = reflex_count_;
}

void PolygonTriangulator::spend(uint64_t steps) {
  steps_left_ -= std::min(steps_left_, steps);
  steps_ += steps;
}

// No reflex corner lies in the triangle of the corner and its neighbours. Corners at the same place as one of
// the three do not count: bridges to holes visit a place twice.
bool PolygonTriangulator::is_ear(uint32_t b, bool strictly) {
  const uint32_t a = previous_[b], c = next_[b];
  const double ax = x_[a], ay = y_[a], bx = x_[b], by = y_[b], cx = x_[c], cy = y_[c];
  const double low_x = std::min({ax, bx, cx}), high_x = std::max({ax, bx, cx});
  const double low_y = std::min({ay, by, cy}), high_y = std::max({ay, by, cy});
  const auto blocks = [&](double px, double py, uint32_t p) {
    if (px < low_x || px > high_x || py < low_y || py > high_y || bend_[p] >= 0) return false;
    if ((px == ax && py == ay) || (px == bx && py == by) || (px == cx && py == cy)) return false;
    const double ab = turn(a, b, p), bc = turn(b, c, p), ca = turn(c, a, p);
    return strictly ? ab > 0 && bc > 0 && ca > 0 : ab >= 0 && bc >= 0 && ca >= 0;
  };
  // What was in the way the last time is most probably still there.
  if (const uint32_t p = blocker_[b]; p != kNone && blocks(x_[p], y_[p], p)) return false;
  const uint32_t first_column = cell_of(low_x, 0), last_column = cell_of(high_x, 0);
  const uint32_t first_row = cell_of(low_y, 1), last_row = cell_of(high_y, 1);
  for (uint32_t row = first_row; row <= last_row; ++row) {
    const uint32_t begin = cell_start_[row * columns_ + first_column];
    const uint32_t end = cell_start_[row * columns_ + last_column + 1];
    spend(kLook * (end - begin + 1));
    for (uint32_t i = begin; i < end; ++i) {
      const ReflexCorner& p = cell_corners_[i];
      if (!blocks(p.x, p.y, p.corner)) continue;
      blocker_[b] = p.corner;
      return false;
    }
  }
  return true;
}

void PolygonTriangulator::clip(uint32_t corner) {
  const uint32_t a = previous_[corner], c = next_[corner];
  *out_++ = a;
  *out_++ = corner;
  *out_++ = c;
  next_[a] = c;
  previous_[c] = a;
  bend_[corner] = 2; // gone: never reflex again
  bend_[a] = int8_t(bend(a));
  bend_[c] = int8_t(bend(c));
}

void PolygonTriangulator::clip_ears() {
  for (auto* list : {&previous_, &next_}) {
    list->truncate(0);
    list->extend(size_);
  }
  bend_.truncate(0);
  bend_.extend(size_);
  blocker_.truncate(0);
  blocker_.fill(size_, kNone);
  for (uint32_t i = 0; i < size_; ++i) {
    previous_[i] = i ? i - 1 : size_ - 1;
    next_[i] = i + 1 < size_ ? i + 1 : 0;
  }
  reflex_count_ = 0;
  for (uint32_t i = 0; i < size_; ++i) {
    bend_[i] = int8_t(bend(i));
    reflex_count_ += bend_[i] < 0;
  }
  build_grid();

  // A polygon that never yields an ear must not cost much more than a well-behaved one of its size, and a
  // thousand such polygons not a thousand times that.
  spare_steps_ += kSpareStepsEach * size_;
  const uint64_t own = kStepsEach * size_, all = kMostStepsEach * size_ + 100 * kMostStepsEach;
  steps_left_ = std::min(all, own + spare_steps_);
  const uint64_t borrowed_at = steps_left_ - std::min(steps_left_, own);
  uint32_t left = size_, corner = 0, misses = 0;
  enum { kCareful, kTouching, kForced } mode = kCareful;
  while (left > 3) {
    if (steps_left_ == 0) mode = kForced;
    const uint32_t patience = steps_left_ ? left : std::min(left, 16u);
    const int shape = bend_[corner];
    bool clipped = false;
    if (mode == kCareful)
      clipped = shape > 0 && is_ear(corner, false);
    else if (mode == kTouching)
      clipped = shape == 0 || (shape > 0 && is_ear(corner, true));
    else
      clipped = shape >= 0 || misses >= patience;
    if (!clipped) {
      corner = next_[corner];
      spend(1);
      if (++misses < left) continue;
      if (mode == kCareful)
        mode = kTouching, misses = 0;
      else if (mode == kTouching)
        mode = kForced, misses = 0;
      continue;
    }
    const uint32_t following = next_[corner];
    clip(corner);
    --left;
    misses = 0;
    if (mode == kForced && steps_left_ > 0) mode = kTouching;
    corner = next_[following]; // every second corner: rounder triangles than clipping one fan
    if (bend_[corner] == 2) corner = following;
  }
  *out_++ = previous_[corner];
  *out_++ = corner;
  *out_++ = next_[corner];
  spare_steps_ -= borrowed_at - std::min(borrowed_at, steps_left_);
}

} // namespace softgl::cli
