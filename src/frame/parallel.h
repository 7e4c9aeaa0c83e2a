// Work of other rooms that all threads share.
#pragma once

#include "base/thread_pool.h"

namespace softgl {

/// Calls fn(i) once for every i in [0, count), from all threads, and returns when all calls have returned.
template <class Function> void in_parallel(size_t count, Function&& fn) {
  ThreadPool::instance().run(count, [&](size_t i, int) { fn(i); });
}

/// How many threads draw, the calling one included.
inline int drawing_threads() { return ThreadPool::instance().workers(); }
inline void set_drawing_threads(int count) { ThreadPool::instance().set_workers(count); }

/// Has a thread bring in memory that will soon be written (ThreadPool::prepare).
inline void bring_in(const std::vector<Pages>& pages) { ThreadPool::instance().prepare(pages); }

} // namespace softgl
