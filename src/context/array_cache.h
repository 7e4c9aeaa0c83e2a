// What the last draw from vertex arrays found out about them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "draw/draw_call.h"

namespace softgl {

struct BufferObject;
struct BufferStorage;

/// The enabled arrays, as the draws see them. Made anew when kDirtyArrays is set or a buffer has changed.
struct ArrayCache {
  /// How elements lie in memory: as the stream says, as bytes b g r a, or as floats of 16 bits. The last two
  /// are converted when they are copied.
  enum class Form : uint8_t { Plain, Bgra, Half };
  struct Array {
    int slot;
    uint32_t bytes;     // of an element in memory
    uint32_t converted; // bytes of one that has been converted
    uint64_t limit;     // elements that may be read; client memory: as many as one likes
    bool client;
    Form form;
    AttributeStream stream;
  };
  Array array[kMaterial0];
  int count = 0;
  bool drawable = false; // there are positions
  bool client = false;   // some are in client memory
  bool converts = false; // some are not Form::Plain
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

} // namespace softgl
