// Seconds that have passed, of a clock that is never set.
#pragma once

#include <chrono>

namespace softgl::cli {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace softgl::cli
