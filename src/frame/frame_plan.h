// How the work of a flush is cut: pieces of draws, portions for one worker, and the lists of the tiles.
#pragma once

#include <cstdint>
#include <vector>

#include "draw/clear_record.h"
#include "draw/draw_record.h"
#include "frame/frame.h"
#include "frame/planned_vertices.h"
#include "raster/tile_list.h"
#include "shaders/raster/raster_draw.h"

namespace softgl {

/// A part of a draw: steps of one primitive, or the whole draw when it is small.
struct Piece {
  const DrawRecord* draw;
  const RasterDraw* raster;
  const ShadedVertices* vertices;   // null: they are shaded with the piece
  uint32_t primitive, first, count; // count 0: the whole draw
};

/// What one worker does at a time: pieces, or a clear.
struct Portion {
  uint32_t first_piece = 0, piece_count = 0;
  const ClearRecord* clear = nullptr;
  // Of a clear: before it in this frame stencil values may have been written, and fragments are counted.
  bool stencil_drawn = false, samples_counted = false;
  const TileLists::Touched* touched = nullptr;
  uint32_t touched_count = 0;
};

struct Frame::Plan {
  std::vector<TileChunk*> head, tail; // of each tile's list; null: it is empty
  std::vector<uint32_t> busy;         // tiles with work
  PlannedVertices vertices;
  std::vector<Piece> pieces;
  std::vector<Portion> portions;

  /// Forgets an earlier flush, whose work may have been dropped half done.
  void begin(size_t tiles) {
    head.assign(tiles, nullptr);
    tail.assign(tiles, nullptr);
    busy.clear(), vertices.clear(), pieces.clear(), portions.clear();
  }
  /// Gives the memory back.
  void release() { *this = {}; }
};

} // namespace softgl
