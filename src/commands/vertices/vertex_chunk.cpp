#include "commands/vertices/vertex_chunk.h"

#include <algorithm>
#include <cstring>

#include "base/assert.h"

namespace softgl {
namespace {

/// The builder's pointers and its layout fit together.
void check_builder(const VertexBuilder& b) {
  SOFTGL_ASSERT((b.base != nullptr) == (b.out != nullptr));
  SOFTGL_ASSERT(b.base || !b.limit);
  SOFTGL_ASSERT(b.out - b.base == 4 * ptrdiff_t(b.slots) * ptrdiff_t(b.vertex_count()));
  SOFTGL_ASSERT(!b.base || size_t(b.out - b.base) * sizeof(float) <= b.capacity);
  SOFTGL_ASSERT(!b.limit || b.limit == room_end(b));
  SOFTGL_ASSERT(b.slots == uint32_t(__builtin_popcount(b.present)));
  SOFTGL_ASSERT(b.compiling || !b.memory);
}

} // namespace

float* room_end(const VertexBuilder& b) {
  return b.base + b.capacity / sizeof(float) - 4 * ptrdiff_t(b.slots) + 1;
}

void open_chunk(Context& c, size_t minimum) {
  VertexBuilder& b = c.builder;
  SOFTGL_ASSERT(!b.base && !b.memory); // no chunk is open
  if (b.compiling) {
    b.memory.reset(static_cast<float*>(std::malloc(minimum)));
    if (!b.memory) throw std::bad_alloc();
    b.base = b.memory.get();
    b.capacity = minimum;
  } else {
    b.base = static_cast<float*>(c.frame.arena().allocate_rest(minimum, b.capacity));
  }
  b.out = b.base;
}

void grow_chunk(Context& c, size_t bytes) {
  VertexBuilder& b = c.builder;
  const size_t used = size_t(b.out - b.base) * sizeof(float);
  SOFTGL_ASSERT(b.base && bytes >= used);
  if (b.compiling) {
    auto* moved = static_cast<float*>(std::realloc(b.memory.get(), bytes));
    if (!moved) throw std::bad_alloc();
    (void)b.memory.release(); // realloc() has freed it
    b.memory.reset(moved);
    b.base = moved;
    b.capacity = bytes;
  } else {
    const float* old = b.base;
    c.frame.arena().give_back(b.base, used);
    b.base = nullptr;
    open_chunk(c, bytes);
    std::memcpy(b.base, old, used);
  }
  b.out = b.base + used / sizeof(float);
}

void add_slot(Context& c, int slot, const float* earlier) {
  VertexBuilder& b = c.builder;
  const uint32_t count = b.vertex_count(), old = b.slots, slots = old + 1;
  const size_t bytes = (size_t(count) + 1) * slots * 16;
  check_builder(b);
  SOFTGL_ASSERT(b.base && slots <= kAttributeSlots && !(b.present >> slot & 1));
  if (bytes > b.capacity) grow_chunk(c, 2 * bytes);
  for (uint32_t i = count; i-- > 0;) {
    float* to = b.base + size_t(i) * 4 * slots;
    std::memmove(to, b.base + size_t(i) * 4 * old, old * 16);
    std::memcpy(to + 4 * old, earlier, 16);
  }
  b.out = b.base + size_t(count) * 4 * slots;
  b.offset[slot] = uint8_t(old);
  b.slots = slots;
  b.present |= 1u << slot;
  b.first_set[slot] = count;
  if (b.inside()) b.limit = room_end(b);
}

void remove_slot(VertexBuilder& b, int slot) {
  const uint32_t count = b.vertex_count(), old = b.slots, slots = old - 1, gone = b.offset[slot];
  check_builder(b);
  SOFTGL_ASSERT(gone && gone < old && b.present >> slot & 1 && !b.inside());
  for (uint32_t i = 0; i < count; ++i) {
    const float* from = b.base + size_t(i) * 4 * old;
    float* to = b.base + size_t(i) * 4 * slots;
    std::memmove(to, from, gone * 16);
    std::memmove(to + 4 * gone, from + 4 * (gone + 1), (old - 1 - gone) * 16);
  }
  std::memmove(b.value[gone], b.value[gone + 1], (old - 1 - gone) * 16);
  for (auto& offset : b.offset)
    if (offset > gone) --offset;
  b.offset[slot] = 0;
  b.present &= ~(1u << slot);
  b.slots = slots;
  b.out = b.base + size_t(count) * 4 * slots;
}

void forget_vertices(VertexBuilder& b) {
  b.base = b.out = b.limit = nullptr;
  b.capacity = 0;
  b.memory.reset();
  b.primitives.clear();
}

void forget_layout(VertexBuilder& b) {
  b.slots = b.present = 1;
  b.recorded = b.set_inside = 0;
  std::memset(b.offset, 0, sizeof b.offset);
}

void drop_vertices(Context& c) {
  VertexBuilder& b = c.builder;
  set_error(c, GL_OUT_OF_MEMORY);
  forget_vertices(b);
  b.first = 0;
  b.continued = false;
  b.dropping = b.compiling || b.mode != kNoPrimitive;
  if (b.compiling) c.lists.failed = true;
}

VerticesAside::VerticesAside(Context& c) : context_(c), open_(c.builder.base != nullptr) {
  if (!open_) return;
  VertexBuilder& b = c.builder;
  or_drop_vertices(c, [&] { vertices_.assign(b.base, b.out); });
  open_ = b.base != nullptr;
  if (open_) c.frame.arena().give_back(b.base, 0);
  b.base = b.out = b.limit = nullptr;
}

VerticesAside::~VerticesAside() {
  if (!open_) return;
  or_drop_vertices(context_, [&] {
    VertexBuilder& b = context_.builder;
    const size_t bytes = vertices_.size() * sizeof(float);
    open_chunk(context_, bytes + kSmallestChunk);
    b.out = std::copy(vertices_.begin(), vertices_.end(), b.base); // none, perhaps
    b.limit = room_end(b);
  });
}

uint32_t complete_vertices(GLenum mode, uint32_t count) {
  switch (mode) {
  case GL_POINTS: return count;
  case GL_LINES: return count & ~1u;
  case GL_TRIANGLES: return count - count % 3;
  case GL_QUADS: return count & ~3u;
  case GL_LINE_STRIP:
  case GL_LINE_LOOP: return count < 2 ? 0 : count; // a continued loop of two still has its closing line
  case GL_QUAD_STRIP: return count < 4 ? 0 : count & ~1u;
  default: return count < 3 ? 0 : count;
  }
}

} // namespace softgl
