#include "commands/vertices/list_compilation.h"

#include <cstring>
#include <new>
#include <utility>

#include "base/bits.h"
#include "commands/vertices/attribute_doors.h"
#include "commands/vertices/run_playback.h"
#include "commands/vertices/vertex_chunk.h"
#include "commands/vertices/vertex_stream.h"
#include "context/display_list.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {
namespace {

/// Where the arguments of a command go that is not kept.
void* unkept_arguments(Context& c, size_t bytes) {
  if (bytes > sizeof c.lists.unkept) throw std::bad_alloc();
  return c.lists.unkept;
}

void* append(Context& c, uint16_t opcode, size_t bytes) {
  const size_t units = 1 + (bytes + 7) / 8;
  auto& records = c.lists.list->records;
  const size_t at = records.size();
  or_drop_vertices(c, [&] {
    if (!c.lists.failed) records.resize(at + units);
  });
  if (c.lists.failed) return unkept_arguments(c, bytes);
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

/// True if all vertices have the same value of the attribute at `offset`.
bool is_uniform(const float* vertices, uint32_t count, uint32_t slots, unsigned offset) {
  for (uint32_t i = 1; i < count; ++i)
    if (!same_bits(vertices + 4 * offset, vertices + size_t(i) * 4 * slots + 4 * offset, 16)) return false;
  return true;
}

/// The attribute gets that value behind the last vertex.
void defer(VertexBuilder& b, int slot, const float* value) {
  std::memcpy(b.deferred_value[slot], value, 16);
  b.deferred |= 1u << slot;
}

// What is interpolated where vertices set it, and goes to the fragments as it is where they do not.
constexpr uint32_t kInterpolated = 1u << kColor | 0xffu << kTexCoord0;

/// An attribute that never changes is set once, before the run, and not by its vertices. Not where that would
/// change last bits of what was given between Begin and End.
void record_uniform_attributes(Context& c) {
  VertexBuilder& b = c.builder;
  const uint32_t count = b.vertex_count();
  for (const int slot : Bits(b.present & ~1u)) {
    const unsigned offset = b.offset[slot];
    if (b.first_set[slot] || (b.set_inside & kInterpolated) >> slot & 1) continue;
    if (!is_uniform(b.base, count, b.slots, offset)) continue;
    float value[4], last[4];
    std::memcpy(value, b.base + 4 * offset, 16);
    std::memcpy(last, b.value[offset], 16);
    remove_slot(b, slot);
    append_attribute(c, slot, value);
    if (!b.base) return; // memory has ended
    if (!same_bits(value, last, 16)) defer(b, slot, last);
  }
}

/// Takes the vertices that wait out of the builder.
std::shared_ptr<VertexRun> take_run(VertexBuilder& b, bool partial) {
  auto run = std::make_shared<VertexRun>();
  run->block = std::make_shared<VertexBlock>();
  run->present = b.present;
  run->slots = b.slots;
  run->vertex_count = b.vertex_count();
  run->partial = partial;
  run->of_arrays = b.array_run != ArrayRun::No;
  std::memcpy(run->offset, b.offset, sizeof run->offset);
  std::memcpy(run->final_value, b.value, b.slots * 16);
  for (const int slot : Bits(b.present & ~1u)) {
    run->first_set[slot] = b.first_set[slot];
    if (b.first_set[slot]) run->late |= 1u << slot;
  }
  run->primitives = b.primitives;
  if (float* vertices = b.memory.release()) {
    auto* fitted = static_cast<float*>(std::realloc(vertices, size_t(run->vertex_count) * b.slots * 16 + 16));
    run->block->vertices = fitted ? fitted : vertices;
    describe_vertices(*run, run->block->vertices, run->block->source);
  }
  forget_vertices(b);
  return run;
}

void show_slots(VertexBuilder& b) {
  std::memcpy(b.offset, b.hidden_offset, sizeof b.offset);
  b.array_run = ArrayRun::Open;
}

/// Moves the builder's vertices into the list. `partial`: they are not whole primitives.
void keep_vertices(Context& c, bool partial) {
  VertexBuilder& b = c.builder;
  const bool of_arrays = b.array_run != ArrayRun::No;
  if (!partial && !of_arrays && b.vertex_count()) record_uniform_attributes(c);
  if (partial || b.vertex_count()) {
    const std::shared_ptr<VertexRun> run = take_run(b, partial);
    auto& runs = c.lists.list->runs;
    runs.push_back(run);
    append_value(c, kPlayRun, runs.size() - 1);
    if (execute_too(c)) {
      ExecuteScope scope(c);
      play_run(c, run);
    }
  } else if (!of_arrays) { // only attributes were set
    for (const int slot : Bits(b.present & ~1u & ~b.deferred)) defer(b, slot, b.value[b.offset[slot]]);
  }
}

} // namespace

void* record(Context& c, uint16_t opcode, size_t bytes) {
  close_compiled_run(c); // what stands between Begin and End is refused when it is played, if Begin was not
  return append(c, opcode, bytes ? bytes : 8);
}

const void* keep(Context& c, const void* data, size_t bytes) {
  const unsigned char* kept = nullptr;
  or_drop_vertices(c, [&] {
    if (c.lists.failed) return;
    std::unique_ptr<unsigned char[]> copy(new unsigned char[bytes ? bytes : 1]);
    if (bytes) std::memcpy(copy.get(), data, bytes);
    kept = c.lists.list->payloads.emplace_back(std::move(copy)).get();
  });
  return kept ? kept : data;
}

bool execute_too(const Context& c) {
  if (SOFTGL_FAULT(list_only_compiles)) return false;
  return c.lists.list && (c.lists.mode == GL_COMPILE_AND_EXECUTE || SOFTGL_FAULT(list_executes_at_once));
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

void compile_error(Context& c, const Refusal& refusal, bool allowed_inside) {
  if (c.builder.inside()) close_compiled_run(c);
  append_value(c, kPlayError, uint64_t(allowed_inside) << 32 | refusal.error);
  if (c.lists.mode != GL_COMPILE_AND_EXECUTE) return;
  const bool misplaced = (c.lists.executing_guard & kInsideBeginEnd) && !allowed_inside;
  set_error(c, misplaced ? Refusal{GL_INVALID_OPERATION} : refusal);
}

void raise_error(Context& c, const Refusal& refusal, bool allowed_inside) {
  if (c.builder.compiling)
    compile_error(c, refusal, allowed_inside);
  else
    set_error(c, refusal);
}

void close_compiled_run(Context& c) {
  VertexBuilder& b = c.builder;
  if (b.array_run == ArrayRun::Hidden) show_slots(b);
  const bool partial = b.inside();
  if (partial || b.base || b.present != 1)
    or_drop_vertices(c, [&] {
      if (b.mode != kNoPrimitive)
        b.primitives.push_back({b.mode, b.first, b.vertex_count() - b.first, true, false});
      else if (partial)
        b.primitives.push_back({kNoPrimitive, 0, b.vertex_count(), false, false});
      if (!c.lists.failed) keep_vertices(c, partial);
    });
  forget_vertices(b);
  forget_layout(b);
  b.array_run = ArrayRun::No;
  b.mode = kNoPrimitive;
  b.limit = nullptr;
  c.guard &= ~(kRunPending | kInsideBeginEnd);
  for (const int slot : Bits(std::exchange(b.deferred, 0))) append_attribute(c, slot, b.deferred_value[slot]);
}

void record_attribute(Context& c, int slot, const float* value) {
  VertexBuilder& b = c.builder;
  std::memcpy(b.recorded_value[slot], value, 16);
  b.recorded |= 1u << slot;
  append_attribute(c, slot, value);
}

void open_array_run(Context& c) {
  VertexBuilder& b = c.builder;
  if (b.array_run == ArrayRun::Hidden) return show_slots(b);
  close_compiled_run(c);
  b.array_run = ArrayRun::Open;
}

void hide_array_run(Context& c) {
  VertexBuilder& b = c.builder;
  std::memcpy(b.hidden_offset, b.offset, sizeof b.offset);
  std::memset(b.offset, 0, sizeof b.offset);
  b.array_run = ArrayRun::Hidden;
}

void compile_end(Context& c) {
  close_compiled_run(c);
  append(c, kPlayEnd, 8);
  if (execute_too(c)) {
    ExecuteScope scope(c);
    gl::End(c);
  }
}

} // namespace softgl
