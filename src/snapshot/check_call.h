// Assertions about a draw call, where it enters the frame.
#pragma once

#include "base/assert.h"
#include "draw/draw_call.h"

namespace softgl {

inline uint32_t index_of_call(const DrawCall& call, uint32_t i) {
  switch (call.index_type) {
  case GL_UNSIGNED_BYTE: return static_cast<const uint8_t*>(call.indices)[i];
  case GL_UNSIGNED_SHORT: return static_cast<const uint16_t*>(call.indices)[i];
  default: return static_cast<const uint32_t*>(call.indices)[i];
  }
}

inline void check_primitive(const DrawCall& call, const PrimitiveRange& range) {
  [[maybe_unused]] const uint64_t first = call.first_vertex, end = first + call.vertex_count;
  SOFTGL_ASSERT(range.mode <= GL_POLYGON);
  if (!call.indices) {
    SOFTGL_ASSERT(range.first >= first && uint64_t(range.first) + range.count <= end);
    return;
  }
  for (uint32_t i = 0; i < range.count; ++i)
    SOFTGL_ASSERT(index_of_call(call, range.first + i) >= first &&
                  index_of_call(call, range.first + i) < end);
}

/// Everything that a call names is there, and its vertices lie in its range.
inline void check_call([[maybe_unused]] const DrawCall& call) {
#if SOFTGL_CHECKS
  const uint32_t present = call.source->present;
  SOFTGL_ASSERT(!(present >> kAttributeSlots) && call.constant && call.primitives);
  SOFTGL_ASSERT(uint64_t(call.first_vertex) + call.vertex_count <= uint64_t(1) << 32);
  for (uint32_t slot = 0; slot < kAttributeSlots; ++slot) {
    if (!(present >> slot & 1)) continue;
    const AttributeStream& stream = call.source->stream[slot];
    SOFTGL_ASSERT(reinterpret_cast<uintptr_t>(stream.data) + size_t(call.first_vertex) * stream.stride != 0);
    SOFTGL_ASSERT(stream.components >= 1 && stream.components <= 4);
  }
  if (call.indices) {
    const GLenum type = call.index_type;
    SOFTGL_ASSERT(type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT);
    const uintptr_t bytes = type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : 4;
    SOFTGL_ASSERT(reinterpret_cast<uintptr_t>(call.indices) % bytes == 0);
  }
  for (uint32_t i = 0; i < call.primitive_count; ++i) check_primitive(call, call.primitives[i]);
#endif
}

} // namespace softgl
