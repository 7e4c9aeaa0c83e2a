#include "base/thread_pool.h"

#include <dlfcn.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <thread>
#include <utility>

#include "base/float_environment.h"

namespace softgl {

namespace {

int default_workers() {
  if (const char* text = std::getenv("SOFTGL_THREADS")) {
    char* end = nullptr;
    const long n = std::strtol(text, &end, 10);
    if (end != text && n >= 0) return static_cast<int>(std::clamp(n, 1L, long(kMaxWorkers)));
  }
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0) return std::clamp(CPU_COUNT(&set), 1, kMaxWorkers);
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMaxWorkers);
}

/// A thread that runs code of this library must not see it unmapped by dlclose.
void stay_loaded() {
  Dl_info info;
  if (dladdr(reinterpret_cast<void*>(&stay_loaded), &info) && info.dli_fname)
    dlopen(info.dli_fname, RTLD_NOW | RTLD_NOLOAD | RTLD_NODELETE);
}

} // namespace

struct ThreadPool::State {
  std::mutex owner; // held by the thread whose run() is under way
  std::mutex mutex;
  std::condition_variable wake, done;
  std::atomic<int> workers{default_workers()};
  std::vector<pthread_t> threads; // besides the caller; guarded by owner
  int caller_processor = -1;      // where no thread runs; guarded by owner
  cpu_set_t elsewhere{};          // where they may; empty: anywhere

  // The run under way; written under mutex. Workers join while it is open; one that wakes too late is not
  // waited for.
  std::atomic<uint64_t> generation{0};
  bool open = false;
  int wanted = 0;             // workers of this run, the caller included
  std::atomic<int> active{0}; // threads that have joined and not finished
  Call call = nullptr;
  void* object = nullptr;
  /// Indices that nobody has taken yet: the first one in the lower half, the one behind the last in the upper
  /// half.
  struct alignas(64) Share {
    std::atomic<uint64_t> rest{0};
  };
  Share share[kMaxWorkers];
  std::exception_ptr failure;
  std::vector<Pages> pages; // to be brought in; guarded by mutex

  static constexpr uint64_t kNone = ~uint64_t(0);
  static uint64_t range(uint64_t first, uint64_t end) { return end << 32 | first; }

  /// An index of a share: its first for the owner, its last for others. kNone when nothing is left.
  uint64_t take(int owner, bool last) {
    std::atomic<uint64_t>& rest = share[owner].rest;
    uint64_t r = rest.load(std::memory_order_relaxed);
    for (;;) {
      const uint64_t first = r & 0xffffffff, end = r >> 32;
      if (first >= end) return kNone;
      if (rest.compare_exchange_weak(r, last ? range(first, end - 1) : range(first + 1, end),
                                     std::memory_order_relaxed))
        return last ? end - 1 : first;
    }
  }

  /// Its own share, then what others have left.
  void work(int worker) {
    for (int i = 0; i < wanted;) {
      const uint64_t index = take((worker + i) % wanted, i != 0);
      if (index == kNone) {
        ++i;
        continue;
      }
      try {
        call(object, static_cast<size_t>(index), worker);
      } catch (...) {
        std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        for (int k = 0; k < wanted; ++k) share[k].rest.store(0, std::memory_order_relaxed);
      }
    }
  }

  [[noreturn]] void serve(int worker) {
    _mm_setcsr(kPixelFloatEnvironment);
    uint64_t seen = 0;
    for (;;) {
      // The phases of a frame follow each other closely, so look a while before going to sleep.
      for (int i = 0; i < 2000 && generation.load(std::memory_order_acquire) == seen; ++i) _mm_pause();
      {
        std::unique_lock lock(mutex);
        wake.wait(lock, [&] { return generation.load(std::memory_order_relaxed) != seen || !pages.empty(); });
        if (!pages.empty()) { // memory that is used before it has been brought in brings itself in, so a run
                              // comes first
          const std::vector<Pages> taken = std::exchange(pages, {});
          lock.unlock();
          for (const Pages& p : taken) {
            for (size_t done = 0; done < p.bytes && generation.load(std::memory_order_relaxed) == seen;
                 done += kHugePage)
              populate_pages(
                  {static_cast<unsigned char*>(p.memory) + done, std::min(kHugePage, p.bytes - done)});
          }
          continue;
        }
        seen = generation.load(std::memory_order_relaxed);
        if (!open || worker >= wanted) continue;
        active.fetch_add(1, std::memory_order_relaxed);
      }
      work(worker);
      std::lock_guard lock(mutex);
      if (active.fetch_sub(1, std::memory_order_release) == 1) done.notify_one();
    }
  }

