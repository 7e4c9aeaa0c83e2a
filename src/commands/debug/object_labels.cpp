// Labels of objects (GL_KHR_debug, 5.5.8 and 6.1.16; GL_EXT_debug_label). There are no sync objects, whose
// labels go by a pointer.
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

using Label = std::shared_ptr<std::string>;

/// Null for an object that does not exist; false for what is no kind of object.
bool find_label(Context& c, GLenum identifier, GLuint name, Label& label) {
  switch (identifier) {
  case GL_BUFFER: label = label_of(c.shared->buffers.find(name)); return true;
  case GL_SAMPLER: label = label_of(c.shared->samplers.find(name)); return true;
  case GL_TEXTURE: label = label_of(c.shared->textures.find(name)); return true;
  case GL_DISPLAY_LIST: label = label_of(c.shared->lists.find(name)); return true;
  case GL_RENDERBUFFER: label = label_of(c.shared->renderbuffers.find(name)); return true;
  case GL_FRAMEBUFFER: label = label_of(c.framebuffer_objects.find(name)); return true;
  case GL_VERTEX_ARRAY: label = label_of(c.vertex_array_objects.find(name)); return true;
  case GL_QUERY: label = label_of(c.queries.objects.find(name)); return true;
  case GL_SHADER:
  case GL_PROGRAM:
  case GL_PROGRAM_PIPELINE:
  case GL_TRANSFORM_FEEDBACK: return true; // there are none
  default: return false;
  }
}

/// Null, and the error, for an object that does not exist.
Label find_label(Context& c, GLenum identifier, GLuint name) {
  Label label;
  if (!find_label(c, identifier, name, label))
    set_error(c, GL_INVALID_ENUM, "identifier");
  else if (!label)
    set_error(c, GL_INVALID_VALUE, "name");
  return label;
}

/// The same by the names and errors of GL_EXT_debug_label.
Label find_label_ext(Context& c, GLenum type, GLuint object) {
  constexpr GLenum kOther[][2] = {
      {GL_BUFFER_OBJECT_EXT, GL_BUFFER},   {GL_VERTEX_ARRAY_OBJECT_EXT, GL_VERTEX_ARRAY},
      {GL_QUERY_OBJECT_EXT, GL_QUERY},     {GL_SHADER_OBJECT_EXT, GL_SHADER},
      {GL_PROGRAM_OBJECT_EXT, GL_PROGRAM}, {GL_PROGRAM_PIPELINE_OBJECT_EXT, GL_PROGRAM_PIPELINE}};
  constexpr GLenum kSame[] = {GL_TEXTURE, GL_FRAMEBUFFER, GL_RENDERBUFFER, GL_SAMPLER, GL_TRANSFORM_FEEDBACK};
  GLenum identifier = std::find(std::begin(kSame), std::end(kSame), type) != std::end(kSame) ? type : 0;
  for (const auto& [name, kind] : kOther)
    if (type == name) identifier = kind;
  Label label;
  if (!find_label(c, identifier, object, label))
    set_error(c, GL_INVALID_ENUM, "type");
  else if (!label)
    set_error(c, GL_INVALID_OPERATION);
  return label;
}

/// `length` -1: up to a null. `argument` is to blame for what is too long.
void set_label(Context& c, std::string& to, const GLchar* label, GLsizei length, const char* argument) {
  if (!label) return to.clear();
  const size_t size = length < 0 ? strnlen(label, size_t(kMaxLabelLength)) : size_t(length);
  if (size >= size_t(kMaxLabelLength)) return set_error(c, GL_INVALID_VALUE, argument);
  to.assign(label, size);
}

void copy_label(const std::string& from, GLsizei size_of_memory, GLsizei* length, GLchar* label) {
  size_t size = from.size();
  if (label) {
    size = std::min(size, size_t(std::max(size_of_memory, 1) - 1));
    if (size_of_memory > 0) {
      std::memcpy(label, from.data(), size);
      label[size] = 0;
    }
  }
  if (length) *length = GLsizei(size);
}

} // namespace

namespace gl {

void ObjectLabel(Context& c, GLenum identifier, GLuint name, GLsizei length, const GLchar* label) {
  if (const auto to = find_label(c, identifier, name))
    set_label(c, *to, label, length, length < 0 ? "label" : "length");
}

void GetObjectLabel(Context& c, GLenum identifier, GLuint name, GLsizei bufSize, GLsizei* length,
                    GLchar* label) {
  if (bufSize < 0) return set_error(c, GL_INVALID_VALUE, "bufSize");
  if (const auto from = find_label(c, identifier, name)) copy_label(*from, bufSize, length, label);
}

void LabelObjectEXT(Context& c, GLenum type, GLuint object, GLsizei length, const GLchar* label) {
  if (length < 0) return set_error(c, GL_INVALID_VALUE, "length");
  if (const auto to = find_label_ext(c, type, object))
    set_label(c, *to, label, length ? length : -1, length ? "length" : "label");
}

void GetObjectLabelEXT(Context& c, GLenum type, GLuint object, GLsizei bufSize, GLsizei* length,
                       GLchar* label) {
  if (bufSize < 0) return set_error(c, GL_INVALID_VALUE, "bufSize");
  if (const auto from = find_label_ext(c, type, object)) copy_label(*from, bufSize, length, label);
}

void ObjectPtrLabel(Context& c, const void*, GLsizei, const GLchar*) {
  set_error(c, GL_INVALID_VALUE, "ptr");
}
void GetObjectPtrLabel(Context& c, const void*, GLsizei bufSize, GLsizei*, GLchar*) {
  set_error(c, GL_INVALID_VALUE, bufSize < 0 ? "bufSize" : "ptr");
}

} // namespace gl
} // namespace softgl
