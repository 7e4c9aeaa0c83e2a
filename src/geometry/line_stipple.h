// Cuts lines by the stipple pattern (GL 1.5, 3.4.2).
#pragma once

#include "base/arena.h"
#include "draw/draw_record.h"
#include "shaders/common/shaded_vertex.h"

namespace softgl {

/// Walks along the lines of a draw. OSMesa counts along the greater of |dx|, |dy| after clipping, along the
/// line itself where it is antialiased (3.4.4), and interpolates every attribute linearly in window space.
class LineStipple {
public:
  using Slot = ShadedVertices::Slot;
  LineStipple(const DrawRecord& draw, Arena& arena);
  void reset() { counter_ = 0, distance_ = 0; }
  /// Only counts, for the lines in front of a chunk.
  void skip(const Slot* const end[2]);
  /// Calls emit(const Slot*, const Slot*) for each dash.
  template <class Emit> void cut(const Slot* const end[2], Emit&& emit) {
    const float length = length_of(end);
    const uint32_t steps = steps_of(length), first = smooth_ ? uint32_t(distance_) : counter_;
    float start = 0;
    bool on = false;
    for (uint32_t i = 0; i < steps; ++i) {
      const bool set = pattern_ >> ((first + i) / factor_ & 15) & 1;
      if (set == on) continue;
      if (on)
        emit(start > 0 ? between(start / length, end) : end[0], between(float(i) / length, end));
      else
        start = float(i);
      on = set;
    }
    if (on && start < length) emit(start > 0 ? between(start / length, end) : end[0], end[1]);
    advance(length, steps);
  }

private:
  float length_of(const Slot* const end[2]) const;
  uint32_t steps_of(float length) const;
  void advance(float length, uint32_t steps) {
    counter_ += steps;
    if (steps) distance_ += length;
  }
  const Slot* between(float t, const Slot* const end[2]);

  const DrawRecord& draw_;
  Arena& arena_;
  const bool smooth_;
  uint32_t counter_ = 0, pattern_, factor_;
  float distance_ = 0; // the counter of antialiased lines
};

} // namespace softgl
