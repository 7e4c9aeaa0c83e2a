// Points follow OSMesa 22.3.6 (llvmpipe): whole numbers of pixels with halves rounded down, or, as sprites,
// squares of the exact size filled by the edge rule of triangles. With multisampling those that are not
// sprites are circles (3.3.3).
#include "raster/point_setup.h"

#include <algorithm>
#include <cmath>

#include "draw/draw_record.h"
#include "raster/snap.h"

namespace softgl {

namespace {

/// Clips the box to the pixels that may change. False: nothing is left.
bool set_box(const RasterConstants& r, const WindowBox& box, RasterPrimitive& out) {
  out.x0 = std::max(box.x0, r.x0), out.x1 = std::min(box.x1, r.x1);
  out.y0 = std::max(box.y0, r.y0), out.y1 = std::min(box.y1, r.y1);
  out.edges = 0; // the box is all
  for (int i = 0; i < 4; ++i) out.a[i] = out.b[i] = 0, out.c[i] = 0;
  out.round = false;
  return out.x0 < out.x1 && out.y0 < out.y1;
}

/// Planes of the corner's values, the same everywhere.
void set_constant_planes(const RasterDraw& draw, const ShadedVertices::Slot* corner, RasterPrimitive& out) {
  const float *v = corner->v, w = v[3];
  auto attributes = [&](const Varying& a) {
    for (int k = 0; k < a.components; ++k) {
      const float value = corner[a.slot].v[a.first + k];
      out.plane[a.plane + k] = {a.flat ? value : value * w, 0, 0};
    }
  };
  out.plane[kPlaneZ] = {v[2], 0, 0};
  out.plane[kPlaneW] = {w, 0, 0};
  for (int i = 0; i < draw.varying_count; ++i) attributes(draw.varying[i]);
  for (int u = 0; u < kMaxTextureUnits; ++u)
    if (draw.unit_plane[u] >= 0) attributes(coordinates_of_unit(draw, u));
  out.w_is_one = w == 1.0f;
  out.depth_offset = 0;
}

/// The sample points of the pixels in the box that lie in a square: those on its left and lower sides do.
void set_square(int32_t left, int32_t top, int32_t width, bool top_edge_rule, RasterPrimitive& out) {
  out.edges = 4;
  const int32_t first = top_edge_rule ? top : top + 1;
  const int32_t a[4] = {-1, 1, 0, 0}, b[4] = {0, 0, 1, -1};
  const int32_t c[4] = {-left, left + width - 1, -first, first + width - 1};
  for (int i = 0; i < 4; ++i) out.a[i] = a[i], out.b[i] = b[i], out.c[i] = c[i];
}

/// Sample points within half the size of the center.
void set_circle(const float* center, float size, RasterPrimitive& out) {
  const auto radius = static_cast<int64_t>(size * 128.0f);
  out.round = true;
  out.c[0] = snap(center[0]), out.c[1] = snap(center[1]), out.c[2] = radius * radius;
}

} // namespace

bool setup_box(const RasterDraw& draw, const ShadedVertices::Slot* corner, const WindowBox& box,
               RasterPrimitive& out) {
  if (!set_box(*draw.raster, box, out)) return false;
  set_constant_planes(draw, corner, out);
  return true;
}

bool setup_rectangle(const RasterDraw& draw, const PixelRectangle& rectangle, RasterPrimitive& out) {
  if (!setup_box(draw, rectangle.corner, rectangle.box, out)) return false;
  out.back = false;
  return true;
}

bool place_point(const RasterDraw& draw, const ShadedVertices::Slot* corner, PointPlace& out) {
  const RasterConstants& r = *draw.raster;
  const float* v = corner->v;
  if (!(std::fabs(v[0]) < 65536.0f && std::fabs(v[1]) < 65536.0f))
    return false; // also drops what is not a number
  float size = draw.layout.point >= 0 ? corner[draw.layout.point].v[0] : r.point_size;
  size = size > 0.0f ? std::min(size, 255.0f) : 0.0f;
  const int32_t bottom = r.top_edge_rule ? 0 : 1; // centers on the lowest row's edge are inside
  if (r.point_sprite || r.per_sample) {
    const int32_t width = std::max(256, snap(size)), left = snap(v[0] - r.pixel_center) - width / 2,
                  top = snap(v[1] - r.pixel_center) - width / 2;
    out = {{(left + r.to_first_pixel) >> 8, (top + r.to_first_pixel + bottom) >> 8, (left + width + 255) >> 8,
            (top + width + 255 + bottom) >> 8},
           size,
           width,
           left,
           top};
  } else {
    const int32_t x = snap(v[0]), y = snap(v[1]) - bottom, width = std::max(256, (snap(size) + 127) & ~255),
                  n = width >> 8;
    const int32_t x0 = n & 1 ? (x >> 8) - (n - 1) / 2 : ((x + 128) >> 8) - n / 2,
                  y0 = n & 1 ? (y >> 8) - (n - 1) / 2 : ((y + 128) >> 8) - n / 2;
    out = {{x0, y0, x0 + n, y0 + n}, size, width, 0, 0};
  }
  out.box = {std::max(out.box.x0, r.x0), std::max(out.box.y0, r.y0), std::min(out.box.x1, r.x1),
             std::min(out.box.y1, r.y1)};
  return out.box.x0 < out.box.x1 && out.box.y0 < out.box.y1;
}

bool setup_point(const RasterDraw& draw, const ShadedVertices::Slot* corner, bool back,
                 RasterPrimitive& out) {
  PointPlace place;
  return place_point(draw, corner, place) && setup_placed_point(draw, corner, place, back, out);
}

bool setup_placed_point(const RasterDraw& draw, const ShadedVertices::Slot* corner, const PointPlace& place,
                        bool back, RasterPrimitive& out) {
  const RasterConstants& r = *draw.raster;
  if (!setup_box(draw, corner, place.box, out)) return false;
  const float* v = corner->v;
  if (r.per_sample && r.point_sprite) set_square(place.left, place.top, place.width, r.top_edge_rule, out);
  if (r.per_sample && !r.point_sprite) set_circle(v, std::max(place.size, 1.0f), out);
  out.back = back;
  const float w = v[3];
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    if (draw.unit_plane[u] < 0 || !(r.sprite_units >> u & 1)) continue;
    // Across the square s and t go from 0 to 1.
    const float gradient = 256.0f / static_cast<float>(place.width),
                gy = r.sprite_lower_left ? -gradient : gradient;
    const float x = v[0] - r.pixel_center, y = v[1] - r.pixel_center;
    Plane* p = out.plane + draw.unit_plane[u];
    p[0] = {(0.5f - (gradient * x + 0.0f * y)) * w, gradient * w, 0};
    p[1] = {(0.5f - (0.0f * x + gy * y)) * w, 0, gy * w};
    p[2] = {0, 0, 0};
    p[3] = {w, 0, 0};
  }
  return true;
}

} // namespace softgl
