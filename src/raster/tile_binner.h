// Takes assembled primitives and puts them into the lists of the tiles they touch.
#pragma once

#include "base/fast_paths.h"
#include "base/kernel_table.h"
#include "draw/assembled_primitives.h"
#include "raster/tile_list.h"
#include "shaders/common/surface.h"
#include "shaders/raster/raster_triangles.h"

namespace softgl {

struct LineSpan;       // shaders/raster/raster_lines.h
struct LineSteps;      // line_steps.h
struct PixelRectangle; // frame/draw_record.h
struct WindowBox;      // draw/draw_call.h

/// Memory that a binner works in; one per worker. All of it is zero at first.
struct BinnerScratch {
  TriangleOutput output;
  FragmentBlock block;
};

class TileBinner final : public PrimitiveSink {
public:
  TileBinner(const Surface& surface, TileLists& lists, Arena& arena, BinnerScratch& scratch,
             const Kernels& kernels = softgl::kernels())
      : tiles_x_(surface.tiles_x), lists_(lists), arena_(arena), scratch_(scratch), kernels_(kernels) {}

  /// The draw that the next batches belong to. Their vertices should not be kept when they are read
  /// `in_order`.
  void set_draw(const RasterDraw* draw, bool in_order = false) {
    draw_ = draw;
    const bool one = draw && draw->raster->samples == 1; // sample: only those fragments are finished
    tiny_pixels_ = !one || !is_enabled(FastPath::Tiny) ? 0 : in_order ? kTinyPixelsInOrder : kTinyPixels;
    shares_planes_ = is_enabled(FastPath::SharedPlanes);
    finishes_points_ = one && is_enabled(FastPath::Points);
    finishes_lines_ = one && is_enabled(FastPath::Lines);
    finishes_bitmaps_ = one && is_enabled(FastPath::Bitmaps);
    keeps_vertices_ = false;
  }
  /// True when lists point to vertices of the batches since set_draw().
  bool keeps_vertices() const { return keeps_vertices_; }

  void triangles(const DrawRecord& draw, const AssembledTriangles& batch) override;
  void lines(const DrawRecord& draw, const AssembledLines& batch) override;
  void points(const DrawRecord& draw, const AssembledPoints& batch) override;
  void rectangle(const PixelRectangle& rectangle);

private:
  void both_faces(const AssembledTriangles& batch);
  void triangles_of_face(const AssembledTriangles& batch);
  void bin_triangles(const AssembledTriangles& batch);
  void smooth_triangles(const AssembledTriangles& batch);
  bool finishes_points() const;
  void finished_points(const AssembledPoints& batch);
  void append_point(const WindowBox& box, uint32_t depth, uint32_t color);
  bool finishes_lines() const;
  void finished_lines(const AssembledLines& batch);
  void append_line(const LineSpan& span, const LineSteps& steps, const uint32_t* depth,
                   const uint32_t* color);
  bool finishes_bitmap() const;
  void finished_bitmap(const PixelRectangle& rectangle);
  /// Fragments of one tile.
  void append_finished(uint32_t tile, const uint16_t* pixel, const uint32_t* depth, const uint32_t* color,
                       int32_t count);
  void smooth_line(const ShadedVertices::Slot* const end[2], bool back);
  RasterPrimitive* new_primitive();
  void bin(const RasterPrimitive& primitive);
  void bin_small(const AssembledTriangles& batch, const TriangleOutput& out, uint64_t small);
  void bin_further(const SmallTriangle& triangle, uint32_t tile, uint32_t further);
  void append_run(const TriangleOutput& out, uint32_t tile, int32_t first, int32_t last);
  void append_living(const TriangleOutput& out, uint32_t tile, int32_t first, int32_t last);

  int32_t tiles_x_;
  TileLists& lists_;
  Arena& arena_;
  BinnerScratch& scratch_;
  const Kernels& kernels_;
  const RasterDraw* draw_ = nullptr;
  int32_t tiny_pixels_ = kTinyPixels;
  bool shares_planes_ = true, finishes_points_ = true, finishes_lines_ = true, finishes_bitmaps_ = true;
  bool keeps_vertices_ = false;
  uint8_t *next_ = nullptr, *end_ = nullptr; // memory for primitives
};

} // namespace softgl
