// The entry of this room: what the frame calls to turn a draw's vertices into primitives in window space.
#pragma once

#include <cstdint>

#include "base/arena.h"
#include "draw/assembled_primitives.h"
#include "draw/draw_record.h"

namespace softgl {

/// How many steps a primitive takes: points, line segments, triangles or quadrilaterals it is made of (a
/// polygon: triangles). Work is cut into chunks at steps.
uint32_t assembly_steps(const PrimitiveRange& range);

/// A run of neighbouring elements of a primitive.
struct ElementRange {
  uint32_t first, count;
};
/// The elements that steps [first_step, first_step + step_count) of a primitive of the draw read, if they lie
/// side by side and the steps depend on nothing else; otherwise a range of none.
ElementRange elements_of_steps(const DrawRecord& draw, const PrimitiveRange& range, uint32_t first_step,
                               uint32_t step_count);

/// Memory for vertices [first, first + count) of the draw, and for what the kernels write behind them.
ShadedVertices* allocate_vertices(const DrawRecord& draw, uint32_t first, uint32_t count, Arena& arena);
/// Shades vertices [first, first + count) of the draw into `out`, whose own first and count describe its
/// memory. `first` lies a multiple of 64 behind out.first. Safe from several threads for disjoint ranges.
/// With `leave_clipped` vertices that all lie outside of one clipping plane only get their masks: no
/// primitive of such vertices alone is seen (GL 1.5, 2.12). Gives the bits of those planes, or else 0.
uint16_t shade_vertices(const DrawRecord& draw, uint32_t first, uint32_t count, const ShadedVertices& out,
                        bool leave_clipped = false);

/// Assembles, clips and hands over steps [first_step, first_step + step_count) of a primitive, in drawing
/// order. Vertices made by clipping are taken from `arena`. The last batch of a call may be partly filled.
void assemble(const DrawRecord& draw, const ShadedVertices& vertices, const PrimitiveRange& range,
              uint32_t first_step, uint32_t step_count, Arena& arena, PrimitiveSink& sink);

} // namespace softgl
