#include "raster/tile_binner.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "base/assert.h"
#include "base/fast_paths.h"
#include "raster/line_setup.h"
#include "raster/point_setup.h"
#include "raster/smooth_primitives.h"

namespace softgl {

RasterPrimitive* TileBinner::new_primitive() {
  // Planes are read by 16 bytes, 4 behind the last one.
  const size_t bytes =
      (offsetof(RasterPrimitive, plane) + sizeof(Plane) * draw_->plane_count + 4 + 15) & ~size_t(15);
  if (static_cast<size_t>(end_ - next_) < bytes) {
    constexpr size_t kBlock = 16 * 1024;
    next_ = static_cast<uint8_t*>(arena_.allocate(kBlock));
    end_ = next_ + kBlock;
  }
  auto* p = reinterpret_cast<RasterPrimitive*>(next_);
  next_ += bytes;
  return p;
}

void TileBinner::bin(const RasterPrimitive& p) {
  if (p.x0 >= p.x1 || p.y0 >= p.y1) return;
  SOFTGL_ASSERT(p.x0 >= 0 && p.y0 >= 0 && p.x1 <= tiles_x_ * kTileSize && p.edges >= 0 && p.edges <= 4);
  const int32_t tx0 = p.x0 >> 6, tx1 = (p.x1 - 1) >> 6, ty0 = p.y0 >> 6, ty1 = (p.y1 - 1) >> 6;
  const bool many = tx1 > tx0 || ty1 > ty0;
  for (int32_t ty = ty0; ty <= ty1; ++ty)
    for (int32_t tx = tx0; tx <= tx1; ++tx) {
      if (many) {
        bool outside = false;
        for (int i = 0; i < p.edges; ++i) {
          const int64_t a = p.a[i], b = p.b[i];
          // No sample point lies more than a pixel from the corner.
          const int64_t c =
              draw_->raster->per_sample ? (p.c[i] >> 8) + std::abs(a) + std::abs(b) + 1 : p.c[i];
          const int64_t best = c - a * (tx * kTileSize) + b * (ty * kTileSize) +
                               (kTileSize - 1) * ((a < 0 ? -a : 0) + (b > 0 ? b : 0));
          outside = outside || best < 0;
        }
        if (outside) continue;
      }
      lists_.append_primitive(static_cast<uint32_t>(ty * tiles_x_ + tx), draw_, &p);
    }
}

void TileBinner::append_run(const TriangleOutput& out, uint32_t tile, int32_t first, int32_t last) {
  append_finished(tile, out.pixel + first, out.depth + first, out.color + first, last - first);
}

void TileBinner::append_living(const TriangleOutput& out, uint32_t tile, int32_t first, int32_t last) {
  while (first < last) {
    if (!out.live[first]) {
      ++first;
      continue;
    }
    int32_t end = first + 1;
    while (end < last && out.live[end]) ++end;
    append_run(out, tile, first, end);
    first = end;
  }
}

void TileBinner::bin_small(const AssembledTriangles& batch, const TriangleOutput& out, uint64_t small) {
  const bool back = draw_->raster->back;
  while (small) {
    // Neighbours mostly lie in one tile, so its list is looked up once for them.
    int i = std::countr_zero(small);
    const uint32_t tile = out.tile[i];
    uint32_t room = 0;
    SmallTriangle *next = lists_.begin_triangles(tile, draw_, room), *const end = next + room;
    do {
      const bool negative = out.negative >> i & 1;
      const SmallTriangle t = {{batch.corner[negative][i], batch.corner[!negative][i], batch.corner[2][i]},
                               back != negative};
      *next++ = t;
      if (out.further[i]) bin_further(t, tile, out.further[i]);
      small &= small - 1;
      i = std::countr_zero(small);
    } while (small && next != end && out.tile[i] == tile);
    lists_.end_triangles(tile, next);
  }
}

void TileBinner::bin_further(const SmallTriangle& t, uint32_t tile, uint32_t further) {
  const uint32_t next_row = tile + static_cast<uint32_t>(tiles_x_);
  if (further & 1) lists_.append_triangle(tile + 1, draw_, t);
  if (further & 2) lists_.append_triangle(next_row, draw_, t);
  if (further == 3) lists_.append_triangle(next_row + 1, draw_, t);
}

void TileBinner::triangles(const DrawRecord&, const AssembledTriangles& batch) {
  SOFTGL_ASSERT(draw_ && batch.count > 0 && batch.count <= kSetupBatch);
  if (draw_->back_face) [[unlikely]]
    both_faces(batch);
  else
    triangles_of_face(batch);
}

void TileBinner::triangles_of_face(const AssembledTriangles& batch) {
  if (draw_->smooth_polygon) [[unlikely]]
    smooth_triangles(batch);
  else
    bin_triangles(batch);
}

/// Triangles that face the same way, one after the other, are a batch.
void TileBinner::both_faces(const AssembledTriangles& batch) {
  const RasterDraw* const front = draw_;
  AssembledTriangles part;
  auto finish = [&] {
    if (part.count) triangles_of_face(part);
    part = {};
  };
  for (int i = 0; i < batch.count; ++i) {
    const ShadedVertices::Slot* const corner[3] = {batch.corner[0][i], batch.corner[1][i],
                                                   batch.corner[2][i]};
    SmoothTriangle snapped;
    if (!snap_smooth_triangle(*front, corner, snapped)) continue;
    const RasterDraw* face = front->raster->back != snapped.negative ? front->back_face : front;
    if (face != draw_) finish();
    draw_ = face;
    for (int k = 0; k < 3; ++k) {
      part.corner[k][part.count] = corner[k];
      part.inner[k] |= (batch.inner[k] >> i & 1) << part.count;
    }
    ++part.count;
  }
  finish();
  draw_ = front;
}

void TileBinner::bin_triangles(const AssembledTriangles& batch) {
  if (draw_->raster->cull == 3) return;
  const TriangleInput in = {batch.count,
                            tiles_x_,
                            tiny_pixels_,
                            shares_planes_,
                            {batch.corner[0], batch.corner[1], batch.corner[2]}};
  TriangleOutput& out = scratch_.output;
  kernels_.raster->prepare_triangles(*draw_, in, out, scratch_.block);
  RasterPrimitive* record[kSetupBatch];
  const int large_count = std::popcount(out.large);
  for (int i = 0; i < large_count; ++i) record[i] = new_primitive();
  if (large_count) kernels_.raster->setup_triangles(*draw_, in, out, record);
  // Small and large triangles enter the lists in the order of their numbers.
  uint64_t large = out.large;
  RasterPrimitive** next = record;
  auto bin_large_before = [&](int triangle) {
    for (; large && std::countr_zero(large) < triangle; large &= large - 1) bin(**next++);
  };
  if (out.tiny) {
    count_as_taken(FastPath::Tiny);
    if (out.shared_planes) count_as_taken(FastPath::SharedPlanes);
    const bool killing = draw_->program->tests_alpha();
    for (int32_t i = 0; i < out.run_count; ++i) {
      const TriangleOutput::Run& run = out.run[i];
      bin_large_before(run.triangle);
      if (killing)
        append_living(out, run.tile, run.first, out.run[i + 1].first);
      else
        append_run(out, run.tile, run.first, out.run[i + 1].first);
    }
    bin_large_before(kSetupBatch);
  } else {
    uint64_t small = out.small;
    if (small) count_as_taken(FastPath::Small);
    for (; large; large &= large - 1) {
      const uint64_t before = (large & -large) - 1;
      bin_small(batch, out, small & before);
      bin(**next++);
      small &= ~before;
    }
    bin_small(batch, out, small);
    keeps_vertices_ = keeps_vertices_ || out.small;
  }
}

void TileBinner::smooth_triangles(const AssembledTriangles& batch) {
  const RasterDraw* const plain = std::exchange(draw_, draw_->smooth_polygon);
  const TriangleInput in = {
      batch.count, tiles_x_, 0, false, {batch.corner[0], batch.corner[1], batch.corner[2]}};
  TriangleOutput& out = scratch_.output;
  out.large = out.negative = 0;
  SmoothTriangle triangle[kSetupBatch];
  RasterPrimitive* record[kSetupBatch];
  int count = 0;
  for (int i = 0; i < batch.count; ++i) {
    const ShadedVertices::Slot* const corner[3] = {batch.corner[0][i], batch.corner[1][i],
                                                   batch.corner[2][i]};
    if (!snap_smooth_triangle(*draw_, corner, triangle[count])) continue;
    out.large |= uint64_t(1) << i;
    out.negative |= uint64_t(triangle[count].negative) << i;
    record[count++] = new_primitive();
  }
  if (count) kernels_.raster->setup_triangles(*draw_, in, out, record);
  uint64_t left = out.large;
  for (int n = 0; n < count; ++n, left &= left - 1) {
    const int i = std::countr_zero(left);
    uint32_t inner = 0;
    for (int k = 0; k < 3; ++k) inner |= uint32_t(batch.inner[k] >> i & 1) << k;
    widen_smooth_triangle(*draw_, triangle[n], inner, *record[n]);
    bin(*record[n]);
  }
  draw_ = plain;
}

void TileBinner::smooth_line(const ShadedVertices::Slot* const end[2], bool back) {
  const RasterDraw* const plain = std::exchange(draw_, draw_->smooth_line);
  const ShadedVertices::Slot* corner[4];
  smooth_line_corners(*draw_, end, arena_, corner);
  // Areas are positive, and those that are not are back-facing: set-up exchanges these corners again.
  const int first = back, second = 1 - first;
  AssembledTriangles two;
  two.count = 2;
  two.corner[first][0] = corner[2], two.corner[second][0] = corner[1], two.corner[2][0] = corner[0];
  two.corner[first][1] = corner[3], two.corner[second][1] = corner[1], two.corner[2][1] = corner[2];
  bin_triangles(two);
  draw_ = plain;
}

void TileBinner::lines(const DrawRecord&, const AssembledLines& batch) {
  SOFTGL_ASSERT(draw_ && batch.count > 0 && batch.count <= kAssemblyBatch);
  if (finishes_lines()) return finished_lines(batch);
  const RasterDraw* const front = draw_;
  for (int32_t i = 0; i < batch.count; ++i) {
    const ShadedVertices::Slot* const end[2] = {batch.corner[0][i], batch.corner[1][i]};
    const bool back = batch.back >> i & 1;
    draw_ = back && front->back_face ? front->back_face : front;
    if (draw_->smooth_line) {
      smooth_line(end, back);
      continue;
    }
    RasterPrimitive* p = new_primitive();
    if (setup_line(*draw_, end[0], end[1], back, *p)) bin(*p);
  }
  draw_ = front;
}

void TileBinner::points(const DrawRecord&, const AssembledPoints& batch) {
  SOFTGL_ASSERT(draw_ && batch.count > 0 && batch.count <= kAssemblyBatch);
  if (finishes_points()) return finished_points(batch);
  const RasterDraw* const front = draw_;
  for (int32_t i = 0; i < batch.count; ++i) {
    const bool back = batch.back >> i & 1;
    draw_ = back && front->back_face ? front->back_face : front;
    const auto setup = draw_->smooth_point ? setup_smooth_point : setup_point;
    if (draw_->smooth_point) draw_ = draw_->smooth_point;
    RasterPrimitive* p = new_primitive();
    if (setup(*draw_, batch.corner[i], back, *p)) bin(*p);
  }
  draw_ = front;
}

void TileBinner::rectangle(const PixelRectangle& rectangle) {
  if (finishes_bitmap()) return finished_bitmap(rectangle);
  RasterPrimitive* p = new_primitive();
  if (setup_rectangle(*draw_, rectangle, *p)) bin(*p);
}

} // namespace softgl
