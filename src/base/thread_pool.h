// The process's worker threads: run(count, fn) and nothing else.
#pragma once

#include <cstddef>
#include <vector>

#include "base/pages.h"

namespace softgl {

class ThreadPool {
public:
  /// The one pool. Its threads start with the first run() that can use them; it is never destroyed, so
  /// neither exit nor unloading has to wait for a thread, and a forked child starts with a new pool of its
  /// own.
  static ThreadPool& instance();

  /// How many workers run() uses, the calling thread included: SOFTGL_THREADS, or else the processors that
  /// the process may run on. At least 1.
  int workers() const;
  /// Sets that number; 0 and 1 mean: all work is done by the calling thread.
  void set_workers(int count);

  /// Starts the threads, and has one of them bring in memory that will soon be written (populate_pages) while
  /// the caller goes on, until a run begins. The memory may be gone by then. Does nothing where there is one
  /// worker.
  void prepare(const std::vector<Pages>& pages);

  /// Calls fn(i, worker) once for every i in [0, count), each worker (0 <= worker < workers()) on a thread of
  /// its own, and returns when all calls have returned. Workers begin with neighbouring indices. The first
  /// exception that a call throws is thrown again here; calls not yet begun are then left out. While another
  /// thread's run() is under way all calls are made by the calling thread.
  template <class Function> void run(size_t count, Function&& fn) {
    auto call = [](void* object, size_t index, int worker) {
      (*static_cast<Function*>(object))(index, worker);
    };
    run_erased(count, call, const_cast<void*>(static_cast<const void*>(&fn)));
  }

private:
  using Call = void (*)(void* object, size_t index, int worker);
  ThreadPool();
  void run_erased(size_t count, Call call, void* object);
  struct State;
  State* state_;
};

constexpr int kMaxWorkers = 256;

} // namespace softgl
