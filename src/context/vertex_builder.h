// The one path of vertices: what stands between Begin and End is written into a run of 16-byte slots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "context/state.h"
#include "draw/draw_call.h"

namespace softgl {

/// No primitive is open; as the mode of an open primitive in a list: vertices whose Begin is in no known
/// list.
constexpr GLenum kNoPrimitive = 0xffff;

struct FreeVertices {
  void operator()(float* p) const { std::free(p); }
};

/// A run that holds array draws of a list only. Between two of them its slots are hidden, so that an
/// attribute or a primitive of another kind is noticed, and ends the run.
enum class ArrayRun : uint8_t { No, Open, Hidden };

/// Collects vertices until the run closes: on a state change, when the chunk is full, on an array draw.
///
/// A vertex is `slots` 16-byte slots: the position, then each attribute that was set since the run began, in
/// the order of their first setting. Setting an attribute writes its slot in `value`; a vertex copies `value`
/// behind its position (measured: 2.5-3.0 ns for a normal and a vertex, against 4-6 ns for packed or separate
/// arrays).
struct VertexBuilder {
  // Touched by every call.
  float* out = nullptr;                     // the next vertex
  float* limit = nullptr;                   // a vertex fits while out < limit; null when no primitive is open
  uint32_t slots = 1;                       // per vertex
  uint32_t present = 1;                     // bit s: attribute s has a slot (the position always has)
  uint8_t offset[kAttributeSlots + 6] = {}; // of attribute s in a vertex, in slots; 0: absent
  alignas(16) float value[kAttributeSlots][4] = {};

  // Touched by Begin and End.
  GLenum mode = kNoPrimitive;                  // of the open primitive
  uint32_t first = 0;                          // its first vertex
  bool continued = false;                      // its beginning was in an earlier chunk
  bool compiling = false;                      // vertices go to a display list
  bool dropping = false;                       // memory has ended: vertices are not kept until the next Begin
  float* base = nullptr;                       // vertex 0 of the chunk; null: no chunk is open
  size_t capacity = 0;                         // bytes
  std::unique_ptr<float, FreeVertices> memory; // the chunk of a list; others lie in the frame's arena
  std::vector<PrimitiveRange> primitives;

  // Attributes without a slot that were set outside Begin and End while vertices wait: they get a slot at the
  // next Begin, or become current when the run closes.
  uint32_t deferred = 0;
  alignas(16) float deferred_value[kAttributeSlots][4] = {};

  // Compiling only: the first vertex that has its own value; earlier ones take the value current at play
  // time.
  uint32_t first_set[kAttributeSlots] = {};
  // Compiling only: attributes that a record before the run sets, and those first set between Begin and End.
  uint32_t recorded = 0, set_inside = 0;
  alignas(16) float recorded_value[kAttributeSlots][4] = {};
  ArrayRun array_run = ArrayRun::No;
  uint8_t hidden_offset[kAttributeSlots + 6] = {}; // `offset` while the slots are hidden

  const Vec4* constants = nullptr; // State::current as last written to the arena (see current_constants)

  uint32_t vertex_count() const { return base ? uint32_t((out - base) / (4 * ptrdiff_t(slots))) : 0; }
  bool inside() const { return mode != kNoPrimitive || limit; }
};

} // namespace softgl
