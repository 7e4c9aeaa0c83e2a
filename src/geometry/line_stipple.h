// Cuts lines by the stipple pattern (GL 1.5, 3.4.2).
#pragma once

#include "base/arena.h"
#include "draw/draw_record.h"
#include "shaders/common/shaded_vertex.h"

namespace softgl {

/// Walks along the lines of a draw. OSMesa counts along the greater of |dx|, |dy| after clipping, along the
/// line itself where it is antialiased (3.4.4), whole steps either way, and interpolates every attribute
/// linearly in window space.
class LineStipple {
public:
  using Slot = ShadedVertices::Slot;
  LineStipple(const DrawRecord& draw, Arena& arena);
  void reset() { counter_ = 0; }
  /// Only counts, for the lines in front of a chunk.
  void skip(const Slot* const end[2]);
  /// Calls emit(const Slot*, const Slot*) for each dash.
  template <class Emit> void cut(const Slot* const end[2], Emit&& emit) {
    const float length = length_of(end);
    const uint32_t steps = steps_of(length);
    float start = 0;
    bool on = false;
    for (uint32_t i = 0; i < steps; ++i) {
      const bool set = pattern_ >> ((counter_ + i) / factor_ & 15) & 1;
      if (set == on) continue;
      if (on)
        emit(start > 0 ? between(start / length, end) : end[0], between(float(i) / length, end));
      else
        start = float(i);
      on = set;
    }
    if (on && start < length) emit(start > 0 ? between(start / length, end) : end[0], end[1]);
    counter_ += steps;
  }

private:
  float length_of(const Slot* const end[2]) const;
  uint32_t steps_of(float length) const;
  const Slot* between(float t, const Slot* const end[2]);

  const DrawRecord& draw_;
  Arena& arena_;
  const bool smooth_;
  uint32_t counter_ = 0, pattern_, factor_;
};

} // namespace softgl
