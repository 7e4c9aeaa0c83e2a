#include "commands/vertices/vertex_stream.h"
#include "snapshot/submit.h"

#include <algorithm>
#include <cstring>

#include "base/assert.h"
#include "base/bits.h"
#include "commands/vertices/attribute_doors.h"
#include "commands/vertices/list_compilation.h"
#include "commands/vertices/vertex_chunk.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"
#include "snapshot/render_targets.h"

namespace softgl {
namespace {

// A new attribute between two primitives: up to here the waiting vertices are widened, above the run is
// closed.
constexpr uint32_t kWidenLimit = 64;
// One that is interpolated widens none of them. Behind more vertices than these it has no slot if it has the
// value of before.
constexpr uint32_t kConstantBehind = 8;

/// Hands the chunk's primitives to the frame. Afterwards no chunk is open, whether memory sufficed or not.
void draw_chunk(Context& c) {
  VertexBuilder& b = c.builder;
  if (!b.base) return;
  struct Emptied {
    VertexBuilder& builder;
    ~Emptied() { builder.primitives.clear(); }
  } const emptied{b};
  const uint32_t count = b.vertex_count();
  const float* base = b.base;
  SOFTGL_ASSERT(b.out == base + size_t(count) * 4 * b.slots);
  SOFTGL_ASSERT(size_t(count) * b.slots * 16 <= b.capacity);
  Arena& arena = c.frame.arena();
  arena.give_back(b.base, size_t(count) * b.slots * 16);
  b.base = b.out = nullptr;
  if (b.primitives.empty()) return;
  auto* source = arena.allocate_array<VertexSource>(1); // only the present streams are written
  source->present = b.present;
  for (const int slot : Bits(b.present)) {
    source->stream[slot] =
        AttributeStream{reinterpret_cast<const unsigned char*>(base + 4 * b.offset[slot]), 16 * b.slots};
  }
  DrawCall call;
  call.source = source;
  call.constant = current_constants(c);
  call.primitive_count = uint32_t(b.primitives.size());
  auto* primitives = arena.allocate_array<PrimitiveRange>(b.primitives.size());
  std::memcpy(primitives, b.primitives.data(), b.primitives.size() * sizeof(PrimitiveRange));
  call.primitives = primitives;
  call.vertex_count = count;
  submit(c, call);
}

/// The chunk is full in the middle of a primitive: draws what it holds and goes on in a new one, which begins
/// with the vertices that the rest of the primitive needs again.
void split_run(Context& c) {
  VertexBuilder& b = c.builder;
  const uint32_t total = b.vertex_count(), count = total - b.first, stride = 4 * b.slots;
  uint32_t drawn = complete_vertices(b.mode, count), carried = 0, carry[8];
  bool one_piece = true, was_continued = b.continued;
  const auto carry_last = [&](uint32_t n) {
    for (uint32_t i = n; i > 0; --i) carry[carried++] = total - i;
  };
  switch (b.mode) {
  case GL_POINTS:
  case GL_LINES:
  case GL_TRIANGLES:
  case GL_QUADS: carry_last(count - drawn); break;
  case GL_LINE_STRIP:
    carry_last(count ? 1 : 0);
    one_piece = false;
    break;
  case GL_TRIANGLE_STRIP:
  case GL_QUAD_STRIP:
    // Cut at an even vertex, so that the next piece starts with the same orientation.
    drawn = count >= 4 ? count & ~1u : 0;
    carry_last(drawn ? 2 + (count & 1) : count);
    one_piece = false;
    break;
  default: // loop, fan, polygon: the first vertex and the last
    if (count <= 2) {
      drawn = 0;
      carry_last(count);
    } else {
      drawn = count;
      carry[carried++] = b.first;
      carry_last(1);
    }
    one_piece = false;
  }
  alignas(16) float kept[8][4 * kAttributeSlots]; // submit() may free the arena
  for (uint32_t i = 0; i < carried; ++i)
    std::memcpy(kept[i], b.base + size_t(carry[i]) * stride, stride * sizeof(float));
  if (drawn) b.primitives.push_back({b.mode, b.first, drawn, one_piece || !b.continued, one_piece});
  b.out = b.base + size_t(b.first + drawn) * stride;
  b.continued = was_continued || (drawn && !one_piece);
  draw_chunk(c);
  open_chunk(c);
  for (uint32_t i = 0; i < carried; ++i, b.out += stride) std::memcpy(b.out, kept[i], stride * sizeof(float));
  b.first = 0;
}

/// The stipple pattern runs through a strip, and around a polygon.
bool stays_in_one_piece(const Context& c) {
  const GLenum mode = c.builder.mode;
  return c.state.line.stipple && (mode == GL_LINE_STRIP || mode == GL_LINE_LOOP || mode == GL_POLYGON);
}

/// Draws the primitives that wait, and goes on with vertices of the same layout: inside of a primitive with
/// those that its rest needs again.
void draw_earlier_vertices(Context& c) {
  VertexBuilder& b = c.builder;
  if (b.inside()) {
    split_run(c);
    b.limit = room_end(b);
  } else {
    draw_chunk(c);
    open_chunk(c);
  }
}

/// Of these attributes: those that are interpolated where a slot has them, and go to the fragments as they
/// are where none has, which may be another last bit. Vertices that were given before such a slot keep to the
/// latter, as in OSMesa.
uint32_t interpolated_by_slot(const Context& c, uint32_t attributes) {
  const uint32_t colors = c.state.lighting.enabled ? 0 : 1u << kColor | 1u << kSecondaryColor;
  return attributes & (colors | 0xffu << kTexCoord0);
}

/// Whether an attribute that is set between Begin and End, and has no slot, comes behind something to draw.
bool parts_run(const Context& c, int slot) {
  const VertexBuilder& b = c.builder;
  if (b.compiling || !b.base || !interpolated_by_slot(c, 1u << slot) || stays_in_one_piece(c)) return false;
  return !b.primitives.empty() || complete_vertices(b.mode, b.vertex_count() - b.first);
}

/// A slot for an attribute of the run; the vertices that wait have the value that was current. In a list that
/// is known if a record before the run sets it, else it is the one of play time.
void add_attribute(Context& c, int slot) {
  VertexBuilder& b = c.builder;
  static constexpr float unknown[4] = {0, 0, 0, 1};
  const bool recorded = b.recorded >> slot & 1;
  add_slot(c, slot,
           !b.compiling ? &c.state.current.slot[slot].x
           : recorded   ? b.recorded_value[slot]
                        : unknown);
  if (recorded) b.first_set[slot] = 0;
}

/// Whether an attribute set since the last primitive has another value than the vertices that wait.
bool changes(const Context& c, int slot) {
  return !same_bits(c.builder.deferred_value[slot], &c.state.current.slot[slot], 16);
}

/// Attributes set since the last primitive get a slot where their value differs from the one before, and the
/// vertices that wait are drawn without those that are interpolated. Attributes in front of all vertices of a
/// list's run do not change in it so far.
void apply_deferred(Context& c) {
  VertexBuilder& b = c.builder;
  const uint32_t waiting = b.compiling ? 0 : b.vertex_count();
  uint32_t changed = 0, interpolated = 0;
  for (const int slot : Bits(b.deferred)) changed |= uint32_t(changes(c, slot)) << slot;
  if (waiting > kWidenLimit && changed) {
    close_run(c);
    return open_chunk(c);
  }
  if (waiting) interpolated = interpolated_by_slot(c, waiting > kConstantBehind ? changed : b.deferred);
  if (interpolated) draw_earlier_vertices(c);
  for (const int slot : Bits(b.compiling ? b.deferred : changed | interpolated)) {
    const float* now = b.deferred_value[slot];
    if (b.vertex_count() == 0 && !(interpolated >> slot & 1)) {
      b.compiling ? record_attribute(c, slot, now) : set_current(c, slot, now);
      continue;
    }
    add_attribute(c, slot);
    std::memcpy(b.value[b.offset[slot]], now, 16);
  }
  b.deferred = 0;
}

} // namespace

void gl::Begin(Context& c, GLenum mode) {
  VertexBuilder& b = c.builder;
  if (c.guard & kNoContext) return;
  if (mode > GL_POLYGON) return raise_error(c, {GL_INVALID_ENUM, "mode"});
  if (b.mode != kNoPrimitive) return raise_error(c, {GL_INVALID_OPERATION});
  if (!b.compiling && !draw_target_complete(c)) return set_error(c, GL_INVALID_FRAMEBUFFER_OPERATION);
  // Vertices whose Begin is in no known list, or those of array draws.
  if (b.limit || b.array_run == ArrayRun::Hidden) close_compiled_run(c);
  b.dropping = b.compiling && c.lists.failed;
  or_drop_vertices(c, [&] {
    if (b.dropping) return;
    if (!b.base) open_chunk(c);
    if (b.deferred) apply_deferred(c);
  });
  b.mode = mode;
  b.dropping = !b.base;
  b.first = b.vertex_count();
  b.continued = false;
  b.limit = b.base ? room_end(b) : nullptr;
  c.guard |= kInsideBeginEnd | kRunPending;
}

void gl::End(Context& c) {
  VertexBuilder& b = c.builder;
  if (c.guard & kNoContext) return;
  if (b.mode == kNoPrimitive) return b.compiling ? compile_end(c) : set_error(c, GL_INVALID_OPERATION);
  const GLenum mode = b.mode;
  const uint32_t count = b.vertex_count() - b.first,
                 kept = SOFTGL_FAULT(left_over_vertices_stay) ? count : complete_vertices(mode, count);
  b.out -= size_t(count - kept) * 4 * b.slots;
  if (b.compiling && kept < count) // attributes set after vertices that are dropped now
    for (uint32_t& first : b.first_set) first = std::min(first, b.first + kept);
  b.mode = kNoPrimitive;
  b.limit = nullptr;
  c.guard &= ~kInsideBeginEnd;
  if (!kept) {
    if (b.compiling) compile_error(c, {GL_NO_ERROR});
    return;
  }
  const bool independent = mode == GL_POINTS || mode == GL_LINES || mode == GL_TRIANGLES || mode == GL_QUADS;
  if (independent && !b.primitives.empty()) {
    PrimitiveRange& before = b.primitives.back();
    if (before.mode == mode && before.first + before.count == b.first) {
      before.count += kept;
      return;
    }
  }
  or_drop_vertices(c, [&] { b.primitives.push_back({mode, b.first, kept, !b.continued, true}); });
}

void close_run(Context& c) {
  VertexBuilder& b = c.builder;
  if (b.inside()) return;
  if (b.compiling) return close_compiled_run(c);
  c.guard &= ~kRunPending;
  or_drop_vertices(c, [&] { draw_chunk(c); });
  for (const int slot : Bits(b.present & ~1u)) set_current(c, slot, b.value[b.offset[slot]]);
  for (const int slot : Bits(b.deferred)) set_current(c, slot, b.deferred_value[slot]);
  b.deferred = 0;
  SOFTGL_ASSERT(!b.base && !b.limit && b.primitives.empty()); // no run is open
  forget_layout(b);
}

void set_current(Context& c, int slot, const float* value) {
  Vec4& current = c.state.current.slot[slot];
  if (same_bits(&current, value, 16)) return;
  std::memcpy(&current, value, 16);
  c.dirty |= slot >= kMaterial0 ? kDirtyMaterial : kDirtyCurrent;
}

const Vec4* current_constants(Context& c) {
  if (c.dirty & kDirtyCurrent || !c.builder.constants) {
    auto* block = c.frame.arena().allocate_array<Vec4>(kMaterial0);
    std::memcpy(block, c.state.current.slot, kMaterial0 * sizeof(Vec4));
    c.builder.constants = block;
    c.dirty &= ~kDirtyCurrent;
  }
  return c.builder.constants;
}

void set_absent_attribute(Context& c, int slot, float x, float y, float z, float w) {
  VertexBuilder& b = c.builder;
  if (c.guard & kNoContext) return;
  if (b.array_run == ArrayRun::Hidden) close_compiled_run(c);
  alignas(16) const float now[4] = {x, y, z, w};
  if (b.inside() && !b.dropping) {
    b.set_inside |= 1u << slot;
    or_drop_vertices(c, [&] {
      if (parts_run(c, slot)) draw_earlier_vertices(c);
      add_attribute(c, slot);
    });
  }
  if (b.offset[slot]) {
    std::memcpy(b.value[b.offset[slot]], now, 16);
  } else if (b.compiling || c.guard & kRunPending) {
    std::memcpy(b.deferred_value[slot], now, 16);
    b.deferred |= 1u << slot;
    c.guard |= kRunPending;
  } else {
    set_current(c, slot, now);
  }
}

void emit_vertex_without_room(Context& c, float x, float y, float z, float w) {
  VertexBuilder& b = c.builder;
  // A vertex outside Begin and End is undefined: none. In a list it may come between Begin and End of the
  // caller.
  if (c.guard & kNoContext || b.dropping || (!b.limit && !b.compiling)) return;
  or_drop_vertices(c, [&] {
    if (!b.limit) {
      close_run(c);
      if (b.dropping) return;
      open_chunk(c);
      c.guard |= kRunPending;
    } else if (b.compiling || stays_in_one_piece(c)) {
      grow_chunk(c, 2 * b.capacity);
    } else {
      split_run(c);
    }
    b.limit = room_end(b);
  });
  if (!b.dropping) emit_vertex4(c, x, y, z, w);
}

} // namespace softgl
