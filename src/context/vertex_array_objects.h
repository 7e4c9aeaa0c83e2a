// Vertex array objects (GL_ARB_vertex_array_object, 2.10).
#pragma once

#include <string>

#include "context/state.h"

namespace softgl {

struct Context;

struct VertexArrayObject {
  explicit VertexArrayObject(GLuint name) : name(name) {}
  GLuint name;
  std::string label;   // GL_KHR_debug
  VertexArrays arrays; // while it is bound they are in VertexArrayState
};

/// Null: the arrays of name 0. Throws nothing.
void bind_vertex_array(Context& context, const std::shared_ptr<VertexArrayObject>& object);

} // namespace softgl
