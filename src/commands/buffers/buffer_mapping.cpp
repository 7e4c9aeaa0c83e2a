// Buffer objects in the client's address space: MapBuffer (GL 1.5, 2.9) and GL_ARB_map_buffer_range, and the
// queries.
#include <algorithm>

#include "commands/buffers/buffer_contents.h"
#include "commands/generated/commands.h"
#include "context/context.h"

namespace softgl {
namespace {

constexpr GLbitfield kMapBits = GL_MAP_READ_BIT | GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT |
                                GL_MAP_INVALIDATE_BUFFER_BIT | GL_MAP_FLUSH_EXPLICIT_BIT |
                                GL_MAP_UNSYNCHRONIZED_BIT;

void* map(Context& c, BufferObject& buffer, size_t offset, size_t size, GLbitfield flags) {
  // A frame that still reads the bytes keeps them: so it makes no difference whether the client wants to
  // wait.
  if (flags & GL_MAP_WRITE_BIT) make_writable(c, buffer);
  buffer.mapped = true;
  buffer.access_flags = flags;
  buffer.access = !(flags & GL_MAP_WRITE_BIT)  ? GL_READ_ONLY
                  : !(flags & GL_MAP_READ_BIT) ? GL_WRITE_ONLY
                                               : GL_READ_WRITE;
  buffer.map_offset = offset;
  buffer.map_size = size;
  return buffer.storage->bytes + offset;
}

/// The argument that leaves `bytes` bytes; null if none does.
const char* wrong_range(size_t bytes, GLintptr offset, GLsizeiptr size) {
  return size_t(offset) > bytes ? "offset" : size_t(size) > bytes - size_t(offset) ? "length" : nullptr;
}

/// The error of a mapping (GL_ARB_map_buffer_range, 2.9), in OSMesa's order.
Refusal check_range(const BufferObject& buffer, GLintptr offset, GLsizeiptr size, GLbitfield flags) {
  if (const char* wrong = first_wrong({{"offset", offset < 0}, {"length", size < 0}}))
    return {GL_INVALID_VALUE, wrong};
  // Nothing can be mapped without an address (GL 4.5, 6.3: the error of a range of 0 bytes).
  if (size == 0) return {GL_INVALID_OPERATION};
  if (flags & ~kMapBits) return {GL_INVALID_VALUE, "access"};
  if (!(flags & (GL_MAP_READ_BIT | GL_MAP_WRITE_BIT))) return {GL_INVALID_OPERATION};
  constexpr GLbitfield kNotForReading =
      GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT | GL_MAP_UNSYNCHRONIZED_BIT;
  if ((flags & GL_MAP_READ_BIT) && (flags & kNotForReading)) return {GL_INVALID_OPERATION};
  if ((flags & GL_MAP_FLUSH_EXPLICIT_BIT) && !(flags & GL_MAP_WRITE_BIT)) return {GL_INVALID_OPERATION};
  if (const char* wrong = wrong_range(buffer.size(), offset, size)) return {GL_INVALID_VALUE, wrong};
  return {buffer.mapped ? GLenum(GL_INVALID_OPERATION) : GLenum(GL_NO_ERROR)};
}

GLint as_integer(size_t v) { return GLint(std::min(v, size_t(0x7fffffff))); }

} // namespace

void unmap(BufferObject& buffer) {
  buffer.mapped = false;
  buffer.access_flags = 0;
  buffer.map_offset = buffer.map_size = 0;
}

void* gl::MapBuffer(Context& c, GLenum target, GLenum access) {
  if (!bound_buffer(c, target)) return nullptr;
  if (access != GL_READ_ONLY && access != GL_WRITE_ONLY && access != GL_READ_WRITE) {
    set_error(c, GL_INVALID_ENUM, "access");
    return nullptr;
  }
  BufferObject* buffer = buffer_of(c, target);
  if (!buffer) return nullptr;
  // Without bytes there is nothing to map, as in OSMesa. Nobody writes to a buffer that found no memory.
  if (buffer->mapped || buffer->size() == 0) {
    set_error(c, GL_INVALID_OPERATION);
    return nullptr;
  }
  return map(c, *buffer, 0, buffer->size(),
             (access != GL_WRITE_ONLY ? GL_MAP_READ_BIT : 0u) |
                 (access != GL_READ_ONLY ? GL_MAP_WRITE_BIT : 0u));
}

void* gl::MapBufferRange(Context& c, GLenum target, GLintptr offset, GLsizeiptr size, GLbitfield access) {
  BufferObject* buffer = buffer_of(c, target);
  if (!buffer) return nullptr;
  if (const Refusal refusal = check_range(*buffer, offset, size, access)) {
    set_error(c, refusal);
    return nullptr;
  }
  return map(c, *buffer, size_t(offset), size_t(size), access);
}

void gl::FlushMappedBufferRange(Context& c, GLenum target, GLintptr offset, GLsizeiptr size) {
  BufferObject* buffer = buffer_of(c, target);
  if (!buffer) return;
  if (const char* wrong = first_wrong({{"offset", offset < 0}, {"length", size < 0}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  if (!buffer->mapped || !(buffer->access_flags & GL_MAP_FLUSH_EXPLICIT_BIT))
    return set_error(c, GL_INVALID_OPERATION);
  if (const char* wrong = wrong_range(buffer->map_size, offset, size))
    return set_error(c, GL_INVALID_VALUE, wrong);
  note_contents(c, *buffer);
}

GLboolean gl::UnmapBuffer(Context& c, GLenum target) {
  BufferObject* buffer = buffer_of(c, target);
  if (!buffer) return GL_FALSE;
  if (!buffer->mapped) {
    set_error(c, GL_INVALID_OPERATION);
    return GL_FALSE;
  }
  unmap(*buffer);
  note_contents(c, *buffer); // written through the pointer
  return GL_TRUE;
}

void gl::GetBufferParameteriv(Context& c, GLenum target, GLenum pname, GLint* params) {
  if (!bound_buffer(c, target)) return;
  if (pname != GL_BUFFER_SIZE && pname != GL_BUFFER_USAGE && pname != GL_BUFFER_ACCESS &&
      pname != GL_BUFFER_MAPPED && pname != GL_BUFFER_ACCESS_FLAGS && pname != GL_BUFFER_MAP_OFFSET &&
      pname != GL_BUFFER_MAP_LENGTH)
    return set_error(c, GL_INVALID_ENUM, "pname");
  const BufferObject* buffer = buffer_of(c, target);
  if (!buffer || !params) return;
  switch (pname) {
  case GL_BUFFER_SIZE: *params = as_integer(buffer->size()); break;
  case GL_BUFFER_USAGE: *params = GLint(buffer->usage); break;
  case GL_BUFFER_ACCESS: *params = GLint(buffer->access); break;
  case GL_BUFFER_ACCESS_FLAGS: *params = GLint(buffer->access_flags); break;
  case GL_BUFFER_MAP_OFFSET: *params = as_integer(buffer->map_offset); break;
  case GL_BUFFER_MAP_LENGTH: *params = as_integer(buffer->map_size); break;
  default: *params = buffer->mapped;
  }
}

void gl::GetBufferPointerv(Context& c, GLenum target, GLenum pname, void** params) {
  if (!bound_buffer(c, target)) return;
  if (pname != GL_BUFFER_MAP_POINTER) return set_error(c, GL_INVALID_ENUM, "pname");
  const BufferObject* buffer = buffer_of(c, target);
  if (buffer && params) *params = buffer->mapped ? buffer->storage->bytes + buffer->map_offset : nullptr;
}

} // namespace softgl
