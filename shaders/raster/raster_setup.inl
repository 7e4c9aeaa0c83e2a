// Set-up of triangles that are drawn tile by tile.
#pragma once

#include "shaders/raster/raster_planes.inl"
#include "shaders/raster/raster_snap.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Sets up the large triangles of a batch: planes and edges into *record[i].
static void setup_triangles(const RasterDraw& draw, const TriangleInput& in, const TriangleOutput& batch,
                            RasterPrimitive* const* record) {
  const RasterConstants& r = *draw.raster;
  const int32_t flip = r.top_edge_rule ? -1 : 0, bottom = r.top_edge_rule ? 0 : 1; // EdgeRule
  StoredPlanes planes;
  alignas(64) int32_t x[3][kWidth], y[3][kWidth];
  for (uint64_t left = batch.large; left;) {
    uint8_t numbers[kWidth];
    int lanes = 0;
    for (; left && lanes < kWidth; left &= left - 1) numbers[lanes++] = uint8_t(__builtin_ctzll(left));
    for (int i = lanes; i < kWidth; ++i) numbers[i] = numbers[0];
    SmallTriangle triangle[kWidth];
    find_corners(draw, in, batch, numbers, triangle);
    CornerPlanes made(triangle, r.pixel_center);
    for (int k = 0; k < 3; ++k) {
      store(x[k], round_to_int(snap_scaled(made.position[k][0], r.pixel_center)));
      store(y[k], round_to_int(snap_scaled(made.position[k][1], r.pixel_center)));
    }
    store_planes(draw, made, planes);
    for (int i = 0; i < lanes; ++i) {
      RasterPrimitive& q = **record++;
      for (int k = 0; k < draw.plane_count; ++k)
        q.plane[k] = {planes.plane[k][0][i], planes.plane[k][1][i], planes.plane[k][2][i]};
      q.w_is_one = q.plane[kPlaneW].a == 1.0f && q.plane[kPlaneW].gx == 0.0f && q.plane[kPlaneW].gy == 0.0f;
      q.depth_offset = planes.offset[i];
      q.edges = 3;
      q.back = planes.back[i] != 0;
      q.round = false;
      int32_t min_x = x[0][i], max_x = min_x, min_y = y[0][i], max_y = min_y;
      for (int k = 0; k < 3; ++k) {
        const int j = k == 2 ? 0 : k + 1;
        const int32_t ea = y[k][i] - y[j][i], eb = x[k][i] - x[j][i];
        const int64_t ec = int64_t(ea) * x[k][i] - int64_t(eb) * y[k][i] +
                           ((ea < 0 || (ea == 0 && (eb ^ flip) < 0)) ? 1 : 0);
        q.a[k] = ea, q.b[k] = eb, q.c[k] = (ec - 1) >> r.edge_shift;
        min_x = x[k][i] < min_x ? x[k][i] : min_x, max_x = x[k][i] > max_x ? x[k][i] : max_x;
        min_y = y[k][i] < min_y ? y[k][i] : min_y, max_y = y[k][i] > max_y ? y[k][i] : max_y;
      }
      q.a[3] = q.b[3] = 0, q.c[3] = 0;
      const int32_t px0 = (min_x + r.to_first_pixel) >> 8, px1 = ((max_x - 1) >> 8) + 1;
      const int32_t py0 = (min_y + r.to_first_pixel + bottom) >> 8, py1 = ((max_y - 1 + bottom) >> 8) + 1;
      q.x0 = px0 > r.x0 ? px0 : r.x0, q.x1 = px1 < r.x1 ? px1 : r.x1;
      q.y0 = py0 > r.y0 ? py0 : r.y0, q.y1 = py1 < r.y1 ? py1 : r.y1;
    }
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
