// Where the vertex arrays are: gl*Pointer, InterleavedArrays, GetPointerv (GL 1.5, 2.8).
#include <algorithm>

#include "commands/generated/commands.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {
namespace {

/// Vertex array objects other than that of name 0 keep no addresses of the client's memory.
bool refuses_memory(const Context& c, const void* pointer) {
  const VertexArrayState& arrays = c.client.vertex_array;
  return arrays.bound && !arrays.array_object && pointer;
}

void set_pointer(Context& c, int slot, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  if (stride < 0 && !SOFTGL_FAULT(negative_stride_taken)) return set_error(c, GL_INVALID_VALUE, "stride");
  if (refuses_memory(c, pointer)) return set_error(c, GL_INVALID_OPERATION);
  VertexArrayState& arrays = c.client.vertex_array;
  VertexArray& array = arrays.array[slot];
  array.size = size;
  array.type = type;
  array.stride = stride;
  array.pointer = pointer;
  array.buffer = arrays.array_buffer;
  array.object = arrays.array_object;
  c.dirty |= kDirtyArrays;
}

bool is_integer_or_float(GLenum type) {
  return type == GL_SHORT || type == GL_INT || type == GL_FLOAT || type == GL_DOUBLE;
}
bool is_coordinate(GLenum type) { return is_integer_or_float(type) || type == GL_HALF_FLOAT; }

/// Whether a color array of 3 to `largest` components, or GL_BGRA (GL_ARB_vertex_array_bgra), may have that
/// type; if not, the error.
bool check_colors(Context& c, GLint size, GLint largest, GLenum type) {
  if (!(type >= GL_BYTE && type <= GL_FLOAT) && type != GL_DOUBLE && type != GL_HALF_FLOAT)
    return set_error(c, GL_INVALID_ENUM, "type"), false;
  if ((size < 3 || size > largest) && size != GL_BGRA) return set_error(c, GL_INVALID_VALUE, "size"), false;
  if (size == GL_BGRA && type != GL_UNSIGNED_BYTE) return set_error(c, GL_INVALID_OPERATION), false;
  return true;
}

/// GL 1.5, table 2.5.
struct InterleavedFormat {
  GLint texcoords, colors;
  bool normal;
  GLint positions;
  GLenum color_type;
};
constexpr InterleavedFormat kInterleaved[14] = {
    /* V2F */ {0, 0, false, 2, 0},
    /* V3F */ {0, 0, false, 3, 0},
    /* C4UB_V2F */ {0, 4, false, 2, GL_UNSIGNED_BYTE},
    /* C4UB_V3F */ {0, 4, false, 3, GL_UNSIGNED_BYTE},
    /* C3F_V3F */ {0, 3, false, 3, GL_FLOAT},
    /* N3F_V3F */ {0, 0, true, 3, 0},
    /* C4F_N3F_V3F */ {0, 4, true, 3, GL_FLOAT},
    /* T2F_V3F */ {2, 0, false, 3, 0},
    /* T4F_V4F */ {4, 0, false, 4, 0},
    /* T2F_C4UB_V3F */ {2, 4, false, 3, GL_UNSIGNED_BYTE},
    /* T2F_C3F_V3F */ {2, 3, false, 3, GL_FLOAT},
    /* T2F_N3F_V3F */ {2, 0, true, 3, 0},
    /* T2F_C4F_N3F_V3F */ {2, 4, true, 3, GL_FLOAT},
    /* T4F_C4F_N3F_V4F */ {4, 4, true, 4, GL_FLOAT},
};

} // namespace

void gl::VertexPointer(Context& c, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  if (!is_coordinate(type)) return set_error(c, GL_INVALID_ENUM, "type");
  if (size < 2 || size > 4) return set_error(c, GL_INVALID_VALUE, "size");
  set_pointer(c, kPosition, size, type, stride, pointer);
}
void gl::NormalPointer(Context& c, GLenum type, GLsizei stride, const void* pointer) {
  if (!is_coordinate(type) && type != GL_BYTE) return set_error(c, GL_INVALID_ENUM, "type");
  set_pointer(c, kNormal, 3, type, stride, pointer);
}
void gl::ColorPointer(Context& c, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  if (check_colors(c, size, 4, type)) set_pointer(c, kColor, size, type, stride, pointer);
}
void gl::SecondaryColorPointer(Context& c, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  if (check_colors(c, size, 3, type)) set_pointer(c, kSecondaryColor, size, type, stride, pointer);
}
void gl::FogCoordPointer(Context& c, GLenum type, GLsizei stride, const void* pointer) {
  if (type != GL_FLOAT && type != GL_DOUBLE && type != GL_HALF_FLOAT)
    return set_error(c, GL_INVALID_ENUM, "type");
  set_pointer(c, kFogCoordinate, 1, type, stride, pointer);
}
void gl::IndexPointer(Context& c, GLenum type, GLsizei stride, const void* pointer) {
  if (!is_integer_or_float(type) && type != GL_UNSIGNED_BYTE) return set_error(c, GL_INVALID_ENUM, "type");
  set_pointer(c, kColorIndex, 1, type, stride, pointer);
}
void gl::EdgeFlagPointer(Context& c, GLsizei stride, const void* pointer) {
  set_pointer(c, kEdgeFlag, 1, GL_UNSIGNED_BYTE, stride, pointer);
}
void gl::TexCoordPointer(Context& c, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  if (!is_coordinate(type)) return set_error(c, GL_INVALID_ENUM, "type");
  if (size < 1 || size > 4) return set_error(c, GL_INVALID_VALUE, "size");
  set_pointer(c, kTexCoord0 + c.client.vertex_array.active_texture_unit, size, type, stride, pointer);
}

