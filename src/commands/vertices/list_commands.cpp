#include "commands/vertices/list_commands.h"
#include "commands/vertices/list_compilation.h"
#include "commands/vertices/list_player.h"
#include "commands/vertices/vertex_stream.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "context/context.h"
#include "context/display_list.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {
namespace {

/// The size of an element of CallLists; 0: no such type.
size_t offset_bytes(GLenum type) {
  switch (type) {
  case GL_BYTE:
  case GL_UNSIGNED_BYTE: return 1;
  case GL_SHORT:
  case GL_UNSIGNED_SHORT:
  case GL_2_BYTES: return 2;
  case GL_3_BYTES: return 3;
  case GL_INT:
  case GL_UNSIGNED_INT:
  case GL_FLOAT:
  case GL_4_BYTES: return 4;
  default: return 0;
  }
}

template <class T> T load(const unsigned char* p) {
  T value;
  std::memcpy(&value, p, sizeof value);
  return value;
}

/// Element i of CallLists. Signed offsets count modulo 2^32.
GLuint offset_at(GLenum type, const unsigned char* p) {
  switch (type) {
  case GL_BYTE: return SOFTGL_FAULT(list_bytes_unsigned) ? *p : GLuint(GLint(load<GLbyte>(p)));
  case GL_UNSIGNED_BYTE: return *p;
  case GL_SHORT: return GLuint(GLint(load<GLshort>(p)));
  case GL_UNSIGNED_SHORT: return load<GLushort>(p);
  case GL_INT:
  case GL_UNSIGNED_INT: return load<GLuint>(p);
  case GL_FLOAT: {
    const float f = load<float>(p);
    return f > -2147483648.0f && f < 4294967296.0f ? GLuint(int64_t(f)) : 0;
  }
  case GL_2_BYTES: return p[0] << 8 | p[1];
  case GL_3_BYTES:
    if (SOFTGL_FAULT(list_bytes_reversed)) return p[2] << 16 | p[1] << 8 | p[0];
    return p[0] << 16 | p[1] << 8 | p[2];
  default: return GLuint(p[0]) << 24 | p[1] << 16 | p[2] << 8 | p[3];
  }
}

} // namespace

void call_list(Context& c, GLuint name) {
  if (c.lists.depth >= (SOFTGL_FAULT(lists_call_no_lists) ? 1 : kMaxListNesting)) return;
  const std::shared_ptr<DisplayList> list = c.shared->lists.find(name);
  if (!list) return;
  struct Depth {
    int& value;
    explicit Depth(int& v) : value(v) { ++value; }
    ~Depth() { --value; }
  } depth(c.lists.depth);
  play_list(c, *list);
}

void gl::NewList(Context& c, GLuint name, GLenum mode) {
  if (c.lists.list) return set_error(c, GL_INVALID_OPERATION);
  if (name == 0) return set_error(c, GL_INVALID_VALUE, "list");
  if (mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE) return set_error(c, GL_INVALID_ENUM, "mode");
  c.lists.list = std::make_shared<DisplayList>();
  c.lists.name = name;
  c.lists.mode = mode;
  c.lists.failed = false;
  c.lists.executing_builder = std::exchange(c.builder, VertexBuilder{});
  c.lists.executing_guard = std::exchange(c.guard, uint32_t(kCompilingList));
  c.builder.compiling = true;
}

void gl::EndList(Context& c) {
  if (!c.lists.list) return set_error(c, GL_INVALID_OPERATION);
  close_compiled_run(c);
  // When the list is executed, too, its Begin has been executed.
  if (c.lists.mode == GL_COMPILE_AND_EXECUTE && c.lists.executing_guard & kInsideBeginEnd)
    return set_error(c, GL_INVALID_OPERATION);
  std::shared_ptr<DisplayList> list = std::move(c.lists.list);
  c.lists.list = nullptr;
  c.builder = std::exchange(c.lists.executing_builder, VertexBuilder{});
  c.guard = c.lists.executing_guard;
  if (c.lists.failed) return set_error(c, GL_OUT_OF_MEMORY);
  list->records.shrink_to_fit();
  if (SOFTGL_FAULT(list_not_replaced) && c.shared->lists.used(c.lists.name)) return;
  c.shared->lists.set(c.lists.name, std::move(list));
}

void gl::CallList(Context& c, GLuint name) {
  if (c.guard & kNoContext) return;
  if (name == 0) return raise_error(c, {GL_INVALID_VALUE, "list"}, true);
  if (!c.builder.compiling) return call_list(c, name);
  *static_cast<uint64_t*>(record(c, kPlayCallList, 8)) = name;
  if (execute_too(c)) {
    ExecuteScope scope(c);
    call_list(c, name);
  }
}

void gl::CallLists(Context& c, GLsizei n, GLenum type, const void* lists) {
  if (c.guard & kNoContext) return;
  const size_t size = offset_bytes(type);
  if (n < 0) return raise_error(c, {GL_INVALID_VALUE, "n"}, true);
  if (!size) return raise_error(c, {GL_INVALID_ENUM, "type"}, true);
  if (n == 0 || !lists) return;
  const auto* bytes = static_cast<const unsigned char*>(lists);
  const auto play = [&] {
    for (GLsizei i = 0; i < n; ++i)
      call_list(c, (SOFTGL_FAULT(list_base_ignored) ? 0 : c.state.list.base) +
                       offset_at(type, bytes + size_t(i) * size));
  };
  if (!c.builder.compiling) return play();
  auto* arguments = static_cast<uint64_t*>(record(c, kPlayCallLists, 8 + size_t(n) * sizeof(GLuint)));
  arguments[0] = uint64_t(n);
  for (GLsizei i = 0; i < n; ++i) {
    const GLuint offset = offset_at(type, bytes + size_t(i) * size) +
                          (SOFTGL_FAULT(list_base_at_compile) ? c.state.list.base : 0);
    std::memcpy(reinterpret_cast<unsigned char*>(arguments + 1) + size_t(i) * sizeof offset, &offset,
                sizeof offset);
  }
  if (execute_too(c)) {
    ExecuteScope scope(c);
    play();
  }
}

void gl::ListBase(Context& c, GLuint base) { c.state.list.base = base; }

GLuint gl::GenLists(Context& c, GLsizei range) {
  if (range < 0) {
    set_error(c, GL_INVALID_VALUE, "range");
    return 0;
  }
  constexpr GLsizei kMostLists =
      1 << 22; // at some 70 bytes a name, before a mistaken number takes all memory
  if (range > kMostLists) {
    set_error(c, GL_OUT_OF_MEMORY);
    return 0;
  }
  // A generated list is an empty one (5.4); all of them are the same empty one until they are defined.
  const auto empty = std::make_shared<DisplayList>();
  const GLuint first = c.shared->lists.reserve_block(range);
  if (first)
    for (GLsizei i = 0; i < range; ++i) c.shared->lists.set(first + GLuint(i), empty);
  return first;
}

void gl::DeleteLists(Context& c, GLuint first, GLsizei range) {
  if (range < 0) return set_error(c, GL_INVALID_VALUE, "range");
  c.shared->lists.erase_block(first, GLuint(SOFTGL_FAULT(one_list_deleted) ? std::min(range, 1) : range));
}

GLboolean gl::IsList(Context& c, GLuint name) { return c.shared->lists.used(name); }

} // namespace softgl
