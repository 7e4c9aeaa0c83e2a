// In a program that is started with LD_PRELOAD=libfailing_malloc.so three variables control it:
//   SOFTGL_FAIL_AT=k          the k-th call of the whole process fails; 0 only counts
//   SOFTGL_FAIL_PERSISTENT=1  so do all later ones
//   SOFTGL_FAIL_COUNT=FILE    the number of calls is written there when the process ends
// Calls are counted from the constructor of this object on, except those of the C library itself and of
// ld.so.
#include "faults/failing_malloc.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <execinfo.h>
#include <link.h>
#include <new>
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>

#define EXPORT __attribute__((visibility("default")))

namespace softgl::test {
namespace {

// --- The real functions
// ---------------------------------------------------------------------------------------------

struct Functions {
  void* (*malloc)(size_t);
  void* (*calloc)(size_t, size_t);
  void* (*realloc)(void*, size_t);
  void* (*aligned_alloc)(size_t, size_t);
  void (*free)(void*);
  void* (*mmap)(void*, size_t, int, int, int, off_t);
  int (*munmap)(void*, size_t);
  int (*pthread_create)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
};

constinit Functions functions{};
constinit bool looking_up = false;
// dlsym() may ask for memory before there is a function to ask.
alignas(16) constinit unsigned char early_memory[1 << 14];
constinit size_t early_used = 0;

bool is_early(const void* p) { return p >= early_memory && p < early_memory + sizeof early_memory; }
void* take_early(size_t bytes) {
  void* p = early_memory + early_used;
  early_used += (bytes + 15) & ~size_t(15);
  return early_used <= sizeof early_memory ? p : nullptr;
}

const Functions& real() {
  if (functions.pthread_create) return functions;
  looking_up = true;
  const auto find = [](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(RTLD_NEXT, name));
  };
  find(functions.malloc, "malloc");
  find(functions.calloc, "calloc");
  find(functions.realloc, "realloc");
  find(functions.aligned_alloc, "aligned_alloc");
  find(functions.free, "free");
  find(functions.mmap, "mmap");
  find(functions.munmap, "munmap");
  find(functions.pthread_create, "pthread_create");
  looking_up = false;
  return functions;
}

// --- What is watched
// ------------------------------------------------------------------------------------------------

struct Range {
  uintptr_t begin, end;
};
constexpr int kMostRanges = 64;
constinit Range ranges[kMostRanges] = {};
constinit int range_count = 0;

bool watched(const void* caller) {
  const auto at = reinterpret_cast<uintptr_t>(caller);
  for (int i = 0; i < range_count; ++i)
    if (at >= ranges[i].begin && at < ranges[i].end) return true;
  return false;
}

/// Adds the code of every loaded object for which `wanted` says so.
template <class Wanted> void watch_objects(Wanted wanted) {
  auto visit = [](dl_phdr_info* info, size_t, void* data) {
    const auto segment = [&](int i) {
      const auto begin = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
      return Range{begin, begin + info->dlpi_phdr[i].p_memsz};
    };
    bool chosen = false;
    for (int i = 0; i < info->dlpi_phnum; ++i)
      chosen = chosen ||
               (info->dlpi_phdr[i].p_type == PT_LOAD && (*static_cast<Wanted*>(data))(*info, segment(i)));
    for (int i = 0; chosen && i < info->dlpi_phnum && range_count < kMostRanges; ++i)
      if (info->dlpi_phdr[i].p_type == PT_LOAD && info->dlpi_phdr[i].p_flags & PF_X)
        ranges[range_count++] = segment(i);
    return 0;
  };
  dl_iterate_phdr(visit, &wanted);
}

// --- Which call fails
// -----------------------------------------------------------------------------------------------

constinit std::atomic<bool> counting{false}, stacks{false};
constinit std::atomic<uint64_t> calls{0}, failed{0}, first_to_fail{0};
constinit std::atomic<bool> all_later_too{false};

[[gnu::noinline]] bool fails() {
  if (!counting.load(std::memory_order_relaxed)) return false;
  const uint64_t n = ++calls, k = first_to_fail;
  if (k == 0 || n < k || (n > k && !all_later_too)) return false;
  ++failed;
  if (stacks) {
    void* frames[40];
    counting = false; // the C library may ask for memory here
    std::fprintf(stderr, "allocation %llu fails:\n", static_cast<unsigned long long>(n));
    backtrace_symbols_fd(frames, backtrace(frames, 40), STDERR_FILENO);
    counting = true;
  }
  return true;
}

// --- What is live
// ---------------------------------------------------------------------------------------------------

/// A set of addresses that asks for no memory itself.
class AddressSet {
public:
  void insert(void* p) {
    const Lock lock(*this);
    size_t at = place(p);
    while (table_[at] && table_[at] != kGone) at = (at + 1) % kSize;
    table_[at] = p;
    ++count_;
  }
  void erase(void* p) {
    const Lock lock(*this);
    size_t at = place(p);
    for (size_t i = 0; i < kSize && table_[at]; ++i, at = (at + 1) % kSize)
      if (table_[at] == p) {
        table_[at] = table_[(at + 1) % kSize] ? kGone : nullptr;
        --count_;
        return;
      }
  }
  int64_t count() const { return count_; }

private:
  static constexpr size_t kSize = size_t(1) << 18;
  static inline void* const kGone = reinterpret_cast<void*>(1);
  struct Lock {
    AddressSet& set;
    explicit Lock(AddressSet& s) : set(s) {
      while (set.busy_.test_and_set(std::memory_order_acquire)) {}
    }
    ~Lock() { set.busy_.clear(std::memory_order_release); }
  };
  static size_t place(void* p) {
    return (reinterpret_cast<uintptr_t>(p) >> 4) * 0x9e3779b97f4a7c15u >> (64 - 18);
  }
  std::atomic_flag busy_;
  void* table_[kSize] = {};
  std::atomic<int64_t> count_{0};
};
constinit AddressSet live;
constinit std::atomic<int64_t> mapped_bytes{0};

/// Asks `get` for memory on behalf of `caller`.
template <class Get> void* allocate(const void* caller, Get get) {
  if (looking_up) return nullptr;
  if (!watched(caller)) return get();
  if (fails()) {
    errno = ENOMEM;
    return nullptr;
  }
  void* p = get();
  if (p) live.insert(p);
  return p;
}

void give_back(void* p) {
  if (!p || is_early(p)) return;
  if (range_count) live.erase(p);
  real().free(p);
}

void* allocate_new(const void* caller, size_t bytes, size_t alignment) {
  return allocate(caller, [&]() -> void* {
    const size_t n = bytes ? bytes : 1;
    if (alignment <= 16) return real().malloc(n);
    return real().aligned_alloc(alignment, (n + alignment - 1) / alignment * alignment);
  });
}
void* allocate_new_or_throw(const void* caller, size_t bytes, size_t alignment) {
  if (void* p = allocate_new(caller, bytes, alignment)) return p;
  throw std::bad_alloc();
}

// --- LD_PRELOAD
// -----------------------------------------------------------------------------------------------------

__attribute__((constructor)) void obey_environment() {
  const char* k = std::getenv("SOFTGL_FAIL_AT");
  if (!k) return;
  watch_objects([](const dl_phdr_info& info, const Range&) {
    for (const char* spared :
         {"/libc.so", "/ld-linux", "libfailing_malloc", "linux-vdso", "/libasan", "/libubsan"})
      if (std::strstr(info.dlpi_name, spared)) return false;
    return true;
  });
  const char* persistent = std::getenv("SOFTGL_FAIL_PERSISTENT");
  fail_allocation(std::strtoull(k, nullptr, 10), persistent && *persistent == '1');
}

__attribute__((destructor)) void write_count() {
  const char* path = std::getenv("SOFTGL_FAIL_COUNT");
  const Allocations seen = stop_failing();
  if (!path) return;
  if (FILE* file = std::fopen(path, "w")) {
    std::fprintf(file, "%llu %llu\n", static_cast<unsigned long long>(seen.calls),
                 static_cast<unsigned long long>(seen.failed));
    std::fclose(file);
  }
}

} // namespace