void gl::ClientActiveTexture(Context& c, GLenum texture) {
  if (texture < GL_TEXTURE0 || texture >= GLenum(GL_TEXTURE0 + kMaxTextureUnits))
    return set_error(c, GL_INVALID_ENUM, "texture");
  c.client.vertex_array.active_texture_unit = int(texture - GL_TEXTURE0);
}

void gl::InterleavedArrays(Context& c, GLenum format, GLsizei stride, const void* pointer) {
  if (format < GL_V2F || format > GL_T4F_C4F_N3F_V4F) return set_error(c, GL_INVALID_ENUM, "format");
  if (stride < 0) return set_error(c, GL_INVALID_VALUE, "stride");
  if (refuses_memory(c, pointer)) return set_error(c, GL_INVALID_OPERATION);
  const InterleavedFormat& f = kInterleaved[format - GL_V2F];
  VertexArrayState& arrays = c.client.vertex_array;
  const auto* at = static_cast<const unsigned char*>(pointer);
  const GLsizei color_bytes = f.color_type == GL_UNSIGNED_BYTE ? 4 : 4 * f.colors;
  const GLsizei tight = 4 * f.texcoords + color_bytes + (f.normal ? 12 : 0) + 4 * f.positions;
  if (!stride || SOFTGL_FAULT(interleaved_stride_ignored)) stride = tight;
  const auto place = [&](int slot, bool there, GLint size, GLenum type, GLsizei bytes) {
    arrays.array[slot].enabled = there;
    if (!there) return;
    set_pointer(c, slot, size, type, stride, at);
    // The pointer may be an offset into a buffer.
    at = reinterpret_cast<const unsigned char*>(reinterpret_cast<uintptr_t>(at) + uintptr_t(bytes));
  };
  arrays.array[kEdgeFlag].enabled = arrays.array[kColorIndex].enabled = false;
  arrays.array[kSecondaryColor].enabled = arrays.array[kFogCoordinate].enabled = false;
  place(kTexCoord0 + arrays.active_texture_unit, f.texcoords > 0, f.texcoords, GL_FLOAT, 4 * f.texcoords);
  place(kColor, f.colors > 0, f.colors, f.color_type, color_bytes);
  place(kNormal, f.normal, 3, GL_FLOAT, 12);
  place(kPosition, true, SOFTGL_FAULT(interleaved_w_lost) ? std::min(f.positions, 3) : f.positions, GL_FLOAT,
        4 * f.positions);
  c.dirty |= kDirtyArrays;
}

void gl::GetPointerv(Context& c, GLenum pname, void** params) {
  const VertexArrayState& arrays = c.client.vertex_array;
  int slot;
  switch (pname) {
  case GL_VERTEX_ARRAY_POINTER: slot = kPosition; break;
  case GL_NORMAL_ARRAY_POINTER: slot = kNormal; break;
  case GL_COLOR_ARRAY_POINTER: slot = kColor; break;
  case GL_SECONDARY_COLOR_ARRAY_POINTER: slot = kSecondaryColor; break;
  case GL_FOG_COORD_ARRAY_POINTER: slot = kFogCoordinate; break;
  case GL_INDEX_ARRAY_POINTER: slot = kColorIndex; break;
  case GL_EDGE_FLAG_ARRAY_POINTER: slot = kEdgeFlag; break;
  case GL_TEXTURE_COORD_ARRAY_POINTER: slot = kTexCoord0 + arrays.active_texture_unit; break;
  case GL_FEEDBACK_BUFFER_POINTER:
    if (params) *params = c.state.render_mode.feedback_buffer;
    return;
  case GL_SELECTION_BUFFER_POINTER:
    if (params) *params = c.state.render_mode.selection_buffer;
    return;
  case GL_DEBUG_CALLBACK_FUNCTION:
    if (params) *params = reinterpret_cast<void*>(c.debug.callback);
    return;
  case GL_DEBUG_CALLBACK_USER_PARAM:
    if (params) *params = const_cast<void*>(c.debug.user_parameter);
    return;
  default: return set_error(c, GL_INVALID_ENUM, "pname");
  }
  if (params) *params = const_cast<void*>(arrays.array[slot].pointer);
}

// What an array holds is copied at each draw, or is kept with its buffer: a lock saves nothing here.
void gl::LockArraysEXT(Context& c, GLint first, GLsizei count) {
  if (const char* wrong = first_wrong({{"first", first < 0}, {"count", count <= 0}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  if (c.client.vertex_array.lock_count) return set_error(c, GL_INVALID_OPERATION);
  c.client.vertex_array.lock_first = first;
  c.client.vertex_array.lock_count = count;
}

void gl::UnlockArraysEXT(Context& c) {
  if (!c.client.vertex_array.lock_count) return set_error(c, GL_INVALID_OPERATION);
  c.client.vertex_array.lock_first = 0;
  c.client.vertex_array.lock_count = 0;
}

} // namespace softgl
