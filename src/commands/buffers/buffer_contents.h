// The contents of buffer objects, for the commands of other chapters that read and write them.
#pragma once

#include <optional>

#include "context/buffer_objects.h"

namespace softgl {

struct Context;

/// What is bound to a target.
struct BoundBuffer {
  std::shared_ptr<BufferObject>& object; // null: nothing
  GLuint& name;
};
/// What is bound to `target`; none, and GL_INVALID_ENUM of `argument`, when it is no target.
std::optional<BoundBuffer> bound_buffer(Context& c, GLenum target, const char* argument = "target");
/// The object bound to `target`; null without one (GL_INVALID_OPERATION), or for a bad target
/// (GL_INVALID_ENUM).
BufferObject* buffer_of(Context& c, GLenum target, const char* argument = "target");

/// The buffer is mapped no more.
void unmap(BufferObject& buffer);
/// To be called when the contents of the buffer have changed.
void note_contents(Context& c, BufferObject& buffer);
/// Gives the buffer bytes of its own when a frame still reads them, and notes that they change. Throws
/// std::bad_alloc.
void make_writable(Context& c, BufferObject& buffer);

} // namespace softgl