  /// Keeps the threads off the processor that the caller is on. Left alone, Linux starts a thread there, next
  /// to idle ones, and moves it when its balancer comes by: of a first frame of 16 ms that was 2 to 4.
  void leave_callers_processor() {
    const int processor = sched_getcpu();
    if (processor == caller_processor) return;
    caller_processor = processor;
    if (processor < 0 || processor >= CPU_SETSIZE || sched_getaffinity(0, sizeof elsewhere, &elsewhere) != 0)
      CPU_ZERO(&elsewhere);
    else
      CPU_CLR(processor, &elsewhere);
    if (CPU_COUNT(&elsewhere) == 0) return;
    for (pthread_t thread : threads) pthread_setaffinity_np(thread, sizeof elsewhere, &elsewhere);
  }

  struct Begin {
    State* state;
    int worker;
  };

  /// `placed`: elsewhere from its first instruction on.
  bool start_thread(bool placed) {
    threads.reserve(threads.size() + 1);
    auto begin = std::make_unique<Begin>(Begin{this, static_cast<int>(threads.size()) + 1});
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0) return false;
    pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
    if (placed) pthread_attr_setaffinity_np(&attributes, sizeof elsewhere, &elsewhere);
    auto main = [](void* argument) -> void* {
      const std::unique_ptr<Begin> b(static_cast<Begin*>(argument));
      b->state->serve(b->worker);
    };
    pthread_t thread;
    const bool started = pthread_create(&thread, &attributes, main, begin.get()) == 0;
    pthread_attr_destroy(&attributes);
    if (!started) return false;
    (void)begin.release(); // the thread has it now
    threads.push_back(thread);
    return true;
  }

  /// Starts threads until there are `wanted_threads`; fewer when the system gives no more.
  int start(int wanted_threads) {
    leave_callers_processor();
    if (static_cast<int>(threads.size()) >= wanted_threads) return wanted_threads;
    if (threads.empty()) stay_loaded();
    sigset_t all, old;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &old); // signals are the application's business
    try {
      // A sandbox may forbid to choose processors.
      while (static_cast<int>(threads.size()) < wanted_threads &&
             ((CPU_COUNT(&elsewhere) > 0 && start_thread(true)) || start_thread(false))) {}
    } catch (const std::bad_alloc&) {}
    pthread_sigmask(SIG_SETMASK, &old, nullptr);
    return std::min(static_cast<int>(threads.size()), wanted_threads);
  }
};

namespace {
alignas(ThreadPool) unsigned char pool_storage[sizeof(ThreadPool)];
} // namespace

ThreadPool::ThreadPool() : state_(new State) {
  static ThreadPool* self;
  self = this;
  // The child of a fork has only the forking thread and locks in any state: it gets new ones.
  pthread_atfork(nullptr, nullptr, [] {
    const int workers = self->workers();
    self->state_ = new State;
    self->set_workers(workers);
  });
}

ThreadPool& ThreadPool::instance() {
  static ThreadPool* pool = new (pool_storage) ThreadPool;
  return *pool;
}

int ThreadPool::workers() const { return state_->workers.load(std::memory_order_relaxed); }
void ThreadPool::set_workers(int count) {
  state_->workers.store(std::clamp(count, 1, kMaxWorkers), std::memory_order_relaxed);
}

void ThreadPool::prepare(const std::vector<Pages>& pages) {
  State& s = *state_;
  std::unique_lock owner(s.owner, std::try_to_lock);
  if (!owner || s.start(workers() - 1) == 0) return;
  {
    std::lock_guard lock(s.mutex);
    s.pages.insert(s.pages.end(), pages.begin(), pages.end());
  }
  s.wake.notify_one();
}

void ThreadPool::run_erased(size_t count, Call call, void* object) {
  State& s = *state_;
  const int wanted = static_cast<int>(std::min<size_t>(static_cast<size_t>(workers()), count));
  std::unique_lock owner(s.owner, std::defer_lock);
  if (wanted <= 1 || count > 0xffffffff || !owner.try_lock()) {
    for (size_t i = 0; i < count; ++i) call(object, i, 0);
    return;
  }
  const int others = s.start(wanted - 1);
  {
    std::lock_guard lock(s.mutex);
    s.call = call;
    s.object = object;
    s.failure = nullptr;
    s.wanted = others + 1;
    // Neighbouring indices share memory, so each worker gets a piece of them and not every second one.
    for (int k = 0; k < s.wanted; ++k) {
      const auto part = [&](int n) { return uint64_t(count) * uint64_t(n) / uint64_t(s.wanted); };
      s.share[k].rest.store(State::range(part(k), part(k + 1)), std::memory_order_relaxed);
    }
    s.open = true;
    s.generation.fetch_add(1, std::memory_order_release);
  }
  s.wake.notify_all();
  s.work(0);
  {
    std::lock_guard lock(s.mutex);
    s.open = false;
  }
  for (int i = 0; i < 2000 && s.active.load(std::memory_order_acquire) != 0; ++i) _mm_pause();
  {
    std::unique_lock lock(s.mutex);
    s.done.wait(lock, [&] { return s.active.load(std::memory_order_acquire) == 0; });
  }
  if (s.failure) std::rethrow_exception(std::exchange(s.failure, nullptr));
}

} // namespace softgl
