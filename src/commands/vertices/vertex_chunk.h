// The insides of the vertex builder: the chunk of memory that vertices are written to, and their layout.
#pragma once

#include <new>

#include "context/context.h"

namespace softgl {

constexpr size_t kSmallestChunk = 64 * 1024; // bytes

/// Opens a chunk of at least that many bytes where none is open. Throws std::bad_alloc.
void open_chunk(Context& context, size_t minimum = kSmallestChunk);
/// Moves the vertices of the chunk to one with room for `bytes`. Throws std::bad_alloc.
void grow_chunk(Context& context, size_t bytes);
/// The builder's limit: a vertex fits while `out` is below it.
float* room_end(const VertexBuilder& builder);

/// Gives an attribute a slot behind the others; the vertices that wait get the value `earlier`. Throws
/// std::bad_alloc.
void add_slot(Context& context, int slot, const float* earlier);
/// Takes the slot of an attribute out of the vertices that wait.
void remove_slot(VertexBuilder& builder, int slot);

/// No chunk is open afterwards. Its memory belongs to the frame, to a run, or is freed.
void forget_vertices(VertexBuilder& builder);
/// Afterwards a vertex has a position only.
void forget_layout(VertexBuilder& builder);

/// What is done when std::bad_alloc ends the way of a vertex, live or into a list: GL_OUT_OF_MEMORY. The
/// vertices that wait are dropped, and those of an open primitive until its End. A list that is being
/// compiled fails.
void drop_vertices(Context& context);
/// Calls function(), and drop_vertices() if it throws std::bad_alloc.
template <class Function> void or_drop_vertices(Context& context, Function&& function) {
  try {
    function();
  } catch (const std::bad_alloc&) { drop_vertices(context); }
}

/// While alive, the vertices of an open primitive are not in the frame's arena, which may then be reset: for
/// flushes between Begin and End. Without memory for that they are dropped.
class VerticesAside {
public:
  explicit VerticesAside(Context& context);
  ~VerticesAside();
  VerticesAside(const VerticesAside&) = delete;
  VerticesAside& operator=(const VerticesAside&) = delete;

private:
  Context& context_;
  std::vector<float> vertices_;
  bool open_;
};

/// Vertices of one primitive: how many of `count` make whole primitives of that mode.
uint32_t complete_vertices(GLenum mode, uint32_t count);

} // namespace softgl
