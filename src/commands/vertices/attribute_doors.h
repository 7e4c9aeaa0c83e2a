// What the 216 doors of glColor*, glNormal*, glTexCoord*, ... and glVertex* expand to. No test for a context,
// a list or Begin and End: the builder at hand is prepared so that the hot path is right and everything else
// takes the cold one.
#pragma once

#include <emmintrin.h>

#include "commands/vertices/vertex_stream.h"
#include "context/context.h"
#include "texture/small_floats.h"

namespace softgl {

inline void set_attribute4(Context& c, int slot, float x, float y, float z, float w) {
  VertexBuilder& b = c.builder;
  const unsigned offset = b.offset[slot];
  if (__builtin_expect(offset == 0, 0)) return set_absent_attribute(c, slot, x, y, z, w);
  // One 16-byte store: four narrow ones would not be forwarded to the 16-byte load of the vertex.
  _mm_store_ps(b.value[offset], _mm_setr_ps(x, y, z, w));
}
inline void set_attribute1(Context& c, int slot, float x) { set_attribute4(c, slot, x, 0, 0, 1); }
inline void set_attribute2(Context& c, int slot, float x, float y) { set_attribute4(c, slot, x, y, 0, 1); }
inline void set_attribute3(Context& c, int slot, float x, float y, float z) {
  set_attribute4(c, slot, x, y, z, 1);
}

inline void emit_vertex4(Context& c, float x, float y, float z, float w) {
  VertexBuilder& b = c.builder;
  float* out = b.out;
  // Outside Begin and End `limit` is null; a chunk that is full looks the same.
  if (__builtin_expect(out >= b.limit, 0)) return emit_vertex_without_room(c, x, y, z, w);
  const float* value = b.value[0];
  _mm_store_ps(out, _mm_setr_ps(x, y, z, w));
  const size_t end = 4 * size_t(b.slots);
  for (size_t i = 4; i != end; i += 4) _mm_store_ps(out + i, _mm_load_ps(value + i));
  b.out = out + end;
}
inline void emit_vertex2(Context& c, float x, float y) { emit_vertex4(c, x, y, 0, 1); }
inline void emit_vertex3(Context& c, float x, float y, float z) { emit_vertex4(c, x, y, z, 1); }

} // namespace softgl
