// The smallest and the largest of many indices: which vertices a draw needs.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/gl_types.h"
#include "context/buffer_objects.h"

namespace softgl {

/// Bytes of an index of that type; 0: no type of indices.
constexpr uint32_t index_bytes(GLenum type) {
  return type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : type == GL_UNSIGNED_INT ? 4 : 0;
}

/// `count` > 0. The indices may have any alignment.
IndexRange index_range(const void* indices, GLenum type, uint32_t count);
/// The same, and copies them to `copy` in one go.
IndexRange copy_indices(const void* indices, GLenum type, uint32_t count, void* copy);
/// The same for a part of a buffer's storage, which the buffer remembers.
IndexRange index_range(BufferObject& buffer, size_t offset, GLenum type, uint32_t count);

inline uint32_t load_index(const void* indices, GLenum type, uint32_t i) {
  const auto* bytes = static_cast<const unsigned char*>(indices);
  if (type == GL_UNSIGNED_BYTE) return bytes[i];
  if (type == GL_UNSIGNED_SHORT) {
    uint16_t v;
    __builtin_memcpy(&v, bytes + size_t(i) * 2, 2);
    return v;
  }
  uint32_t v;
  __builtin_memcpy(&v, bytes + size_t(i) * 4, 4);
  return v;
}

} // namespace softgl
