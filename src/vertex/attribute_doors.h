// What the doors of glColor*, glNormal*, glTexCoord*, ... and glVertex* expand to.
#pragma once

#include "state/context.h"

namespace softgl {

inline void set_attribute4(Context& c, int slot, float x, float y, float z, float w) {
  c.state.current.slot[slot] = {x, y, z, w};
}
inline void set_attribute1(Context& c, int slot, float x) { set_attribute4(c, slot, x, 0, 0, 1); }
inline void set_attribute2(Context& c, int slot, float x, float y) { set_attribute4(c, slot, x, y, 0, 1); }
inline void set_attribute3(Context& c, int slot, float x, float y, float z) { set_attribute4(c, slot, x, y, z, 1); }

inline void emit_vertex4(Context& c, float x, float y, float z, float w) { set_attribute4(c, kPosition, x, y, z, w); }
inline void emit_vertex2(Context& c, float x, float y) { emit_vertex4(c, x, y, 0, 1); }
inline void emit_vertex3(Context& c, float x, float y, float z) { emit_vertex4(c, x, y, z, 1); }

} // namespace softgl
