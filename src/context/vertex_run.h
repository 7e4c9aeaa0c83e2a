// Finished vertices of a display list, ready to be drawn again and again without touching each one.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <vector>

#include "draw/draw_call.h"

namespace softgl {

/// Vertices in the builder's layout and the streams that point to them. Unchanged once a frame may have seen
/// it.
struct VertexBlock {
  float* vertices = nullptr; // from malloc
  VertexSource source;
  VertexBlock() = default;
  VertexBlock(const VertexBlock&) = delete;
  VertexBlock& operator=(const VertexBlock&) = delete;
  ~VertexBlock() { std::free(vertices); }
};

struct VertexRun {
  uint32_t present = 1, slots = 1, vertex_count = 0;
  uint8_t offset[kAttributeSlots] = {}; // of attributes in a vertex, in slots
  std::shared_ptr<VertexBlock> block;
  std::vector<PrimitiveRange> primitives;

  /// Vertices before first_set[s] were given before attribute s was: they take the value current at play
  /// time.
  uint32_t first_set[kAttributeSlots] = {};
  uint32_t late = 0;                       // bit s: first_set[s] > 0
  std::shared_ptr<VertexBlock> late_block; // the block with such values filled in, from the last time
  alignas(16) float late_value[kAttributeSlots][4] = {};

  alignas(16) float final_value[kAttributeSlots][4] = {}; // by offset: current after the run

  /// Not a sequence of whole primitives: some vertices belong to a primitive that begins or ends outside of
  /// the run.
  bool partial = false;
  bool of_arrays = false; // array draws: not between Begin and End, and the current values stay (2.8)

  /// Made at the second playing, when it pays: vertices that are alike are joined, and these name them.
  uint32_t plays = 0;
  std::vector<uint32_t> indices;
  uint32_t distinct_count = 0;

  std::mutex mutex; // contexts of several threads may play one list
};

} // namespace softgl
