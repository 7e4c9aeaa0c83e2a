// Labels of objects (GL_KHR_debug, 5.5.8 and 6.1.16). There are no sync objects, whose labels go by a
// pointer.
#include <algorithm>
#include <cstring>

#include "commands/generated/commands.h"
#include "context/buffer_objects.h"
#include "context/context.h"
#include "context/display_list.h"
#include "texture/texture_object.h"

namespace softgl {
namespace {

template <class Object> std::shared_ptr<std::string> label_of(const std::shared_ptr<Object>& object) {
  return object ? std::shared_ptr<std::string>(object, &object->label) : nullptr;
}

/// Null, and the error, for an object that does not exist.
std::shared_ptr<std::string> find_label(Context& c, GLenum identifier, GLuint name) {
  std::shared_ptr<std::string> label;
  switch (identifier) {
  case GL_BUFFER: label = label_of(c.shared->buffers.find(name)); break;
  case GL_SAMPLER: label = label_of(c.shared->samplers.find(name)); break;
  case GL_TEXTURE: label = label_of(c.shared->textures.find(name)); break;
  case GL_DISPLAY_LIST: label = label_of(c.shared->lists.find(name)); break;
  case GL_RENDERBUFFER: label = label_of(c.shared->renderbuffers.find(name)); break;
  case GL_FRAMEBUFFER: label = label_of(c.framebuffer_objects.find(name)); break;
  case GL_VERTEX_ARRAY: label = label_of(c.vertex_array_objects.find(name)); break;
  case GL_QUERY: label = label_of(c.queries.objects.find(name)); break;
  case GL_SHADER:
  case GL_PROGRAM:
  case GL_PROGRAM_PIPELINE:
  case GL_TRANSFORM_FEEDBACK: break; // there are none
  default: return set_error(c, GL_INVALID_ENUM, "identifier"), nullptr;
  }
  if (!label) set_error(c, GL_INVALID_VALUE, "name");
  return label;
}

} // namespace

namespace gl {

void ObjectLabel(Context& c, GLenum identifier, GLuint name, GLsizei length, const GLchar* label) {
  const auto to = find_label(c, identifier, name);
  if (!to) return;
  if (!label) return to->clear();
  const size_t size = length < 0 ? strnlen(label, size_t(kMaxLabelLength)) : size_t(length);
  if (size >= size_t(kMaxLabelLength)) return set_error(c, GL_INVALID_VALUE, length < 0 ? "label" : "length");
  to->assign(label, size);
}

void GetObjectLabel(Context& c, GLenum identifier, GLuint name, GLsizei bufSize, GLsizei* length,
                    GLchar* label) {
  if (bufSize < 0) return set_error(c, GL_INVALID_VALUE, "bufSize");
  const auto from = find_label(c, identifier, name);
  if (!from) return;
  size_t size = from->size();
  if (label) {
    size = std::min(size, size_t(std::max(bufSize, 1) - 1));
    if (bufSize > 0) {
      std::memcpy(label, from->data(), size);
      label[size] = 0;
    }
  }
  if (length) *length = GLsizei(size);
}

void ObjectPtrLabel(Context& c, const void*, GLsizei, const GLchar*) {
  set_error(c, GL_INVALID_VALUE, "ptr");
}
void GetObjectPtrLabel(Context& c, const void*, GLsizei bufSize, GLsizei*, GLchar*) {
  set_error(c, GL_INVALID_VALUE, bufSize < 0 ? "bufSize" : "ptr");
}

} // namespace gl
} // namespace softgl
