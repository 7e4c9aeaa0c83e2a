// Buffer objects (GL 1.5, 2.9), with GL_ARB_pixel_buffer_object's and GL_ARB_copy_buffer's targets. How they
// are mapped is in buffer_mapping.cpp.
#include "context/buffer_objects.h"

#include <cstdlib>
#include <cstring>

#include "commands/buffers/buffer_contents.h"
#include "commands/generated/commands.h"
#include "context/context.h"

namespace softgl {

namespace {

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

bool in_range(Context& c, const BufferObject& buffer, GLintptr offset, GLsizeiptr size,
              const char* offset_argument = "offset") {
  const bool outside = offset < 0 || size_t(offset) > buffer.size();
  if (const char* wrong =
          first_wrong({{offset_argument, outside},
                       {"size", size < 0 || (!outside && size_t(size) > buffer.size() - size_t(offset))}})) {
    set_error(c, GL_INVALID_VALUE, wrong);
    return false;
  }
  if (buffer.mapped) {
    set_error(c, GL_INVALID_OPERATION);
    return false;
  }
  return true;
}

/// Whether two ranges of one buffer have bytes in common.
bool overlap(GLintptr a, GLintptr b, GLsizeiptr size) { return a < b + size && b < a + size; }

/// What no memory will ever hold; calloc would promise some of it.
constexpr GLsizeiptr kMaxBufferBytes = GLsizeiptr(1) << 40;

} // namespace

std::optional<BoundBuffer> bound_buffer(Context& c, GLenum target, const char* argument) {
  VertexArrayState& arrays = c.client.vertex_array;
  PixelStoreState& pixels = c.client.pixel_store;
  const auto of = [](BufferBinding& binding) { return BoundBuffer{binding.object, binding.name}; };
  switch (target) {
  case GL_ARRAY_BUFFER: return BoundBuffer{arrays.array_object, arrays.array_buffer};
  case GL_ELEMENT_ARRAY_BUFFER: return BoundBuffer{arrays.element_array_object, arrays.element_array_buffer};
  case GL_PIXEL_PACK_BUFFER: return of(pixels.pack_buffer);
  case GL_PIXEL_UNPACK_BUFFER: return of(pixels.unpack_buffer);
  case GL_COPY_READ_BUFFER: return of(c.client.copy_read);
  case GL_COPY_WRITE_BUFFER: return of(c.client.copy_write);
  default: set_error(c, GL_INVALID_ENUM, argument); return std::nullopt;
  }
}

BufferObject* buffer_of(Context& c, GLenum target, const char* argument) {
  const std::optional<BoundBuffer> bound = bound_buffer(c, target, argument);
  if (!bound) return nullptr;
  if (!bound->object) set_error(c, GL_INVALID_OPERATION);
  return bound->object.get();
}

void note_contents(Context& c, BufferObject& buffer) {
  ++buffer.version;
  c.dirty |= kDirtyArrays;
}

void make_writable(Context& c, BufferObject& buffer) {
  if (buffer.storage && buffer.storage.use_count() > 1) {
    auto copy = std::make_shared<BufferStorage>(buffer.storage->size);
    std::memcpy(copy->bytes, buffer.storage->bytes, copy->size);
    buffer.storage = std::move(copy);
  }
  note_contents(c, buffer);
}

void gl::BindBuffer(Context& c, GLenum target, GLuint name) {
  const std::optional<BoundBuffer> bound = bound_buffer(c, target);
  if (!bound) return;
  bound->object =
      name ? c.shared->buffers.find_or_create(name, [] { return std::make_shared<BufferObject>(); })
           : nullptr;
  bound->name = name;
}

void gl::GenBuffers(Context& c, GLsizei n, GLuint* names) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n");
  if (names && !c.shared->buffers.reserve(n, names)) set_error(c, GL_OUT_OF_MEMORY);
}

void gl::DeleteBuffers(Context& c, GLsizei n, const GLuint* names) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n");
  if (!names) return;
  VertexArrayState& arrays = c.client.vertex_array;
  for (GLsizei i = 0; i < n; ++i) {
    if (names[i] == 0) continue;
    const std::shared_ptr<BufferObject> object = c.shared->buffers.erase(names[i]);
    if (!object) continue;
    unmap(*object);
    const auto unbind = [&](std::shared_ptr<BufferObject>& binding, GLuint& name) {
      if (binding != object) return;
      binding = nullptr;
      name = 0;
    };
    unbind(arrays.array_object, arrays.array_buffer);
    unbind(arrays.element_array_object, arrays.element_array_buffer);
    for (BufferBinding* binding : {&c.client.pixel_store.pack_buffer, &c.client.pixel_store.unpack_buffer,
                                   &c.client.copy_read, &c.client.copy_write})
      unbind(binding->object, binding->name);
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
  const std::optional<BoundBuffer> bound = bound_buffer(c, target);
  if (!bound) return;
  if (size < 0) return set_error(c, GL_INVALID_VALUE, "size");
  if (!is_usage(usage)) return set_error(c, GL_INVALID_ENUM, "usage");
  if (!bound->object) return set_error(c, GL_INVALID_OPERATION);
  if (size > kMaxBufferBytes) return set_error(c, GL_OUT_OF_MEMORY);
  BufferObject& buffer = *bound->object;
  if (data && buffer.storage.use_count() == 1 && buffer.storage->size == size_t(size)) {
    // Memory that is there already costs a quarter of new one. `data` may be in it, where it is mapped.
    std::memmove(buffer.storage->bytes, data, size_t(size));
  } else {
    auto storage = std::make_shared<BufferStorage>(size_t(size));
    if (data) {
      populate_pages({storage->bytes, size_t(size)});
      std::memcpy(storage->bytes, data, size_t(size));
    }
    buffer.storage = std::move(storage);
  }
  buffer.usage = usage;
  buffer.access = GL_READ_WRITE;
  unmap(buffer);
  note_contents(c, buffer);
}

void gl::BufferSubData(Context& c, GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
  BufferObject* buffer = buffer_of(c, target);
  if (!buffer || !in_range(c, *buffer, offset, size) || !size || !data) return;
  make_writable(c, *buffer);
  std::memcpy(buffer->storage->bytes + offset, data, size_t(size));
}

void gl::GetBufferSubData(Context& c, GLenum target, GLintptr offset, GLsizeiptr size, void* data) {
  BufferObject* buffer = buffer_of(c, target);
  if (!buffer || !in_range(c, *buffer, offset, size) || !size || !data) return;
  std::memcpy(data, buffer->storage->bytes + offset, size_t(size));
}

void gl::CopyBufferSubData(Context& c, GLenum read_target, GLenum write_target, GLintptr read_offset,
                           GLintptr write_offset, GLsizeiptr size) {
  BufferObject* const from = buffer_of(c, read_target, "readTarget");
  if (!from) return;
  BufferObject* const to = buffer_of(c, write_target, "writeTarget");
  if (!to) return;
  if (from->mapped || to->mapped) return set_error(c, GL_INVALID_OPERATION);
  if (!in_range(c, *from, read_offset, size, "readOffset") ||
      !in_range(c, *to, write_offset, size, "writeOffset"))
    return;
  if (from == to && overlap(read_offset, write_offset, size)) return set_error(c, GL_INVALID_VALUE, "size");
  if (!size) return;
  make_writable(c, *to);
  std::memcpy(to->storage->bytes + write_offset, from->storage->bytes + read_offset, size_t(size));
}

} // namespace softgl
