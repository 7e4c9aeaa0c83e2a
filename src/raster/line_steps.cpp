#include "raster/line_steps.h"

#include <algorithm>

#include "raster/line_setup.h"

namespace softgl {
namespace {

// The place along the minor axis is a fraction whose denominator is 256 times the length along the major
// axis. The first place and the steps are too large by up to 3 units of 2^-40 each: the sum of
// kMostLinePixels of them stays below the next fraction, so that its whole part is exact.
static_assert(int64_t(256) * kMostLinePixels * 256 <
              (int64_t(1) << LineSteps::kFraction) / (3 * kMostLinePixels));
// Below this the reciprocal of the squared length may be infinite, whose products with 0 are no planes of 0.
constexpr float kLeastLength2 = 1e-20f;

int32_t first_from(int32_t place) { return (place + 255) >> 8; }
int32_t first_behind(int32_t place) { return (place >> 8) + 1; }

/// a / b in units of 2^-kFraction, or up to 3 more. Divisions of integers take twice the time.
int64_t fraction_of(int64_t a, int64_t b) {
  return int64_t(double(a) / double(b) * double(int64_t(1) << LineSteps::kFraction)) + 2;
}

/// Along the minor axis the line goes through `place` at `from`, in 1/256 of a pixel, and over `run` along
/// the major axis it goes `rise`. Pixel centers on its lower edge are inside or not.
void begin_steps(int32_t first, int64_t place, int64_t from, int64_t rise, int64_t run, bool inside,
                 LineSteps& steps) {
  const int64_t whole = 256 * run;
  const int64_t numerator = place * run + rise * (int64_t(first) * 256 - from) + whole - (inside ? 1 : 0);
  auto pixel = int64_t(double(numerator) / double(whole)); // below 2^52: its whole part is exact
  pixel -= pixel * whole > numerator;
  steps.minor = (pixel << LineSteps::kFraction) + fraction_of(numerator - pixel * whole, whole);
  steps.slope = fraction_of(rise, run);
}

} // namespace

LineKind step_line(const RasterDraw& draw, const ShadedVertices::Slot* corner0,
                   const ShadedVertices::Slot* corner1, LineSpan& span, LineSteps& steps) {
  const RasterConstants& r = *draw.raster;
  const float *v1 = corner0->v, *v2 = corner1->v;
  SnappedLine line;
  if (!snap_line(r, v1, v2, line)) return LineKind::Nothing;
  if (line.length2 < kLeastLength2) return LineKind::Other;
  int32_t first, last;
  if (line.x_major) { // vertical ends: pixels on the left one are inside
    first = first_from(line.bx), last = first_from(line.ax);
  } else { // level ends
    const auto begin = r.top_edge_rule ? first_from : first_behind;
    first = begin(line.ay), last = begin(line.by);
  }
  first = std::max(first, line.x_major ? r.x0 : r.y0), last = std::min(last, line.x_major ? r.x1 : r.y1);
  if (first >= last) return LineKind::Nothing;
  const int32_t run = line.x_major ? line.ax - line.bx : line.by - line.ay;
  if (run > 256 * kMostLinePixels) return LineKind::Other;
  steps.width = line.half_width / 128;
  steps.x_major = line.x_major;
  if (line.x_major) {
    const int32_t rise = line.ay - line.by;
    begin_steps(first, line.by - line.half_width, line.bx, rise, run,
                rise < 0 || (rise == 0 && r.top_edge_rule), steps);
  } else {
    begin_steps(first, line.ax - line.half_width, line.ay, line.bx - line.ax, run, true, steps);
  }

  span.first = first, span.count = last - first;
  const float inverse = 1.0f / line.length2;
  const float major = line.x_major ? line.dx : line.dy, minor = line.x_major ? line.dy : line.dx;
  const float m = minor / major, along = major * (1 + m * m);
  const float begin = (line.x_major ? v1[0] : v1[1]) - r.pixel_center;
  auto plane = [&](int k, float a1, float a2) {
    span.step[k] = (a1 - a2) * along * inverse;
    span.start[k] = a1 - span.step[k] * begin;
  };
  const float w1 = v1[3], w2 = v2[3];
  plane(0, v1[2], v2[2]);
  plane(1, w1, w2);
  const Varying& color = draw.varying[0];
  const float *c1 = corner0[color.slot].v, *c2 = corner1[color.slot].v;
  for (int k = 0; k < 4; ++k)
    if (color.flat)
      span.start[2 + k] = c2[k], span.step[2 + k] = 0;
    else
      plane(2 + k, c1[k] * w1, c2[k] * w2);
  return LineKind::Steps;
}

} // namespace softgl
