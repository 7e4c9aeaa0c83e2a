#include "commands/vertices/list_compilation.h"
#include "commands/vertices/run_playback.h"
#include "commands/vertices/vertex_stream.h"

#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

#include "commands/vertices/attribute_doors.h"
#include "context/context.h"
#include "context/display_list.h"

namespace softgl {
namespace {

void* append(Context& c, uint16_t opcode, size_t bytes) {
  auto& records = c.lists.list->records;
  const size_t units = 1 + (bytes + 7) / 8, at = records.size();
  records.resize(at + units);
  const RecordHeader header{opcode, uint32_t(units)};
  std::memcpy(&records[at], &header, sizeof header);
  return units > 1 ? &records[at + 1] : nullptr;
}
void append_value(Context& c, uint16_t opcode, uint64_t value) {
  *static_cast<uint64_t*>(append(c, opcode, 8)) = value;
}

void append_attribute(Context& c, int slot, const float* value) {
  AttributeRecord r{uint64_t(slot), {}};
  std::memcpy(r.value, value, sizeof r.value);
  std::memcpy(append(c, kPlayAttribute, sizeof r), &r, sizeof r);
  if (execute_too(c)) {
    ExecuteScope scope(c); // `value` may be in the builder that this puts aside
    set_attribute4(c, slot, r.value[0], r.value[1], r.value[2], r.value[3]);
  }
}

/// True if all vertices have the same value of the attribute at `place`.
bool is_uniform(const float* vertices, uint32_t count, uint32_t slots, unsigned place) {
  for (uint32_t i = 1; i < count; ++i)
    if (std::memcmp(vertices + 4 * place, vertices + size_t(i) * 4 * slots + 4 * place, 16)) return false;
  return true;
}

/// Takes attribute `slot` out of the vertices.
void remove_slot(VertexBuilder& b, int slot) {
  const uint32_t count = b.vertex_count(), old = b.slots, slots = old - 1, gone = b.place[slot];
  for (uint32_t i = 0; i < count; ++i) {
    const float* from = b.base + size_t(i) * 4 * old;
    float* to = b.base + size_t(i) * 4 * slots;
    std::memmove(to, from, gone * 16);
    std::memmove(to + 4 * gone, from + 4 * (gone + 1), (old - 1 - gone) * 16);
  }
  std::memmove(b.value[gone], b.value[gone + 1], (old - 1 - gone) * 16);
  for (auto& place : b.place)
    if (place > gone) --place;
  b.place[slot] = 0;
  b.present &= ~(1u << slot);
  b.slots = slots;
  b.out = b.base + size_t(count) * 4 * slots;
}

void forget_run(Context& c) {
  VertexBuilder& b = c.builder;
  c.lists.vertices.reset();
  b.base = b.out = b.limit = nullptr;
  b.capacity = 0;
  b.mode = kNoPrimitive;
  b.slots = b.present = 1;
  std::memset(b.place, 0, sizeof b.place);
  b.primitives.clear();
}

/// Moves the builder's vertices into the list. `fragment`: they are not whole primitives.
void finish_run(Context& c, bool fragment) {
  VertexBuilder& b = c.builder;
  const uint32_t count = b.vertex_count();
  if (!fragment && count) {
    // An attribute that never changes is set once, before the run.
    for (uint32_t left = b.present & ~1u; left; left &= left - 1) {
      const int slot = __builtin_ctz(left);
      const unsigned place = b.place[slot];
      if (b.first_set[slot] || !is_uniform(b.base, count, b.slots, place)) continue;
      float value[4], last[4];
      std::memcpy(value, b.base + 4 * place, 16);
      std::memcpy(last, b.value[place], 16);
      remove_slot(b, slot);
      append_attribute(c, slot, value);
      if (std::memcmp(value, last, 16)) { // set once more behind the last vertex
        std::memcpy(b.deferred_value[slot], last, 16);
        b.deferred |= 1u << slot;
      }
    }
  }
  if (!count && !fragment) { // only attributes were set
    for (uint32_t left = b.present & ~1u; left; left &= left - 1) {
      const int slot = __builtin_ctz(left);
      if (b.deferred >> slot & 1) continue;
      std::memcpy(b.deferred_value[slot], b.value[b.place[slot]], 16);
      b.deferred |= 1u << slot;
    }
  } else {
    auto run = std::make_shared<VertexRun>();
    run->block = std::make_shared<VertexBlock>();
    run->present = b.present;
    run->slots = b.slots;
    run->vertex_count = count;
    run->fragment = fragment;
    std::memcpy(run->place, b.place, sizeof run->place);
    std::memcpy(run->final_value, b.value, b.slots * 16);
    for (uint32_t left = b.present & ~1u; left; left &= left - 1) {
      const int slot = __builtin_ctz(left);
      run->first_set[slot] = b.first_set[slot];
      if (b.first_set[slot]) run->late |= 1u << slot;
    }
    run->primitives = b.primitives;
    if (b.base) {
      float* fitted = static_cast<float*>(std::realloc(b.base, size_t(count) * b.slots * 16 + 16));
      run->block->vertices = fitted ? fitted : b.base;
      (void)c.lists.vertices.release();
      b.base = b.out = nullptr;
      describe_vertices(*run, run->block->vertices, run->block->source);
    }
    c.lists.list->runs.push_back(run);
    append_value(c, kPlayRun, c.lists.list->runs.size() - 1);
    if (execute_too(c)) {
      ExecuteScope scope(c);
      play_run(c, run);
    }
  }
  forget_run(c);
  c.guard &= ~(kRunPending | kInsideBeginEnd);
}

void finish_deferred(Context& c) {
  VertexBuilder& b = c.builder;
  const uint32_t slots = std::exchange(b.deferred, 0);
  for (uint32_t left = slots; left; left &= left - 1) {
    const int slot = __builtin_ctz(left);
    append_attribute(c, slot, b.deferred_value[slot]);
  }
}

} // namespace

void* record(Context& c, uint16_t opcode, size_t bytes) try {
  VertexBuilder& b = c.builder;
  c.lists.last_was_error = false;
  if (b.mode != kNoPrimitive) { // not allowed between Begin and End
    compile_error(c, GL_INVALID_OPERATION);
    c.lists.last_was_error = true;
    c.lists.scratch.resize((bytes + 7) / 8 + 1);
    return c.lists.scratch.data();
  }
  if (b.limit) close_loose_run(c, false);
  close_compiled_run(c);
  return append(c, opcode, bytes ? bytes : 8);
} catch (const std::bad_alloc&) {
  if (bytes > sizeof c.lists.emergency) throw;
  set_error(c, GL_OUT_OF_MEMORY);
  c.lists.last_was_error = true;
  return c.lists.emergency;
}

const void* keep(Context& c, const void* data, size_t bytes) {
  auto copy = std::make_unique<unsigned char[]>(bytes ? bytes : 1);
  if (bytes) std::memcpy(copy.get(), data, bytes);
  auto& payloads = c.lists.list->payloads;
  payloads.push_back(std::move(copy));
  return payloads.back().get();
}

bool execute_too(const Context& c) {
  return c.lists.list && c.lists.mode == GL_COMPILE_AND_EXECUTE && !c.lists.last_was_error;
}

ExecuteScope::ExecuteScope(Context& c) : context_(c), entered_(c.builder.compiling) {
  if (!entered_) return;
  std::swap(c.builder, c.lists.executing_builder);
  std::swap(c.guard, c.lists.executing_guard);
}
ExecuteScope::~ExecuteScope() {
  if (!entered_) return;
  Context& c = context_;
  if (c.guard & kRunPending) close_run(c); // Get asks State while the list's builder is in place
  std::swap(c.builder, c.lists.executing_builder);
  std::swap(c.guard, c.lists.executing_guard);
}

void compile_error(Context& c, GLenum code, bool allowed_inside) {
  append_value(c, kPlayError, uint64_t(allowed_inside) << 32 | code);
  if (c.lists.mode == GL_COMPILE_AND_EXECUTE)
    set_error(c,
              (c.lists.executing_guard & kInsideBeginEnd) && !allowed_inside ? GL_INVALID_OPERATION : code);
}

void close_compiled_run(Context& c) {
  c.lists.last_was_error = false;
  if (c.builder.base || c.builder.present != 1) finish_run(c, false);
  finish_deferred(c);
  c.guard &= ~kRunPending;
}

void close_loose_run(Context& c, bool with_end) {
  c.lists.last_was_error = false;
  if (c.builder.limit) {
    c.builder.primitives.push_back({kNoPrimitive, 0, c.builder.vertex_count(), false, false});
    finish_run(c, true);
  }
  finish_deferred(c);
  if (!with_end) return;
  append(c, kPlayEnd, 8);
  if (execute_too(c)) {
    ExecuteScope scope(c);
    gl::End(c);
  }
}

void break_compiled_run(Context& c) {
  VertexBuilder& b = c.builder;
  c.lists.last_was_error = false;
  if (b.mode != kNoPrimitive) {
    b.primitives.push_back({b.mode, b.first, b.vertex_count() - b.first, true, false});
    finish_run(c, true);
    finish_deferred(c);
  } else if (b.limit) {
    close_loose_run(c, false);
  } else {
    close_compiled_run(c);
  }
}

} // namespace softgl
