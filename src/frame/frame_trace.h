// Draws and flushes in the trace (SOFTGL_TRACE).
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/trace_file.h"
#include "frame/frame.h"

namespace softgl {

/// One line: how much is drawn, from which attributes, and what the vertex program and the fragment key do.
[[gnu::cold]] void trace_draw(const DrawRecord& draw);

/// What a flush did and how long it took, one line when it is over.
class FlushTrace {
public:
  FlushTrace(std::span<const Frame::Item> items, uint32_t framebuffer);
  void end(size_t arena_bytes, int rounds, int workers) const;

private:
  size_t draws_ = 0, clears_ = 0;
  uint64_t primitives_ = 0;
  uint32_t framebuffer_; // name of the framebuffer object that is drawn to; 0: the window
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

} // namespace softgl
