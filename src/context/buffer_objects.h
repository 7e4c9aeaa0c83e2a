// Buffer objects (GL 1.5, 2.9): memory of the server for vertices and indices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "base/gl_types.h"

namespace softgl {

/// The bytes of a buffer. A frame that draws from them holds a reference; then they are copied before they
/// change.
struct BufferStorage {
  explicit BufferStorage(size_t bytes); // contents undefined: zero; throws std::bad_alloc
  ~BufferStorage();
  BufferStorage(const BufferStorage&) = delete;
  BufferStorage& operator=(const BufferStorage&) = delete;

  static constexpr size_t kSpareBytes = 64; // readable behind the end: kernels load 16 bytes at a time
  unsigned char* bytes;
  size_t size;
};

/// The smallest and the largest index of a part of a buffer.
struct IndexRange {
  uint32_t low = 0, high = 0;
};

struct BufferObject {
  std::shared_ptr<BufferStorage> storage; // null: size 0
  std::string label;                      // GL_KHR_debug
  GLenum usage = GL_STATIC_DRAW, access = GL_READ_WRITE;
  bool mapped = false;
  GLbitfield access_flags = 0;         // how it is mapped: GL_MAP_READ_BIT ... (GL_ARB_map_buffer_range)
  size_t map_offset = 0, map_size = 0; // which bytes
  uint64_t version = 0;                // counts changes of the contents

  /// Ranges that were asked for since the last change: drawing the same indices again need not look at them.
  struct CachedRange {
    uint64_t version = ~0ull;
    size_t offset = 0;
    uint32_t count = 0;
    GLenum type = 0;
    IndexRange range;
  };
  static constexpr size_t kCachedRanges = 256;
  std::unique_ptr<CachedRange[]> ranges;
  std::mutex ranges_mutex; // contexts of several threads may draw from one buffer

  size_t size() const { return storage ? storage->size : 0; }
};

} // namespace softgl
