#include "vertex/vertex_run.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>

#include "state/context.h"
#include "vertex/attribute_doors.h"

namespace softgl {

VertexBlock::~VertexBlock() { std::free(vertices); }

void describe_vertices(const VertexRun& run, const float* vertices, VertexSource& source) {
  source.present = run.present;
  for (uint32_t left = run.present; left; left &= left - 1) {
    const int slot = __builtin_ctz(left);
    source.stream[slot] =
        AttributeStream{reinterpret_cast<const unsigned char*>(vertices + 4 * run.place[slot]), 16 * run.slots};
  }
}

namespace {

/// Call by call, as the application gave them: inside a primitive that another list has begun, for example.
void replay_calls(Context& c, const VertexRun& run) {
  const float* vertices = run.block->vertices;
  const auto set = [&](int slot, const float* v) { set_attribute4(c, slot, v[0], v[1], v[2], v[3]); };
  for (const PrimitiveRange& range : run.primitives) {
    if (range.begins) gl::Begin(c, range.mode);
    for (uint32_t i = range.first; i < range.first + range.count; ++i) {
      const float* vertex = vertices + size_t(i) * 4 * run.slots;
      for (uint32_t left = run.present & ~1u; left; left &= left - 1) {
        const int slot = __builtin_ctz(left);
        if (i >= run.first_set[slot]) set(slot, vertex + 4 * run.place[slot]);
      }
      emit_vertex4(c, vertex[0], vertex[1], vertex[2], vertex[3]);
    }
    if (range.ends) gl::End(c);
  }
  for (uint32_t left = run.present & ~1u; left; left &= left - 1) {
    const int slot = __builtin_ctz(left);
    set(slot, run.final_value[run.place[slot]]);
  }
}

/// The vertices with the present current values where the list sets none.
const std::shared_ptr<VertexBlock>& fill_late_values(Context& c, VertexRun& run) {
  bool same = run.late_block != nullptr;
  for (uint32_t left = run.late; left; left &= left - 1) {
    const int slot = __builtin_ctz(left);
    const float* now = &c.state.current.slot[slot].x;
    if (std::memcmp(run.late_value[slot], now, 16)) {
      same = false;
      std::memcpy(run.late_value[slot], now, 16);
    }
  }
  if (same) return run.late_block;
  auto block = std::make_shared<VertexBlock>();
  const size_t stride = 4 * run.slots, bytes = run.vertex_count * stride * sizeof(float);
  block->vertices = static_cast<float*>(std::malloc(bytes + 16));
  if (!block->vertices) throw std::bad_alloc();
  std::memcpy(block->vertices, run.block->vertices, bytes);
  for (uint32_t left = run.late; left; left &= left - 1) {
    const int slot = __builtin_ctz(left);
    float* to = block->vertices + 4 * run.place[slot];
    const uint32_t end = std::min(run.first_set[slot], run.vertex_count);
    for (uint32_t i = 0; i < end; ++i) std::memcpy(to + i * stride, run.late_value[slot], 16);
  }
  describe_vertices(run, block->vertices, block->source);
  return run.late_block = std::move(block);
}

} // namespace

void play_run(Context& c, const std::shared_ptr<VertexRun>& pointer) {
  VertexRun& run = *pointer;
  if (run.fragment || c.guard & kInsideBeginEnd) return replay_calls(c, run);
  if (c.guard & kRunPending) c.builder.close_run(c);
  if (!run.primitives.empty()) {
    const std::shared_ptr<VertexBlock>& block = run.late ? fill_late_values(c, run) : run.block;
    c.frame.retain(pointer);
    c.frame.retain(block);
    DrawCall call;
    call.source = &block->source;
    call.constant = current_constants(c);
    call.primitives = run.primitives.data();
    call.primitive_count = uint32_t(run.primitives.size());
    call.vertex_count = run.vertex_count;
    submit(c, call);
  }
  for (uint32_t left = run.present & ~1u; left; left &= left - 1) {
    const int slot = __builtin_ctz(left);
    set_current(c, slot, run.final_value[run.place[slot]]);
  }
}

} // namespace softgl
