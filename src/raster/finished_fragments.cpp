// Points of a few pixels, thin lines and bitmaps become fragments before there are tiles.
#include <algorithm>
#include <cstring>

#include "base/assert.h"
#include "base/fast_paths.h"
#include "draw/draw_record.h"
#include "raster/line_setup.h"
#include "raster/line_steps.h"
#include "raster/point_setup.h"
#include "raster/tile_binner.h"
#include "shaders/fragment/fragment_constants.h"
#include "shaders/fragment/pixel_image.h"

namespace softgl {
namespace {

/// A run is some 30 fragments long, for which a call of memcpy is as much work as the copy.
template <class T> void copy_run(const T* from, T* to, uint32_t count) {
  constexpr uint32_t kStep = 16 / sizeof(T);
  if (count < kStep) {
    for (uint32_t i = 0; i < count; ++i) to[i] = from[i];
    return;
  }
  auto step = [&](uint32_t i) { std::memcpy(to + i, from + i, 16); };
  for (uint32_t i = 0; i < count - kStep; i += kStep) step(i);
  step(count - kStep);
}

/// The parts of pixel_in_tile() by column and by row.
struct TilePixels {
  uint16_t pixel[64];
};
TilePixels pixels_of(int column, int row) {
  TilePixels pixels{};
  for (int i = 0; i < 64; ++i) pixels.pixel[i] = static_cast<uint16_t>(pixel_in_tile(column * i, row * i));
  return pixels;
}
const TilePixels kTileColumns = pixels_of(1, 0), kTileRows = pixels_of(0, 1);

} // namespace

void TileBinner::append_finished(uint32_t tile, const uint16_t* pixel, const uint32_t* depth,
                                 const uint32_t* color, int32_t count) {
  while (count > 0) {
    uint32_t given = 0;
    const SmallFragments f = lists_.append_fragments(tile, draw_, static_cast<uint32_t>(count), given);
    copy_run(pixel, f.pixel, given);
    copy_run(depth, f.depth, given);
    copy_run(color, f.color, given);
    pixel += given, depth += given, color += given, count -= static_cast<int32_t>(given);
  }
}

/// A point of more pixels is a box. Measured: 500,000 points of 1 pixel take 15 ms instead of 52, of 3x3
/// pixels 36 instead of 59, of 5x5 pixels 73 instead of 66.
constexpr int32_t kMostPointPixels = 16;

/// Whether the draw's points of a few pixels are finished fragments: no stage runs, and all are alike.
bool TileBinner::finishes_points() const {
  const bool few =
      draw_->layout.point >= 0 || draw_->raster->point_size * draw_->raster->point_size <= kMostPointPixels;
  return few && finishes_points_ && draw_->small && draw_->program->step_count == 0 && !draw_->back_face &&
         !draw_->smooth_point;
}

void TileBinner::append_point(const WindowBox& box, uint32_t depth, uint32_t color) {
  uint32_t left = 0;
  SmallFragments f{};
  for (int32_t y = box.y0; y < box.y1; ++y)
    for (int32_t x = box.x0; x < box.x1; ++x) {
      if (left == 0) {
        const int32_t end = std::min(box.x1, (x | 63) + 1); // of the row in this tile
        f = lists_.append_fragments(static_cast<uint32_t>((y >> 6) * tiles_x_ + (x >> 6)), draw_,
                                    static_cast<uint32_t>(end - x), left);
      }
      *f.pixel++ = static_cast<uint16_t>(pixel_in_tile(x & 63, y & 63));
      *f.depth++ = depth;
      *f.color++ = color;
      --left;
    }
}

void TileBinner::finished_points(const AssembledPoints& batch) {
  count_as_taken(FastPath::Points);
  uint32_t depth[kAssemblyBatch + 16], color[kAssemblyBatch + 16]; // room for a vector behind the last
  kernels_.raster->shade_points(*draw_, batch.corner, batch.count, depth, color);
  for (int32_t i = 0; i < batch.count; ++i) {
    PointPlace place;
    if (!place_point(*draw_, batch.corner[i], place)) continue;
    const WindowBox& box = place.box;
    if ((box.x1 - box.x0) * (box.y1 - box.y0) <= kMostPointPixels) {
      append_point(box, depth[i], color[i]);
      continue;
    }
    RasterPrimitive* p = new_primitive();
    if (setup_placed_point(*draw_, batch.corner[i], place, batch.back >> i & 1, *p)) bin(*p);
  }
}

/// Wider lines are blocks of pixels. Measured with one color and a depth test, us a line of 20 (300) pixels
/// at most along each axis, finished or not: width 1 0.24 or 0.41 (1.5 or 2.9), 2 0.34 or 0.43 (2.6 or 3.2),
/// 3 0.45 or 0.45 (3.5 or 3.4).
constexpr int32_t kMostLineWidth = 2;

/// Whether the draw's lines are finished fragments: no stage runs, and they are thin.
bool TileBinner::finishes_lines() const {
  return finishes_lines_ && draw_->small && draw_->program->step_count == 0 && !draw_->back_face &&
         !draw_->smooth_line && !draw_->raster->per_sample &&
         draw_->raster->line_width < kMostLineWidth + 0.5f;
}

/// The fragments of a line, whose depths and colors are those of its pixels along the major axis.
void TileBinner::append_line(const LineSpan& span, const LineSteps& steps, const uint32_t* depth,
                             const uint32_t* color) {
  const RasterConstants& r = *draw_->raster;
  const int32_t low = steps.x_major ? r.y0 : r.x0, high = steps.x_major ? r.y1 : r.x1;
  const uint16_t* const along = steps.x_major ? kTileColumns.pixel : kTileRows.pixel;
  const uint16_t* const across = steps.x_major ? kTileRows.pixel : kTileColumns.pixel;
  const auto minor_tile = uint32_t(steps.x_major ? tiles_x_ : 1),
             major_tile = uint32_t(steps.x_major ? 1 : tiles_x_);
  uint16_t pixel[kMostLinePixels];
  for (int32_t side = 0; side < steps.width; ++side) { // one thin line beside the other
    int64_t minor = steps.minor + (int64_t(side) << LineSteps::kFraction);
    auto place = [&] { return static_cast<int32_t>(minor >> LineSteps::kFraction); };
    int32_t i = 0;
    while (i < span.count && (place() < low || place() >= high)) ++i, minor += steps.slope;
    while (i < span.count && place() >= low && place() < high) {
      const int32_t m = span.first + i, in_tile = place() & ~63;
      const int32_t tile_end = std::min(span.count, i + 64 - (m & 63)), first = i;
      const int32_t from = std::max(low, in_tile);
      const auto rows = static_cast<uint32_t>(std::min(high, in_tile + 64) - from);
      const uint16_t* const column = along + (m & 63) - i;
      int32_t n = place();
      do {
        pixel[i] = static_cast<uint16_t>(column[i] | across[n & 63]);
        minor += steps.slope;
        n = place();
      } while (++i < tile_end && static_cast<uint32_t>(n - from) < rows);
      const uint32_t tile = uint32_t(m >> 6) * major_tile + uint32_t(in_tile >> 6) * minor_tile;
      append_finished(tile, pixel + first, depth + first, color + first, i - first);
    }
  }
}

void TileBinner::finished_lines(const AssembledLines& batch) {
  count_as_taken(FastPath::Lines);
  constexpr int32_t kFragments = 2048; // shaded at a time
  LineSpan span[kAssemblyBatch];
  LineSteps steps[kAssemblyBatch];
  uint32_t depth[kFragments + 16], color[kFragments + 16]; // room for a vector behind the last
  int32_t lines = 0, fragments = 0;
  auto finish = [&] {
    kernels_.raster->shade_lines(*draw_, span, lines, depth, color);
    int32_t first = 0;
    for (int32_t i = 0; i < lines; first += span[i++].count)
      append_line(span[i], steps[i], depth + first, color + first);
    lines = fragments = 0;
  };
  for (int32_t i = 0; i < batch.count; ++i) {
    const ShadedVertices::Slot *corner0 = batch.corner[0][i], *corner1 = batch.corner[1][i];
    const LineKind kind = step_line(*draw_, corner0, corner1, span[lines], steps[lines]);
    if (kind == LineKind::Steps) {
      const int32_t count = span[lines].count;
      if (fragments + count > kFragments) {
        const LineSpan next_span = span[lines];
        const LineSteps next_steps = steps[lines];
        finish();
        span[0] = next_span, steps[0] = next_steps;
      }
      ++lines, fragments += count;
    } else if (kind == LineKind::Other) {
      finish();
      RasterPrimitive* p = new_primitive();
      if (setup_line(*draw_, corner0, corner1, batch.back >> i & 1, *p)) bin(*p);
    }
  }
  finish();
}

/// Whether the draw is a bitmap whose fragments need nothing but their bits.
bool TileBinner::finishes_bitmap() const {
  const PixelImage* image = draw_->program->constants->image;
  return finishes_bitmaps_ && draw_->small && draw_->program->step_count == 1 && image &&
         image->kind == PixelElement::Bit;
}

void TileBinner::finished_bitmap(const PixelRectangle& rectangle) {
  count_as_taken(FastPath::Bitmaps);
  uint32_t depth[1 + 16], color[1 + 16]; // room for a vector
  kernels_.raster->shade_points(*draw_, &rectangle.corner, 1, depth, color);
  const RasterConstants& r = *draw_->raster;
  const PixelImage& image = *draw_->program->constants->image;
  const auto* element = static_cast<const uint8_t*>(image.element);
  const int32_t x0 = std::max(rectangle.box.x0, r.x0), x1 = std::min(rectangle.box.x1, r.x1);
  const int32_t y0 = std::max(rectangle.box.y0, r.y0), y1 = std::min(rectangle.box.y1, r.y1);
  for (int32_t ty = y0 >> 6; ty <= (y1 - 1) >> 6; ++ty)
    for (int32_t tx = x0 >> 6; tx <= (x1 - 1) >> 6; ++tx) {
      const int32_t left = std::max(x0, tx * 64), right = std::min(x1, tx * 64 + 64);
      uint16_t pixel[kTilePixels + 1];
      uint32_t count = 0;
      for (int32_t y = std::max(y0, ty * 64); y < std::min(y1, ty * 64 + 64); ++y) {
        const uint8_t* const row = element + image.row[y - image.y0];
        for (int32_t x = left; x < right; ++x) {
          pixel[count] = static_cast<uint16_t>(kTileColumns.pixel[x & 63] | kTileRows.pixel[y & 63]);
          count += row[image.column[x - image.x0]] != 0;
        }
      }
      for (uint32_t done = 0, given; done < count; done += given) {
        const SmallFragments f =
            lists_.append_fragments(static_cast<uint32_t>(ty * tiles_x_ + tx), draw_, count - done, given);
        copy_run(pixel + done, f.pixel, given);
        std::fill(f.depth, f.depth + given, depth[0]);
        std::fill(f.color, f.color + given, color[0]);
      }
    }
}

} // namespace softgl
