#include "common/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace softgl::cli {

void parallel_for(size_t count, unsigned threads, const std::function<void(size_t, unsigned)>& work) {
  std::atomic<size_t> next{0}, end{count};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto run = [&](unsigned worker) {
    for (size_t i = next++; i < end; i = next++) {
      try {
        work(i, worker);
      } catch (...) {
        const std::scoped_lock lock(mutex);
        if (failure && i > end) continue;
        failure = std::current_exception();
        end = i;
      }
    }
  };
  std::vector<std::thread> others;
  try {
    for (unsigned i = 1; i < std::min<size_t>(threads, count); ++i) others.emplace_back(run, i);
  } catch (const std::system_error&) { // fewer threads do the same work
  }
  run(0);
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

} // namespace softgl::cli
