// DrawArrays, DrawElements and their relatives (GL 1.5, 2.8).
#include <algorithm>
#include <cstring>

#include "base/fast_paths.h"
#include "commands/generated/commands.h"
#include "commands/vertices/array_element.h"
#include "commands/vertices/array_fetch.h"
#include "commands/vertices/attribute_doors.h"
#include "commands/vertices/index_range.h"
#include "commands/vertices/list_compilation.h"
#include "commands/vertices/vertex_chunk.h"
#include "commands/vertices/vertex_stream.h"
#include "context/buffer_objects.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"
#include "snapshot/render_targets.h"
#include "snapshot/submit.h"

namespace softgl {
namespace {

/// What all draws ask first. False: nothing is to be drawn. `argument`: what the command calls the count.
bool may_draw(Context& c, GLenum mode, GLsizei count, const char* argument = "count") {
  if (c.builder.compiling && c.builder.mode != kNoPrimitive)
    return raise_error(c, {GL_INVALID_OPERATION}), false;
  if (mode > GL_POLYGON) return raise_error(c, {GL_INVALID_ENUM, "mode"}), false;
  if (count < 0) return raise_error(c, {GL_INVALID_VALUE, argument}), false;
  if (c.builder.compiling)
    compile_error(c, {GL_NO_ERROR}); // also where nothing is to be drawn
  else if (c.bindings.draw)
    return ready_to_draw(c); // an incomplete framebuffer object is an error then, too
  return true;
}

void submit_arrays(Context& c, const VertexSource* source, DrawCall call) {
  call.source = source;
  call.constant = current_constants(c);
  submit(c, call);
}

void set_primitive(Context& c, GLenum mode, uint32_t first, uint32_t count, DrawCall& call) {
  call.primitives = c.frame.arena().make<PrimitiveRange>(PrimitiveRange{mode, first, count});
  call.primitive_count = 1;
}

void draw_arrays(Context& c, GLenum mode, uint32_t first, uint32_t count) {
  ArrayCache* arrays = current_arrays(c);
  if (!arrays || !arrays->drawable || first >= arrays->limit) return;
  count = uint32_t(std::min<uint64_t>(count, arrays->limit - first));
  if (c.builder.compiling) {
    open_array_run(c);
    gl::Begin(c, mode);
    for (uint32_t i = 0; i < count; ++i) emit_array_element(c, *arrays, first + i);
    gl::End(c);
    return hide_array_run(c);
  }
  count = complete_vertices(mode, count);
  if (!count) return;
  DrawCall call;
  call.first_vertex = first;
  call.vertex_count = count;
  set_primitive(c, mode, first, count, call);
  submit_arrays(c, fetch_range(c, *arrays, first, first + count - 1), call);
}

/// The indices of a draw in memory that the frame keeps, and their range.
struct DrawIndices {
  const void* data = nullptr;
  uint32_t count = 0;
  IndexRange range;
};

DrawIndices indices_of(Context& c, GLenum mode, uint32_t count, GLenum type, const void* pointer) {
  const uint32_t bytes = index_bytes(type);
  const std::shared_ptr<BufferObject>& buffer = c.client.vertex_array.element_array_object;
  DrawIndices result;
  if (!buffer) {
    result.count = complete_vertices(mode, count);
    if (!pointer || !result.count) return {};
    void* copy = c.frame.arena().allocate(size_t(result.count) * bytes);
    result.range = copy_indices(pointer, type, result.count, copy);
    result.data = copy;
    return result;
  }
  const size_t offset = reinterpret_cast<size_t>(pointer), size = buffer->size();
  if (offset >= size) return {};
  result.count = complete_vertices(mode, uint32_t(std::min<size_t>(count, (size - offset) / bytes)));
  if (!result.count) return {};
  const unsigned char* data = buffer->storage->bytes + offset;
  if (offset % bytes) {
    void* copy = c.frame.arena().allocate(size_t(result.count) * bytes);
    result.range = copy_indices(data, type, result.count, copy);
    result.data = copy;
    return result;
  }
  result.range = index_range(*buffer, offset, type, result.count);
  result.data = data;
  if (c.arrays.retained_indices != buffer->storage.get()) {
    c.frame.retain(buffer->storage, buffer->storage->size);
    c.arrays.retained_indices = buffer->storage.get();
  }
  return result;
}

/// Where the indices lie: in the client's memory, or in the buffer, then `count` becomes what it holds at
/// most. Null: nowhere.
const void* index_memory(const BufferObject* buffer, const void* pointer, GLenum type, uint32_t& count) {
  if (!buffer) return pointer;
  const size_t offset = reinterpret_cast<size_t>(pointer), size = buffer->size();
  count = offset < size ? uint32_t(std::min<size_t>(count, (size - offset) / index_bytes(type))) : 0;
  return count ? buffer->storage->bytes + offset : nullptr;
}

/// The indices with `base` added (GL_ARB_draw_elements_base_vertex), as GL_UNSIGNED_INT: a sum may need more
/// bits than the type has.
DrawIndices moved_indices(Context& c, GLenum mode, uint32_t count, GLenum type, const void* pointer,
                          GLint base) {
  const void* from = index_memory(c.client.vertex_array.element_array_object.get(), pointer, type, count);
  DrawIndices result;
  result.count = complete_vertices(mode, count);
  if (!from || !result.count) return {};
  auto* moved = c.frame.arena().allocate_array<uint32_t>(result.count);
  for (uint32_t i = 0; i < result.count; ++i) moved[i] = load_index(from, type, i) + uint32_t(base);
  result.range = index_range(moved, GL_UNSIGNED_INT, result.count);
  result.data = moved;
  return result;
}

/// The indices between which primitives begin anew, with `base` added, and the primitives. None where no
/// index is that of GL_PRIMITIVE_RESTART_INDEX, which is compared before the addition
/// (GL_ARB_draw_elements_base_vertex).
DrawIndices restarting_indices(Context& c, GLenum mode, uint32_t count, GLenum type, const void* pointer,
                               GLint base, DrawCall& call) {
  const GLuint restart = c.client.vertex_array.restart_index;
  const void* from = index_memory(c.client.vertex_array.element_array_object.get(), pointer, type, count);
  uint32_t pieces = 1;
  for (uint32_t i = 0; from && i < count; ++i) pieces += load_index(from, type, i) == restart;
  if (pieces == 1) return {};
  auto* primitives = c.frame.arena().allocate_array<PrimitiveRange>(pieces);
  auto* indices = c.frame.arena().allocate_array<uint32_t>(count);
  DrawIndices result;
  result.data = indices;
  uint32_t first = 0;
  const auto end_piece = [&] {
    const uint32_t whole = complete_vertices(mode, result.count - first);
    if (whole) primitives[call.primitive_count++] = {mode, first, whole};
    first = result.count = first + whole;
  };
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t index = load_index(from, type, i);
    if (index == restart)
      end_piece();
    else
      indices[result.count++] = index + uint32_t(base);
  }
  end_piece();
  call.primitives = primitives;
  if (result.count) result.range = index_range(indices, GL_UNSIGNED_INT, result.count);
  return result;
}

void draw_elements(Context& c, GLenum mode, uint32_t count, GLenum type, const void* pointer,
                   GLint base = 0) {
  ArrayCache* arrays = current_arrays(c);
  if (!arrays) return;
  const BufferObject* buffer = c.client.vertex_array.element_array_object.get();
  if (buffer && buffer->mapped) return set_error(c, GL_INVALID_OPERATION);
  if (!arrays->drawable) return;
  const bool restarts = c.client.vertex_array.restarts;
  if (c.builder.compiling) {
    const void* indices = index_memory(buffer, pointer, type, count);
    if (!indices) return;
    open_array_run(c);
    gl::Begin(c, mode);
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t index = load_index(indices, type, i);
      if (restarts && index == c.client.vertex_array.restart_index)
        gl::PrimitiveRestartNV(c);
      else
        emit_array_element(c, *arrays, index + uint32_t(base));
    }
    gl::End(c);
    return hide_array_run(c);
  }
  DrawCall call;
  DrawIndices indices;
  if (restarts) indices = restarting_indices(c, mode, count, type, pointer, base, call);
  if (indices.data) {
    type = GL_UNSIGNED_INT;
  } else {
    indices =
        base ? moved_indices(c, mode, count, type, pointer, base) : indices_of(c, mode, count, type, pointer);
    if (base) type = GL_UNSIGNED_INT;
    if (indices.count) set_primitive(c, mode, 0, indices.count, call);
  }
  if (!indices.count) return;
  const auto [low, high] = indices.range;
  // Vertices nobody asks for cost as much as the others, 2-4 ns; to look each index up costs 1-2 ns.
  const bool scattered = uint64_t(high) - low > 2 * uint64_t(indices.count) + 64;
  if (high >= arrays->limit || (scattered && takes(FastPath::CompactVertices))) {
    const CompactVertices vertices = compact(c, *arrays, indices.data, type, indices.count);
    call.indices = vertices.indices;
    call.vertex_count = vertices.vertex_count;
    return submit_arrays(c, vertices.source, call);
  }
  call.indices = indices.data;
  call.index_type = type;
  call.first_vertex = low;
  call.vertex_count = high - low + 1;
  submit_arrays(c, fetch_range(c, *arrays, low, high), call);
}

} // namespace