void watch_object_at(const void* address) {
  range_count = 0;
  const auto at = reinterpret_cast<uintptr_t>(address);
  watch_objects([at](const dl_phdr_info&, const Range& r) { return at >= r.begin && at < r.end; });
}

void fail_allocation(uint64_t k, bool persistent) {
  calls = failed = 0;
  first_to_fail = k;
  all_later_too = persistent;
  counting = true;
}

Allocations stop_failing() {
  counting = false;
  return {calls, failed};
}

LiveMemory live_memory() { return {live.count(), mapped_bytes}; }

void print_stacks_of_failures() {
  void* frame;
  backtrace(&frame, 1); // loads what it needs
  stacks = true;
}

} // namespace softgl::test

using namespace softgl::test;

#define CALLER __builtin_return_address(0)

extern "C" {

EXPORT void* malloc(size_t bytes) {
  if (looking_up) return take_early(bytes);
  return allocate(CALLER, [=] { return real().malloc(bytes); });
}
EXPORT void* calloc(size_t count, size_t bytes) {
  if (looking_up) return take_early(count * bytes);
  return allocate(CALLER, [=] { return real().calloc(count, bytes); });
}
EXPORT void* realloc(void* old, size_t bytes) {
  if (!watched(CALLER)) return real().realloc(old, bytes);
  if (bytes && fails()) {
    errno = ENOMEM;
    return nullptr;
  }
  if (old) live.erase(old); // before another thread can be given the same address
  void* p = real().realloc(old, bytes);
  if (p || (old && bytes)) live.insert(p ? p : old);
  return p;
}
EXPORT void* aligned_alloc(size_t alignment, size_t bytes) {
  return allocate(CALLER, [=] { return real().aligned_alloc(alignment, bytes); });
}
EXPORT void* memalign(size_t alignment, size_t bytes) {
  return allocate(CALLER, [=] { return real().aligned_alloc(alignment, bytes); });
}
EXPORT int posix_memalign(void** p, size_t alignment, size_t bytes) {
  void* memory = allocate(CALLER, [=] { return real().aligned_alloc(alignment, bytes); });
  if (memory) *p = memory;
  return memory ? 0 : ENOMEM;
}
EXPORT void free(void* p) { give_back(p); }

EXPORT void* mmap(void* address, size_t bytes, int protection, int flags, int file, off_t offset) {
  const bool ours = watched(CALLER);
  if (ours && fails()) {
    errno = ENOMEM;
    return MAP_FAILED;
  }
  void* p = real().mmap(address, bytes, protection, flags, file, offset);
  if (ours && p != MAP_FAILED) mapped_bytes += int64_t(bytes);
  return p;
}
EXPORT int munmap(void* p, size_t bytes) {
  if (watched(CALLER)) mapped_bytes -= int64_t(bytes);
  return real().munmap(p, bytes);
}
EXPORT int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*main)(void*),
                          void* argument) {
  if (watched(CALLER) && fails()) return EAGAIN;
  return real().pthread_create(thread, attributes, main, argument);
}

} // extern "C"

