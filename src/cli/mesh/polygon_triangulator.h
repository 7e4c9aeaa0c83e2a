// Polygons of any shape in space as triangles.
#pragma once

#include <cstdint>

#include "common/growing_array.h"

namespace softgl::cli {

// Ear clipping over the polygon's projection; only reflex corners can lie in an ear, and a grid finds those
// near it, so that thousands of corners cost milliseconds. Always gives size - 2 triangles, whatever the
// polygon: keyhole polygons (holes joined by a bridge), repeated corners, and self-intersecting ones too. The
// work is limited, for all polygons of one object together: what exceeds it is cut without a look around.
class PolygonTriangulator {
public:
  // `corners`: x y z of each corner. Writes 3 * (size - 2) corner numbers.
  void triangulate(const double* corners, uint32_t size, uint32_t* triangles);
  // What all polygons so far took, in steps along their corners.
  uint64_t steps() const { return steps_; }

private:
  bool project(const double* corners, uint32_t size);
  bool is_convex() const;
  double turn(uint32_t a, uint32_t b, uint32_t c) const;
  int bend(uint32_t corner) const;
  void build_grid();
  bool is_ear(uint32_t corner, bool strictly);
  void spend(uint64_t steps);
  void clip(uint32_t corner);
  void clip_ears();
  uint32_t cell_of(double value, int axis) const;

  uint32_t size_ = 0;
  GrowingArray<double> x_, y_;
  double extent_ = 0;
  GrowingArray<uint32_t> previous_, next_;
  GrowingArray<uint32_t> blocker_; // the corner that was found in the triangle of each
  GrowingArray<int8_t> bend_;      // 1 convex, 0 straight, -1 reflex
  uint32_t reflex_count_ = 0;

  // Reflex corners by cell: a start per cell, then the corners.
  uint32_t columns_ = 1;
  double grid_origin_[2] = {0, 0}, grid_scale_[2] = {0, 0};
  struct ReflexCorner {
    double x, y; // again, because these are read in order
    uint32_t corner;
  };
  GrowingArray<uint32_t> cell_start_;
  GrowingArray<ReflexCorner> cell_corners_;
  uint64_t steps_ = 0, steps_left_ = 0; // in all; for this polygon
  uint64_t spare_steps_ = 60'000'000;   // for polygons that need more than the usual number
  uint32_t* out_ = nullptr;
};

} // namespace softgl::cli
