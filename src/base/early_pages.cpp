#include "base/early_pages.h"

#include <sys/mman.h>

#include <atomic>
#include <cstdint>
#include <mutex>

namespace softgl {

namespace {

constexpr size_t kBytes = kHugePage, kUnit = 64; // more would have to be made zero, too
constexpr size_t kLeast = size_t(64) << 10;      // what is smaller comes from memory that malloc has already
constexpr uint32_t kUnits = kBytes / kUnit;

std::atomic<unsigned char*> memory_begin{nullptr};

struct alignas(uint64_t) Use {     // as large as its alignment: Clang asks libatomic otherwise
  uint32_t objects = 0, units = 0; // not yet given back; taken from the front
};
// Closed until there is memory. No lock: the child of a fork could find it held.
std::atomic<Use> use{Use{0, kUnits}};
static_assert(std::atomic<Use>::is_always_lock_free);

} // namespace

Pages open_early_pages() {
  static std::once_flag once;
  std::call_once(once, [] {
    memory_begin = static_cast<unsigned char*>(map_pages(kBytes));
    if (memory_begin) use = Use{};
  });
  return {memory_begin, use.load().units == 0 ? kBytes : 0};
}

void* take_early_pages(size_t bytes) {
#ifdef SOFTGL_ADDRESS_SANITIZER
  return nullptr; // AddressSanitizer sees where objects of malloc end
#endif
  if (bytes < kLeast || bytes > kBytes) return nullptr;
  const auto units = static_cast<uint32_t>((bytes + kUnit - 1) / kUnit);
  Use before = use.load();
  do {
    if (kUnits - before.units < units) return nullptr;
  } while (!use.compare_exchange_weak(before, Use{before.objects + 1, before.units + units}));
  return memory_begin + size_t(before.units) * kUnit;
}

bool give_back_early_pages(void* memory) {
  const auto offset = static_cast<uintptr_t>(static_cast<unsigned char*>(memory) - memory_begin.load());
  if (!memory_begin.load() || offset >= kBytes) return false;
  Use before = use.load(), after;
  do {
    // The last one closes the memory while it makes it zero again.
    after = before.objects == 1 ? Use{0, kUnits} : Use{before.objects - 1, before.units};
  } while (!use.compare_exchange_weak(before, after));
  if (after.objects == 0) {
    madvise(memory_begin, kBytes, MADV_DONTNEED);
    use = Use{};
  }
  return true;
}

} // namespace softgl
