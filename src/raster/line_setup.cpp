// Lines follow OSMesa 22.3.6 (llvmpipe): a diamond-exit test at both ends, then a parallelogram whose ends
// are vertical (x-major) or horizontal (y-major), filled by the edge rule of triangles.
#include "raster/line_setup.h"
#include "raster/snap.h"

#include <algorithm>
#include <cmath>

namespace softgl {

namespace {

// Truths are numbers here, so that `and` and `or` are no branches.
int below(float a, float b) { return a < b; }
int not_negative(float x) { return x >= 0; }
/// x - floor(x) for |x| < 2^31; the baseline has no instruction for the floor.
float fraction(float x) {
  const auto whole = static_cast<int32_t>(x);
  return x - static_cast<float>(whole - (static_cast<float>(whole) > x));
}
bool on_surface(const float* v) { return std::fabs(v[0]) < 32768.0f * 2 && std::fabs(v[1]) < 32768.0f * 2; }

/// The ends as drawn: window positions plus these moves.
struct Ends {
  float x1 = 0, y1 = 0, x2 = 0, y2 = 0;
};

// Where an end lies in its pixel is hard to predict: there is no branch in these two. Measured: 64 to 40 ns
// for a line of ten pixels, with the divisions of line_steps.cpp.

Ends move_x_major(const float* v1, const float* v2, float dx, float dy) {
  const float m = dy / dx;
  const float fy1 = fraction(v1[1]), fy2 = fraction(v2[1]);
  const float ex1 = fraction(v1[0]) - 0.5f, ey1 = fy1 - 0.5f, ex2 = fraction(v2[0]) - 0.5f;
  const float ey2 = (int(fy2 == 0) & below(dy, 0)) != 0 ? 0.5f : fy2 - 0.5f;
  const int right = not_negative(dx), left = not_negative(-dx), down = not_negative(dy);
  const float y1 = fy1 + ex1 * m, y2 = fy2 + ex2 * m;
  const int inside1 = below(std::fabs(ex1) + std::fabs(ey1), 0.5f),
            inside2 = below(std::fabs(ex2) + std::fabs(ey2), 0.5f);
  const int crosses1 = (not_negative(-ey1) ^ down) | (below(y1, 1) & below(0, y1)),
            crosses2 = (not_negative(-ey2) ^ down ^ 1) | (below(y2, 1) & below(0, y2));
  const int start = inside1 | ((not_negative(ex1) ^ left) & crosses1),
            end = (inside2 ^ 1) & (not_negative(ex2) ^ left ^ 1) & crosses2;
  const int start_by_default = not_negative(-ex1) ^ right,
            end_by_default = (not_negative(ex2) ^ left ^ 1) | int(ex2 == 0);
  const float half = dx < 0 ? -0.5f : 0.5f;
  const float x1 = start != start_by_default ? -ex1 + half : 0, x2 = end != end_by_default ? -ex2 + half : 0;
  return {x1, x1 * m, x2, x2 * m};
}

Ends move_y_major(const float* v1, const float* v2, float dx, float dy) {
  const float m = dx / dy;
  const float fx1 = fraction(v1[0]), fx2 = fraction(v2[0]);
  const float ex1 = fx1 - 0.5f, ey1 = fraction(v1[1]) - 0.5f, ey2 = fraction(v2[1]) - 0.5f;
  const float ex2 = (int(fx2 == 0) & below(dx, 0)) != 0 ? 0.5f : fx2 - 0.5f;
  const int left = not_negative(-dx), down = not_negative(dy);
  const float x1 = fx1 + ey1 * m, x2 = fx2 + ey2 * m;
  const int inside1 = below(std::fabs(ex1) + std::fabs(ey1), 0.5f),
            inside2 = below(std::fabs(ex2) + std::fabs(ey2), 0.5f);
  const int crosses1 = (not_negative(ex1) ^ left) | (below(x1, 1) & below(0, x1)),
            crosses2 = (not_negative(ex2) ^ left ^ 1) | (below(x2, 1) & not_negative(x2));
  const int start = inside1 | ((not_negative(-ey1) ^ down) & crosses1),
            end = (inside2 ^ 1) & (not_negative(-ey2) ^ down ^ 1) & crosses2;
  const int start_by_default = not_negative(ey1) ^ down ^ 1,
            end_by_default = (not_negative(-ey2) ^ down ^ 1) | int(ey2 == 0);
  const float half = dy > 0 ? 0.5f : -0.5f;
  const float y1 = start != start_by_default ? -ey1 + half : 0, y2 = end != end_by_default ? -ey2 + half : 0;
  return {y1 * m, y1, y2 * m, y2};
}

/// Corners of a line's body, in 1/256 of a pixel.
struct Body {
  int32_t x[4], y[4];
};

/// The corners go round from the right (x-major) or upper end.
Body parallelogram(const SnappedLine& l) {
  const int32_t hx = l.x_major ? 0 : l.half_width, hy = l.x_major ? l.half_width : 0;
  return {{l.ax - hx, l.bx - hx, l.bx + hx, l.ax + hx}, {l.ay - hy, l.by - hy, l.by + hy, l.ay + hy}};
}

/// The body with multisampling (3.4.4): as wide as the line, at right angles to it.
Body rectangle(const float* v1, const float* v2, const SnappedLine& l, float width) {
  const float scale = (width * 0.5f) / std::sqrt(l.length2);
  const int32_t hx = snap(-l.dy * scale), hy = snap(l.dx * scale);
  const int32_t ax = snap(v1[0]), ay = snap(v1[1]), bx = snap(v2[0]), by = snap(v2[1]);
  return {{ax - hx, bx - hx, bx + hx, ax + hx}, {ay - hy, by - hy, by + hy, ay + hy}};
}

/// False: it has no length, or its ends lie nowhere.
bool measure_line(const float* v1, const float* v2, SnappedLine& l) {
  if (!on_surface(v1) || !on_surface(v2)) return false; // also drops what is not a number
  l.dx = v1[0] - v2[0], l.dy = v1[1] - v2[1];
  l.length2 = l.dx * l.dx + l.dy * l.dy;
  l.x_major = std::fabs(l.dx) >= std::fabs(l.dy);
  return l.length2 != 0;
}

void snap_ends(const RasterConstants& r, const float* v1, const float* v2, SnappedLine& l) {
  l.half_width = static_cast<int32_t>(r.line_width + 0.5f) * 128;
  const Ends e = l.x_major ? move_x_major(v1, v2, l.dx, l.dy) : move_y_major(v1, v2, l.dx, l.dy);
  l.ax = snap(v1[0] + e.x1 - 0.5f), l.ay = snap(v1[1] + e.y1 - 0.5f);
  l.bx = snap(v2[0] + e.x2 - 0.5f), l.by = snap(v2[1] + e.y2 - 0.5f);
  if (l.x_major ? l.dx < 0 : l.dy > 0) std::swap(l.ax, l.bx), std::swap(l.ay, l.by);
}

} // namespace

bool snap_line(const RasterConstants& r, const float* v1, const float* v2, SnappedLine& out) {
  if (!measure_line(v1, v2, out)) return false;
  snap_ends(r, v1, v2, out);
  return true;
}

bool setup_line(const RasterDraw& draw, const ShadedVertices::Slot* corner0,
                const ShadedVertices::Slot* corner1, bool back, RasterPrimitive& out) {
  const RasterConstants& r = *draw.raster;
  const float *v1 = corner0->v, *v2 = corner1->v;
  SnappedLine line;
  if (!measure_line(v1, v2, line)) return false;
  if (!r.per_sample) snap_ends(r, v1, v2, line);
  const auto [x, y] = r.per_sample ? rectangle(v1, v2, line, r.line_width) : parallelogram(line);
  const float dx = line.dx, dy = line.dy, inverse = 1.0f / line.length2;

  out.edges = 4;
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) & 3;
    const int32_t a = y[i] - y[j], b = x[i] - x[j];
    const bool included = a < 0 || (a == 0 && (r.top_edge_rule ? b > 0 : b < 0));
    const int64_t c = int64_t(a) * x[i] - int64_t(b) * y[i] + (included ? 1 : 0);
    out.a[i] = a, out.b[i] = b, out.c[i] = (c - 1) >> r.edge_shift;
  }
  const auto [min_x, max_x] = std::minmax({x[0], x[1], x[2], x[3]});
  const auto [min_y, max_y] = std::minmax({y[0], y[1], y[2], y[3]});
  out.x0 = std::max((min_x + r.to_first_pixel) >> 8, r.x0), out.x1 = std::min(((max_x - 1) >> 8) + 1, r.x1);
  const int32_t bottom = r.top_edge_rule ? 0 : 1; // centers on the last row's level edge are inside
  out.y0 = std::max((min_y + r.to_first_pixel + bottom) >> 8, r.y0),
  out.y1 = std::min(((max_y - 1 + bottom) >> 8) + 1, r.y1);
  if (out.x0 >= out.x1 || out.y0 >= out.y1) return false;

  // Planes: the gradient is along the line where that is a rectangle, else along the major axis only.
  float along_x = 0, along_y = 0;
  if (r.per_sample) {
    along_x = dx, along_y = dy;
  } else if (line.x_major) {
    const float m = dy / dx;
    along_x = dx * (1 + m * m);
  } else {
    const float m = dx / dy;
    along_y = dy * (1 + m * m);
  }
  auto plane = [&](float a1, float a2) {
    Plane p;
    const float d = a1 - a2;
    p.gx = d * along_x * inverse;
    p.gy = d * along_y * inverse;
    p.a = a1 - (p.gx * (v1[0] - r.pixel_center) + p.gy * (v1[1] - r.pixel_center));
    return p;
  };
  const float w1 = v1[3], w2 = v2[3];
  auto attributes = [&](const Varying& v) {
    for (int k = 0; k < v.components; ++k) {
      const float a1 = corner0[v.slot].v[v.first + k], a2 = corner1[v.slot].v[v.first + k];
      out.plane[v.plane + k] = v.flat ? Plane{a2, 0, 0} : plane(a1 * w1, a2 * w2);
    }
  };
  out.plane[kPlaneZ] = plane(v1[2], v2[2]);
  out.plane[kPlaneW] = plane(w1, w2);
  for (int i = 0; i < draw.varying_count; ++i) attributes(draw.varying[i]);
  for (int u = 0; u < kMaxTextureUnits; ++u)
    if (draw.unit_plane[u] >= 0) attributes(coordinates_of_unit(draw, u));
  const Plane& w = out.plane[kPlaneW];
  out.w_is_one = w.a == 1.0f && w.gx == 0.0f && w.gy == 0.0f;
  out.depth_offset = 0;
  out.back = back;
  out.round = false;
  return true;
}

} // namespace softgl
