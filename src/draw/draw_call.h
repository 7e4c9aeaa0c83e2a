// What a vertex source (immediate mode, arrays, lists) hands over to be drawn.
#pragma once

#include "base/gl_types.h"
#include "base/vectors.h"
#include "shaders/common/vertex_attributes.h"

namespace softgl {

/// The attributes that vary over a draw, indexed by AttributeSlot. Draws of the same arrays share one.
struct VertexSource {
  uint32_t present = 0; // bit s: stream[s] is set; the other streams are not to be read
  AttributeStream stream[kAttributeSlots];
};

/// One primitive (what stands between Begin and End, or one DrawArrays): count elements from element `first`.
/// An element is an index into the source, or into `indices` of the call where there are indices.
struct PrimitiveRange {
  GLenum mode;
  uint32_t first, count;
  // A primitive too large for one run is continued in the next call; the line stipple and the closing edge of
  // a loop depend on it.
  bool begins = true, ends = true;
};

/// A draw. All memory it points to must stay unchanged until the frame is flushed: it lies in the frame's
/// arena, or in an object that the frame retains.
struct DrawCall {
  const VertexSource* source = nullptr;
  const Vec4* constant =
      nullptr; // [kMaterial0]: the values of the slots below kMaterial0 that have no stream. A
               // material slot without a stream has the value of State::current at submit().
  const PrimitiveRange* primitives = nullptr;
  uint32_t primitive_count = 0;
  const void* indices = nullptr;       // null: elements are vertex numbers
  GLenum index_type = GL_UNSIGNED_INT; // GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT or GL_UNSIGNED_INT
  uint32_t first_vertex = 0,
           vertex_count = 0; // every vertex used lies in [first_vertex, first_vertex + vertex_count)
  bool from_list =
      false; // vertices of a display list; the picture depends on it with SOFTGL_QUADS=osmesa only
};

/// Pixels of the window, y down, half open.
struct WindowBox {
  int32_t x0, y0, x1, y1;
};

} // namespace softgl
