// From the vertex arrays to the streams of a draw: buffers are shared with the frame, client memory is
// copied.
#pragma once

#include "context/context.h"

namespace softgl {

/// The cache, brought up to date. Sets GL_INVALID_OPERATION and gives null if an enabled array's buffer is
/// mapped.
ArrayCache* current_arrays(Context& context);

/// Streams for vertices low..high of the arrays; client memory is copied to the frame's arena.
const VertexSource* fetch_range(Context& context, ArrayCache& arrays, uint32_t low, uint32_t high);

/// Copies the vertices that `count` indices name to the frame's arena, each once. Gives their number, their
/// streams and the new indices. An element behind the end of a buffer is zero.
struct CompactVertices {
  const VertexSource* source;
  const uint32_t* indices;
  uint32_t vertex_count;
};
CompactVertices compact(Context& context, ArrayCache& arrays, const void* indices, GLenum type,
                        uint32_t count);

/// One element as the array's stream describes it; `to` has room for array.converted bytes, and four at
/// least.
void copy_element(const ArrayCache::Array& array, const unsigned char* from, unsigned char* to);

} // namespace softgl