EXPORT void* operator new(size_t n) { return allocate_new_or_throw(CALLER, n, 16); }
EXPORT void* operator new[](size_t n) { return allocate_new_or_throw(CALLER, n, 16); }
EXPORT void* operator new(size_t n, std::align_val_t a) {
  return allocate_new_or_throw(CALLER, n, size_t(a));
}
EXPORT void* operator new[](size_t n, std::align_val_t a) {
  return allocate_new_or_throw(CALLER, n, size_t(a));
}
EXPORT void* operator new(size_t n, const std::nothrow_t&) noexcept { return allocate_new(CALLER, n, 16); }
EXPORT void* operator new[](size_t n, const std::nothrow_t&) noexcept { return allocate_new(CALLER, n, 16); }
EXPORT void operator delete(void* p) noexcept { give_back(p); }
EXPORT void operator delete[](void* p) noexcept { give_back(p); }
EXPORT void operator delete(void* p, size_t) noexcept { give_back(p); }
EXPORT void operator delete[](void* p, size_t) noexcept { give_back(p); }
EXPORT void operator delete(void* p, std::align_val_t) noexcept { give_back(p); }
EXPORT void operator delete[](void* p, std::align_val_t) noexcept { give_back(p); }
EXPORT void operator delete(void* p, size_t, std::align_val_t) noexcept { give_back(p); }
EXPORT void operator delete[](void* p, size_t, std::align_val_t) noexcept { give_back(p); }