void gl::DrawArrays(Context& c, GLenum mode, GLint first, GLsizei count) {
  if (!may_draw(c, mode, count)) return;
  if (first < 0) return raise_error(c, {GL_INVALID_VALUE, "first"});
  draw_arrays(c, mode, SOFTGL_FAULT(first_ignored) ? 0 : uint32_t(first), uint32_t(count));
}

void gl::DrawElements(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices) {
  if (!may_draw(c, mode, count)) return;
  if (!index_bytes(type)) return raise_error(c, {GL_INVALID_ENUM, "type"});
  draw_elements(c, mode, uint32_t(count), type, indices);
}

void gl::DrawRangeElements(Context& c, GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                           const void* indices) {
  if (!may_draw(c, mode, count)) return;
  if (end < start) return raise_error(c, {GL_INVALID_VALUE, "end"});
  if (!index_bytes(type)) return raise_error(c, {GL_INVALID_ENUM, "type"});
  // Whether the indices keep to the range is not known, and to look costs little: the range is not used.
  draw_elements(c, mode, uint32_t(count), type, indices, SOFTGL_FAULT(range_start_added) ? GLint(start) : 0);
}

void gl::MultiDrawArrays(Context& c, GLenum mode, const GLint* first, const GLsizei* count, GLsizei draws) {
  if (!may_draw(c, mode, draws, "drawcount")) return;
  for (GLsizei i = 0; i < draws; ++i)
    if (const char* wrong = first_wrong({{"count", count[i] < 0}, {"first", count[i] > 0 && first[i] < 0}}))
      return raise_error(c, {GL_INVALID_VALUE, wrong});
  for (GLsizei i = 0; i < draws; ++i)
    if (count[i] > 0) draw_arrays(c, mode, uint32_t(first[i]), uint32_t(count[i]));
}

