// Memory that ends on demand: replaces malloc and its relatives, operator new, mmap and pthread_create, and
// lets the k-th call fail that code of the watched library makes. Part of the executable (with
// ENABLE_EXPORTS), or loaded with LD_PRELOAD; see failing_malloc.cpp for the variables that control it there.
#pragma once

#include <cstdint>

namespace softgl::test {

/// Calls are counted, and fail, when they come from the shared object that holds this address.
void watch_object_at(const void* address);

/// From now on the k-th call fails, once or with all after it. k = 0: calls are only counted.
void fail_allocation(uint64_t k, bool persistent);

struct Allocations {
  uint64_t calls = 0, failed = 0;
};
/// Ends what fail_allocation() has begun.
Allocations stop_failing();

/// What the watched object has asked for and nobody has given back.
struct LiveMemory {
  int64_t objects = 0, mapped_bytes = 0;
};
LiveMemory live_memory();

/// Says where each failed call came from, on standard error.
void print_stacks_of_failures();

} // namespace softgl::test
