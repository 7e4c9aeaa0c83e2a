// The vertices that a frame shades: all of a draw before its primitives are assembled, or those of a piece.
#pragma once

#include <cstdint>
#include <vector>

#include "draw/draw_record.h"
#include "geometry/geometry.h"

namespace softgl {

/// Vertices of draws, shaded side by side in chunks of constant size. Those of a draw that one clipping plane
/// clips are left: programs that draw what the viewer does not see are common (half of the vertices of a
/// figure of MuJoCo with shadows and a mirror).
class PlannedVertices {
public:
  /// Memory for all vertices of the draw, which the next shade() fills.
  const ShadedVertices* add(const DrawRecord& draw, Arena& arena);
  /// Shades what was added since the last call, or clear().
  void shade();
  void clear() { chunks_.clear(); }

private:
  struct Chunk {
    const DrawRecord* draw;
    ShadedVertices* vertices;
    uint32_t first, count;
    uint16_t clipped; // bits of planes that clip all of them: then only their masks are set
  };
  void shade_chunks(bool leave_clipped);

  std::vector<Chunk> chunks_; // those of a draw side by side
};

/// Vertices [first, first + count) of the draw, shaded at once; not where one plane clips all of them.
const ShadedVertices* shade_vertices_of_piece(const DrawRecord& draw, uint32_t first, uint32_t count,
                                              Arena& arena);

} // namespace softgl
