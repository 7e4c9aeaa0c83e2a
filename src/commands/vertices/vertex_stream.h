// What writes to the vertex builder: Begin, End, attributes and vertices.
#pragma once

#include "context/context.h"

namespace softgl {

/// Draws what waits in the builder (or hands it to the list that is being compiled) and makes the last
/// attribute values current. Between Begin and End it does nothing. What finds no memory is dropped, with
/// GL_OUT_OF_MEMORY.
void close_run(Context& context);

/// The current attributes below kMaterial0 in the frame's arena, for DrawCall::constant; the last block again
/// while none has changed.
const Vec4* current_constants(Context& context);

/// The four values that the next vertex gets of an attribute. Not while a list is compiled.
inline const float* current_value(const Context& c, int slot) {
  const VertexBuilder& b = c.builder;
  return b.offset[slot]              ? b.value[b.offset[slot]]
         : b.deferred & (1u << slot) ? b.deferred_value[slot]
                                     : &c.state.current.slot[slot].x;
}

/// Makes a value current outside of any run and sets the dirty bit if it is new.
void set_current(Context& context, int slot, const float* value);

namespace gl {
void Begin(Context& context, GLenum mode);
void End(Context& context);
} // namespace gl

// The parts of the hot doors that are seldom needed; see attribute_doors.h.
void set_absent_attribute(Context& context, int slot, float x, float y, float z, float w);
void emit_vertex_without_room(Context& context, float x, float y, float z, float w);

} // namespace softgl
