#include "commands/vertices/run_playback.h"
#include "commands/vertices/vertex_stream.h"
#include "snapshot/submit.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>

#include "base/bits.h"
#include "base/fast_paths.h"
#include "commands/vertices/attribute_doors.h"
#include "context/context.h"

namespace softgl {

void describe_vertices(const VertexRun& run, const float* vertices, VertexSource& source) {
  source.present = run.present;
  for (const int slot : Bits(run.present)) {
    source.stream[slot] = AttributeStream{
        reinterpret_cast<const unsigned char*>(vertices + 4 * run.offset[slot]), 16 * run.slots};
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
      const float* vertex = vertices + size_t(run.indices.empty() ? i : run.indices[i]) * 4 * run.slots;
      for (const int slot : Bits(run.present & ~1u))
        if (i >= run.first_set[slot]) set(slot, vertex + 4 * run.offset[slot]);
      emit_vertex4(c, vertex[0], vertex[1], vertex[2], vertex[3]);
    }
    if (range.ends) gl::End(c);
  }
  for (const int slot : Bits(run.present & ~1u)) set(slot, run.final_value[run.offset[slot]]);
}

/// The vertices with the present current values where the list sets none.
const std::shared_ptr<VertexBlock>& fill_late_values(Context& c, VertexRun& run) {
  bool same = run.late_block != nullptr;
  for (const int slot : Bits(run.late)) {
    const float* now = &c.state.current.slot[slot].x;
    if (!same_bits(run.late_value[slot], now, 16)) {
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
  for (const int slot : Bits(run.late)) {
    float* to = block->vertices + 4 * run.offset[slot];
    const uint32_t end = std::min(run.first_set[slot], run.vertex_count);
    for (uint32_t i = 0; i < end; ++i) std::memcpy(to + i * stride, run.late_value[slot], 16);
  }
  describe_vertices(run, block->vertices, block->source);
  return run.late_block = std::move(block);
}

/// Joins vertices that are the same bit by bit. Triangles given one by one share most of theirs: six times
/// fewer are shaded at each playing, for some 20 ns a vertex once.
void join_equal_vertices(VertexRun& run) {
  const uint32_t count = run.vertex_count;
  const size_t words = 2 * size_t(run.slots);  // of 8 bytes
  std::vector<uint32_t> indices(count), first; // first: where each distinct vertex was seen first
  size_t size = 64;
  while (size < 2 * size_t(count)) size *= 2;
  std::vector<uint32_t> table(size, 0); // number of the distinct vertex + 1
  const float* vertices = run.block->vertices;
  const uint32_t most = count - count / 4;
  for (uint32_t i = 0; i < count; ++i) {
    const float* vertex = vertices + size_t(i) * 2 * words;
    uint64_t hash = 0;
    for (size_t w = 0; w < words; ++w) {
      uint64_t v;
      std::memcpy(&v, vertex + 2 * w, sizeof v);
      hash = (hash ^ v) * 0x9e3779b97f4a7c15ull;
      hash ^= hash >> 32;
    }
    size_t at = hash & (size - 1);
    while (table[at] && !same_bits(vertices + size_t(first[table[at] - 1]) * 2 * words, vertex, words * 8))
      at = (at + 1) & (size - 1);
    if (!table[at]) {
      first.push_back(i);
      if (first.size() > most) return; // too few are alike
      table[at] = uint32_t(first.size());
    }
    indices[i] = table[at] - 1;
  }
  auto block = std::make_shared<VertexBlock>();
  block->vertices = static_cast<float*>(std::malloc(first.size() * words * 8 + 16));
  if (!block->vertices) throw std::bad_alloc();
  for (size_t i = 0; i < first.size(); ++i)
    std::memcpy(block->vertices + i * 2 * words, vertices + size_t(first[i]) * 2 * words, words * 8);
  describe_vertices(run, block->vertices, block->source);
  run.block = std::move(block);
  run.indices = std::move(indices);
  run.distinct_count = uint32_t(first.size());
}

constexpr uint32_t kFewVertices = 64; // not worth joining

void draw_run(Context& c, const std::shared_ptr<VertexRun>& pointer) {
  VertexRun& run = *pointer;
  DrawCall call;
  call.vertex_count = run.vertex_count;
  std::unique_lock lock(run.mutex);
  if (++run.plays == 2 && !run.late && run.vertex_count >= kFewVertices && takes(FastPath::JoinedVertices)) {
    try {
      join_equal_vertices(run);
    } catch (const std::bad_alloc&) {} // they stay apart
  }
  const std::shared_ptr<VertexBlock> block = run.late ? fill_late_values(c, run) : run.block;
  if (!run.indices.empty()) {
    call.indices = run.indices.data();
    call.vertex_count = run.distinct_count;
  }
  lock.unlock();
  c.frame.retain(pointer, 0);
  c.frame.retain(block, size_t(run.vertex_count) * run.slots * 16);
  call.source = &block->source;
  call.constant = current_constants(c);
  call.primitives = run.primitives.data();
  call.primitive_count = uint32_t(run.primitives.size());
  call.from_list = true;
  submit(c, call);
}

} // namespace

void play_run(Context& c, const std::shared_ptr<VertexRun>& run) {
  if (run->of_arrays && c.guard & kInsideBeginEnd) return; // a record before it raises the error
  if (run->partial || c.guard & kInsideBeginEnd) return replay_calls(c, *run);
  if (c.guard & kRunPending) close_run(c);
  if (!run->primitives.empty()) {
    try {
      draw_run(c, run);
    } catch (const std::bad_alloc&) { set_error(c, GL_OUT_OF_MEMORY); }
  }
  if (run->of_arrays) return;
  for (const int slot : Bits(run->present & ~1u)) set_current(c, slot, run->final_value[run->offset[slot]]);
}

} // namespace softgl
