#include "context/buffer_objects.h"

#include <cstdlib>
#include <cstring>

#include "commands/generated/commands.h"
#include "context/context.h"

namespace softgl {

namespace {

std::shared_ptr<BufferObject>* bound_object(Context& c, GLenum target) {
  VertexArrayState& arrays = c.client.vertex_array;
  switch (target) {
  case GL_ARRAY_BUFFER: return &arrays.array_object;
  case GL_ELEMENT_ARRAY_BUFFER: return &arrays.element_array_object;
  default: set_error(c, GL_INVALID_ENUM); return nullptr;
  }
}

/// The object bound to `target`; without one, or for a bad target, the error is set.
BufferObject* buffer_of(Context& c, GLenum target) {
  std::shared_ptr<BufferObject>* binding = bound_object(c, target);
  if (!binding) return nullptr;
  if (!*binding) set_error(c, GL_INVALID_OPERATION);
  return binding->get();
}

bool is_usage(GLenum usage) {
  switch (usage) {
  case GL_STREAM_DRAW:
  case GL_STREAM_READ:
  case GL_STREAM_COPY:
  case GL_STATIC_DRAW:
  case GL_STATIC_READ:
  case GL_STATIC_COPY:
  case GL_DYNAMIC_DRAW:
  case GL_DYNAMIC_READ:
  case GL_DYNAMIC_COPY: return true;
  default: return false;
  }
}

void changed(Context& c, BufferObject& buffer) {
  ++buffer.version;
  c.dirty |= kDirtyArrays;
}

/// Gives the buffer bytes of its own when a frame still reads them.
void detach(Context& c, BufferObject& buffer) {
  if (buffer.storage && buffer.storage.use_count() > 1) {
    auto copy = std::make_shared<BufferStorage>(buffer.storage->size);
    std::memcpy(copy->bytes, buffer.storage->bytes, copy->size);
    buffer.storage = std::move(copy);
  }
  changed(c, buffer);
}

bool in_range(Context& c, const BufferObject& buffer, GLintptr offset, GLsizeiptr size) {
  if (offset < 0 || size < 0 || size_t(offset) > buffer.size() ||
      size_t(size) > buffer.size() - size_t(offset)) {
    set_error(c, GL_INVALID_VALUE);
    return false;
  }
  if (buffer.mapped) {
    set_error(c, GL_INVALID_OPERATION);
    return false;
  }
  return true;
}

/// What no memory will ever hold; calloc would promise some of it.
constexpr GLsizeiptr kMaxBufferBytes = GLsizeiptr(1) << 40;

} // namespace

void gl::BindBuffer(Context& c, GLenum target, GLuint name) {
  std::shared_ptr<BufferObject>* binding = bound_object(c, target);
  if (!binding) return;
  *binding = name ? c.shared->buffers.find_or_create(name, [] { return std::make_shared<BufferObject>(); })
                  : nullptr;
  VertexArrayState& arrays = c.client.vertex_array;
  (target == GL_ARRAY_BUFFER ? arrays.array_buffer : arrays.element_array_buffer) = name;
}

void gl::GenBuffers(Context& c, GLsizei n, GLuint* names) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE);
  if (names && !c.shared->buffers.reserve(n, names)) set_error(c, GL_OUT_OF_MEMORY);
}

void gl::DeleteBuffers(Context& c, GLsizei n, const GLuint* names) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE);
  if (!names) return;
  VertexArrayState& arrays = c.client.vertex_array;
  for (GLsizei i = 0; i < n; ++i) {
    if (names[i] == 0) continue;
    const std::shared_ptr<BufferObject> object = c.shared->buffers.erase(names[i]);
    if (!object) continue;
    object->mapped = false;
    const auto unbind = [&](std::shared_ptr<BufferObject>& binding, GLuint& name) {
      if (binding != object) return;
      binding = nullptr;
      name = 0;
    };
    unbind(arrays.array_object, arrays.array_buffer);
    unbind(arrays.element_array_object, arrays.element_array_buffer);
    for (VertexArray& array : arrays.array) {
      if (array.object != object) continue;
      unbind(array.object, array.buffer);
      // An offset is no address.
      array.pointer = nullptr;
    }
    c.dirty |= kDirtyArrays;
  }
}

