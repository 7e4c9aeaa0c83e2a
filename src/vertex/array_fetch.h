// From the vertex arrays to the streams of a draw: buffers are shared with the frame, client memory is
// copied.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "frame/draw_call.h"

namespace softgl {

struct Context;
struct BufferObject;
struct BufferStorage;

/// The enabled arrays, as the draws see them. Made anew when kDirtyArrays is set or a buffer has changed.
struct ArrayCache {
  struct Array {
    int slot;
    uint32_t bytes; // of an element
    uint64_t limit; // elements that may be read; client memory: as many as one likes
    bool client;
    AttributeStream stream;
  };
  Array array[kMaterial0];
  int count = 0;
  bool drawable = false; // there are positions
  bool client = false;   // some are in client memory
  uint64_t limit = 0;    // elements that every array has
  struct Watched {
    const BufferObject* object;
    uint64_t version;
  } watched[kMaterial0];
  int watched_count = 0;
  const VertexSource* source = nullptr; // in the frame's arena; only when all arrays are in buffers
  const BufferStorage* retained_indices = nullptr; // the frame holds it already

  std::vector<uint32_t> table, used; // scratch of compact()
};

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

} // namespace softgl
