// Antialiasing (GL 1.5, 3.11): alpha times the part of a pixel's square that a primitive covers.
#pragma once

#include "shaders/common/lane_math.h"
#include "shaders/common/simd_pixels.h"
#include "shaders/fragment/fragment_program.h"

namespace softgl {
namespace SOFTGL_ISA {

/// GL 1.5, 3.4.4. As OSMesa 22.3.6 computes it: the numbers are the distance from the line and the half width
/// plus half a pixel, and the same along the line. Next to the border they fall off over a pixel.
static void stage_line_coverage(FragmentBlock& block, const FragmentConstants&, int) {
  for (int i = 0; i < block.lanes; ++i) {
    const float* n = &block.coverage[0][i];
    const float across = saturate(n[1 * kLanes] - absolute(n[0]));
    const float along = saturate(n[3 * kLanes] - absolute(n[2 * kLanes]));
    block.color[3][i] = block.color[3][i] * (across * along);
  }
}

/// Multiplies alpha; where nothing is covered there is no fragment.
SOFTGL_INLINE void apply_coverage(FragmentBlock& block, int lane, float coverage) {
  block.color[3][lane] *= coverage;
  block.live[lane] &= uint32_t(mask_of(coverage > 0.0f));
}

/// The area of a disk around the origin in the square of a pixel: 16 columns, each of the height that its
/// middle has, along the axis to which the border is more level. Off by 0.005 at most, by less than 0.001
/// where the radius is above 1.5. `near` and `far`: the lesser and the greater distance of the pixel's center
/// from the axes; `square`: of the radius.
SOFTGL_INLINE FloatV disk_coverage(FloatV near, FloatV far, FloatV square) {
  constexpr int kColumns = 16;
  FloatV sum = FloatV{};
  for (int i = 0; i < kColumns; ++i) {
    const FloatV column = near + ((float(i) + 0.5f) * (1.0f / kColumns) - 0.5f);
    const FloatV height = square_root(max_(square - column * column, FloatV{}));
    sum += max_(min_(far + 0.5f, height) - max_(far - 0.5f, -height), FloatV{});
  }
  return sum * (1.0f / kColumns);
}

/// GL 1.5, 3.3.1. The numbers are the point's position in the window, with centers of pixels at halves, and
/// its radius.
static void stage_point_coverage(FragmentBlock& block, const FragmentConstants&, int) {
  alignas(64) float near[kLanes], far[kLanes], square[kLanes], coverage[kLanes];
  alignas(64) int32_t cut[kLanes]; // the border goes through the pixel
  for (int i = 0; i < block.lanes; i += kWidth) {
    const FloatV x = to_float(load(block.x + i)) + 0.5f - load(block.coverage[0] + i),
                 y = to_float(load(block.y + i)) + 0.5f - load(block.coverage[1] + i);
    const FloatV a = (FloatV)((IntV)x & 0x7fffffff), b = (FloatV)((IntV)y & 0x7fffffff),
                 radius = load(block.coverage[2] + i);
    const FloatV n = min_(a, b), f = max_(a, b), r = radius * radius;
    const IntV inside = (n + 0.5f) * (n + 0.5f) + (f + 0.5f) * (f + 0.5f) <= r;
    const FloatV n_gap = max_(n - 0.5f, FloatV{}), f_gap = max_(f - 0.5f, FloatV{});
    const IntV outside = n_gap * n_gap + f_gap * f_gap >= r;
    store(near + i, n), store(far + i, f), store(square + i, r);
    store(coverage + i, choose(inside, splat(1.0f), FloatV{}));
    store(cut + i, ~(inside | outside));
  }
  // The pixels that are cut come together, since theirs is most of the work.
  int count = 0;
  int32_t lane[kLanes];
  for (int i = 0; i < block.lanes; ++i) {
    near[count] = near[i], far[count] = far[i], square[count] = square[i], lane[count] = i;
    count += cut[i] & 1;
  }
  for (int i = 0; i < count; i += kWidth) {
    alignas(64) float area[kWidth];
    store(area, disk_coverage(load(near + i), load(far + i), load(square + i)));
    for (int k = 0; k < kWidth && i + k < count; ++k) coverage[lane[i + k]] = area[k];
  }
  for (int i = 0; i < block.lanes; i += kWidth) {
    const FloatV c = load(coverage + i);
    store(block.color[3] + i, load(block.color[3] + i) * c);
    store(block.live + i, load(block.live + i) & (IntV)(c > FloatV{}));
  }
}

namespace { // so that no member is visible outside

/// A polygon inside the square of a pixel, which has (0, 0) as its center.
struct PixelPolygon {
  static constexpr int kMost = 8; // the square's corners, and one more for each edge
  int count = 4;
  float x[kMost] = {-0.5f, 0.5f, 0.5f, -0.5f}, y[kMost] = {-0.5f, -0.5f, 0.5f, 0.5f};

  /// Keeps the part where center + gx * x + gy * y is not negative.
  SOFTGL_MEMBER void cut(float center, float gx, float gy) {
    float new_x[kMost], new_y[kMost];
    int kept = 0;
    for (int i = 0; i < count; ++i) {
      const int j = i + 1 == count ? 0 : i + 1;
      const float d = center + gx * x[i] + gy * y[i], e = center + gx * x[j] + gy * y[j];
      if (d >= 0.0f && kept < kMost) new_x[kept] = x[i], new_y[kept++] = y[i];
      if ((d >= 0.0f) != (e >= 0.0f) && kept < kMost) {
        const float t = d / (d - e);
        new_x[kept] = x[i] + t * (x[j] - x[i]), new_y[kept++] = y[i] + t * (y[j] - y[i]);
      }
    }
    count = kept;
    for (int i = 0; i < kept; ++i) x[i] = new_x[i], y[i] = new_y[i];
  }
  SOFTGL_MEMBER float area() const {
    float twice = 0.0f;
    for (int i = 0; i < count; ++i) {
      const int j = i + 1 == count ? 0 : i + 1;
      twice += x[i] * y[j] - x[j] * y[i];
    }
    return saturate(0.5f * twice);
  }
};

} // namespace

/// GL 1.5, 3.5.6. The numbers are the planes of three edges, not negative inside.
static void stage_polygon_coverage(FragmentBlock& block, const FragmentConstants&, int) {
  for (int i = 0; i < block.lanes; ++i) {
    if (!block.live[i]) continue;
    PixelPolygon polygon;
    bool whole = true;
    for (int k = 0; k < 3; ++k) {
      const float a = block.coverage[3 * k][i], gx = block.coverage[3 * k + 1][i],
                  gy = block.coverage[3 * k + 2][i];
      const float center = gy * float(block.y[i]) + (gx * float(block.x[i]) + a);
      if (center >= 0.5f * (absolute(gx) + absolute(gy))) continue;
      polygon.cut(center, gx, gy);
      whole = false;
    }
    if (!whole) apply_coverage(block, i, polygon.area());
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