GLboolean gl::IsBuffer(Context& c, GLuint name) { return c.shared->buffers.find(name) != nullptr; }

void gl::BufferData(Context& c, GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
  std::shared_ptr<BufferObject>* binding = bound_object(c, target);
  if (!binding) return;
  if (size < 0) return set_error(c, GL_INVALID_VALUE);
  if (!is_usage(usage)) return set_error(c, GL_INVALID_ENUM);
  if (!*binding) return set_error(c, GL_INVALID_OPERATION);
  if (size > kMaxBufferBytes) return set_error(c, GL_OUT_OF_MEMORY);
  BufferObject& buffer = **binding;
  auto storage = std::make_shared<BufferStorage>(size_t(size));
  if (data) {
    populate_pages({storage->bytes, size_t(size)});
    std::memcpy(storage->bytes, data, size_t(size));
  }
  buffer.storage = std::move(storage);
  buffer.usage = usage;
  buffer.access = GL_READ_WRITE;
  buffer.mapped = false;
  changed(c, buffer);
}

void gl::BufferSubData(Context& c, GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
  BufferObject* buffer = buffer_of(c, target);
  if (!buffer || !in_range(c, *buffer, offset, size) || !size || !data) return;
  detach(c, *buffer);
  std::memcpy(buffer->storage->bytes + offset, data, size_t(size));
}

void gl::GetBufferSubData(Context& c, GLenum target, GLintptr offset, GLsizeiptr size, void* data) {
  BufferObject* buffer = buffer_of(c, target);
  if (!buffer || !in_range(c, *buffer, offset, size) || !size || !data) return;
  std::memcpy(data, buffer->storage->bytes + offset, size_t(size));
}

void* gl::MapBuffer(Context& c, GLenum target, GLenum access) {
  std::shared_ptr<BufferObject>* binding = bound_object(c, target);
  if (!binding) return nullptr;
  if (access != GL_READ_ONLY && access != GL_WRITE_ONLY && access != GL_READ_WRITE) {
    set_error(c, GL_INVALID_ENUM);
    return nullptr;
  }
  BufferObject* buffer = buffer_of(c, target);
  if (!buffer) return nullptr;
  // Without bytes there is nothing to map, as in OSMesa. Nobody writes to a buffer that found no memory.
  if (buffer->mapped || buffer->size() == 0) {
    set_error(c, GL_INVALID_OPERATION);
    return nullptr;
  }
  if (access != GL_READ_ONLY) detach(c, *buffer);
  buffer->mapped = true;
  buffer->access = access;
  return buffer->storage->bytes;
}

GLboolean gl::UnmapBuffer(Context& c, GLenum target) {
  BufferObject* buffer = buffer_of(c, target);
  if (!buffer) return GL_FALSE;
  if (!buffer->mapped) {
    set_error(c, GL_INVALID_OPERATION);
    return GL_FALSE;
  }
  buffer->mapped = false;
  changed(c, *buffer); // written through the pointer
  return GL_TRUE;
}

void gl::GetBufferParameteriv(Context& c, GLenum target, GLenum pname, GLint* params) {
  if (!bound_object(c, target)) return;
  if (pname != GL_BUFFER_SIZE && pname != GL_BUFFER_USAGE && pname != GL_BUFFER_ACCESS &&
      pname != GL_BUFFER_MAPPED)
    return set_error(c, GL_INVALID_ENUM);
  const BufferObject* buffer = buffer_of(c, target);
  if (!buffer || !params) return;
  switch (pname) {
  case GL_BUFFER_SIZE: *params = buffer->size() > 0x7fffffff ? 0x7fffffff : GLint(buffer->size()); break;
  case GL_BUFFER_USAGE: *params = GLint(buffer->usage); break;
  case GL_BUFFER_ACCESS: *params = GLint(buffer->access); break;
  default: *params = buffer->mapped;
  }
}

void gl::GetBufferPointerv(Context& c, GLenum target, GLenum pname, void** params) {
  if (!bound_object(c, target)) return;
  if (pname != GL_BUFFER_MAP_POINTER) return set_error(c, GL_INVALID_ENUM);
  const BufferObject* buffer = buffer_of(c, target);
  if (buffer && params) *params = buffer->mapped ? buffer->storage->bytes : nullptr;
}

} // namespace softgl
