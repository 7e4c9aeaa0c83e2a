// Vertex array objects: naming and binding (GL_ARB_vertex_array_object, 2.10).
#include "context/vertex_array_objects.h"

#include "commands/generated/commands.h"
#include "context/context.h"

namespace softgl::gl {

void GenVertexArrays(Context& c, GLsizei n, GLuint* arrays) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n");
  if (arrays && !c.vertex_array_objects.reserve(n, arrays)) set_error(c, GL_OUT_OF_MEMORY);
}

void DeleteVertexArrays(Context& c, GLsizei n, const GLuint* arrays) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n");
  for (GLsizei i = 0; arrays && i < n; ++i) {
    const auto object = c.vertex_array_objects.erase(arrays[i]);
    if (object && object == c.client.vertex_array.bound) bind_vertex_array(c, nullptr);
  }
}

GLboolean IsVertexArray(Context& c, GLuint array) {
  return array != 0 && c.vertex_array_objects.find(array) ? GL_TRUE : GL_FALSE;
}

void BindVertexArray(Context& c, GLuint array) {
  if (array == 0) return bind_vertex_array(c, nullptr);
  if (!c.vertex_array_objects.used(array)) return set_error(c, GL_INVALID_OPERATION);
  bind_vertex_array(c, c.vertex_array_objects.find_or_create(
                           array, [&] { return std::make_shared<VertexArrayObject>(array); }));
}

} // namespace softgl::gl