void gl::MultiDrawElements(Context& c, GLenum mode, const GLsizei* count, GLenum type,
                           const void* const* indices, GLsizei draws) {
  if (!may_draw(c, mode, draws, "drawcount")) return;
  if (!index_bytes(type)) return raise_error(c, {GL_INVALID_ENUM, "type"});
  for (GLsizei i = 0; i < draws; ++i)
    if (count[i] < 0) return raise_error(c, {GL_INVALID_VALUE, "count"});
  for (GLsizei i = 0; i < draws; ++i)
    if (count[i] > 0) draw_elements(c, mode, uint32_t(count[i]), type, indices[i]);
}

namespace {

/// What draws of several modes ask before the first one.
bool may_draw_several(Context& c, GLsizei draws) {
  if (draws < 0) return raise_error(c, {GL_INVALID_VALUE, "primcount"}), false;
  if (c.builder.compiling) compile_error(c, {GL_NO_ERROR}); // also where nothing is to be drawn
  return true;
}

/// The mode of a primitive, `stride` bytes behind the one before (GL_IBM_multimode_draw_arrays).
GLenum mode_at(const GLenum* modes, GLsizei i, GLint stride) {
  GLenum mode;
  std::memcpy(&mode, reinterpret_cast<const char*>(modes) + ptrdiff_t(i) * stride, sizeof mode);
  return mode;
}

} // namespace

