// The pool: every index once, exceptions come back, forks and concurrent callers survive.
#include <catch2/catch.hpp>

#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/thread_pool.h"

using softgl::ThreadPool;

namespace {

struct Workers { // restores the number of workers
  int before = ThreadPool::instance().workers();
  ~Workers() { ThreadPool::instance().set_workers(before); }
};

bool runs_all(size_t count) {
  std::vector<std::atomic<int>> calls(count);
  const int workers = ThreadPool::instance().workers();
  std::atomic<bool> in_range{true};
  ThreadPool::instance().run(count, [&](size_t i, int worker) {
    ++calls[i];
    if (worker < 0 || worker >= workers) in_range = false;
  });
  for (auto& c : calls)
    if (c != 1) return false;
  return in_range;
}

} // namespace

TEST_CASE("the pool calls every index once, with any number of workers", "[thread_pool]") {
  Workers restore;
  for (int workers : {1, 2, 3, 8, 1, 2}) {
    ThreadPool::instance().set_workers(workers);
    CHECK(ThreadPool::instance().workers() == workers);
    for (size_t count : {0, 1, 2, 7, 1000})
      for (int round = 0; round < 20; ++round) REQUIRE(runs_all(count));
  }
  ThreadPool::instance().set_workers(0);
  CHECK(ThreadPool::instance().workers() == 1);
}

TEST_CASE("an exception of a worker reaches the caller and the pool goes on", "[thread_pool]") {
  Workers restore;
  for (int workers : {1, 3}) {
    ThreadPool::instance().set_workers(workers);
    CHECK_THROWS_AS(ThreadPool::instance().run(100,
                                               [](size_t i, int) {
                                                 if (i == 57) throw std::runtime_error("57");
                                               }),
                    std::runtime_error);
    CHECK(runs_all(100));
  }
}

TEST_CASE("two threads may run at the same time", "[thread_pool]") {
  Workers restore;
  ThreadPool::instance().set_workers(3);
  std::atomic<bool> good{true};
  auto work = [&] {
    for (int i = 0; i < 200; ++i)
      if (!runs_all(50)) good = false;
  };
  std::thread other(work);
  work();
  other.join();
  CHECK(good);
}

TEST_CASE("the child of a fork has a pool that works", "[thread_pool]") {
  Workers restore;
  ThreadPool::instance().set_workers(3);
  REQUIRE(runs_all(100));
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) _exit(ThreadPool::instance().workers() == 3 && runs_all(100) ? 0 : 1);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(runs_all(100));
}

TEST_CASE("the pool's threads leave the caller's processor to the caller", "[thread_pool]") {
  cpu_set_t mine, mine_after;
  REQUIRE(sched_getaffinity(0, sizeof mine, &mine) == 0);
  if (CPU_COUNT(&mine) < 2) return;
  Workers restore;
  ThreadPool::instance().set_workers(2);
  std::atomic<int> processors{-1};
  // Until the other thread has taken part.
  for (int round = 0; round < 10000 && processors < 0; ++round)
    ThreadPool::instance().run(2, [&](size_t, int worker) {
      if (worker == 0) return usleep(100), void();
      cpu_set_t set;
      if (sched_getaffinity(0, sizeof set, &set) == 0) processors = CPU_COUNT(&set);
    });
  CHECK(processors == CPU_COUNT(&mine) - 1);
  REQUIRE(sched_getaffinity(0, sizeof mine_after, &mine_after) == 0);
  CHECK(CPU_EQUAL(&mine, &mine_after));
}