void gl::MultiModeDrawArraysIBM(Context& c, const GLenum* modes, const GLint* first, const GLsizei* count,
                                GLsizei draws, GLint stride) {
  if (!may_draw_several(c, draws)) return;
  for (GLsizei i = 0; i < draws; ++i)
    if (count[i] > 0) DrawArrays(c, mode_at(modes, i, stride), first[i], count[i]);
}

void gl::MultiModeDrawElementsIBM(Context& c, const GLenum* modes, const GLsizei* count, GLenum type,
                                  const void* const* indices, GLsizei draws, GLint stride) {
  if (!may_draw_several(c, draws)) return;
  for (GLsizei i = 0; i < draws; ++i)
    if (count[i] > 0) DrawElements(c, mode_at(modes, i, stride), count[i], type, indices[i]);
}

void gl::DrawElementsBaseVertex(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices,
                                GLint base) {
  if (!may_draw(c, mode, count)) return;
  if (!index_bytes(type)) return raise_error(c, {GL_INVALID_ENUM, "type"});
  draw_elements(c, mode, uint32_t(count), type, indices, base);
}

void gl::DrawRangeElementsBaseVertex(Context& c, GLenum mode, GLuint start, GLuint end, GLsizei count,
                                     GLenum type, const void* indices, GLint base) {
  if (!may_draw(c, mode, count)) return;
  if (end < start) return raise_error(c, {GL_INVALID_VALUE, "end"});
  if (!index_bytes(type)) return raise_error(c, {GL_INVALID_ENUM, "type"});
  draw_elements(c, mode, uint32_t(count), type, indices, base);
}

void gl::MultiDrawElementsBaseVertex(Context& c, GLenum mode, const GLsizei* count, GLenum type,
                                     const void* const* indices, GLsizei draws, const GLint* base) {
  if (!may_draw(c, mode, draws, "drawcount")) return;
  if (!index_bytes(type)) return raise_error(c, {GL_INVALID_ENUM, "type"});
  for (GLsizei i = 0; i < draws; ++i)
    if (count[i] < 0) return raise_error(c, {GL_INVALID_VALUE, "count"});
  for (GLsizei i = 0; i < draws; ++i)
    if (count[i] > 0) draw_elements(c, mode, uint32_t(count[i]), type, indices[i], base[i]);
}

void gl::ArrayElement(Context& c, GLint i) {
  if (c.guard & kNoContext) return;
  if (i < 0) return raise_error(c, {GL_INVALID_VALUE, "i"}, true);
  const VertexArrayState& state = c.client.vertex_array;
  if (state.restarts && GLuint(i) == state.restart_index) return gl::PrimitiveRestartNV(c);
  if (const ArrayCache* arrays = current_arrays(c)) emit_array_element(c, *arrays, uint32_t(i));
}

void gl::PrimitiveRestartIndex(Context& c, GLuint index) { c.client.vertex_array.restart_index = index; }

void gl::PrimitiveRestartNV(Context& c) {
  if (c.guard & kNoContext) return;
  const GLenum mode = c.builder.mode;
  if (mode == kNoPrimitive) return raise_error(c, {GL_INVALID_OPERATION});
  gl::End(c);
  gl::Begin(c, mode);
}

void gl::Rect(Context& c, GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2) {
  gl::Begin(c, GL_QUADS); // the specification says GL_POLYGON; OSMesa 22.3.6 draws a quad: the same but for
                          // its diagonal
  if (SOFTGL_FAULT(rect_faces_viewer) && (x2 < x1) != (y2 < y1)) std::swap(x1, x2);
  emit_vertex2(c, x1, y1);
  emit_vertex2(c, x2, y1);
  emit_vertex2(c, x2, y2);
  emit_vertex2(c, x1, y2);
  gl::End(c);
}

} // namespace softgl
