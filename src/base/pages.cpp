#include "base/pages.h"

#include "base/fast_paths.h"

#include <cstdint>
#include <sys/mman.h>

namespace softgl {

void* map_pages(size_t bytes) {
  const size_t length = (bytes + 4095) & ~size_t(4095);
  const size_t spare = length < kHugePage ? 0 : kHugePage; // room to begin at a huge page
  if (length < bytes || length + spare < length) return nullptr;
  void* memory = mmap(nullptr, length + spare, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) return nullptr;
  if (!spare) return memory;
  auto* begin = static_cast<unsigned char*>(memory);
  const size_t before = -reinterpret_cast<uintptr_t>(begin) % kHugePage;
  if (before) munmap(begin, before);
  if (before < spare) munmap(begin + before + length, spare - before);
  if (takes(FastPath::HugePages)) madvise(begin + before, length, MADV_HUGEPAGE);
  return begin + before;
}

void prefer_huge_pages(Pages pages) {
  const auto first = reinterpret_cast<uintptr_t>(pages.memory) & ~uintptr_t(4095);
  const auto last = (reinterpret_cast<uintptr_t>(pages.memory) + pages.bytes + 4095) & ~uintptr_t(4095);
  if (last - first >= kHugePage && takes(FastPath::HugePages))
    madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}

void populate_pages([[maybe_unused]] Pages pages) {
#ifdef MADV_POPULATE_WRITE // Linux 5.14; without it pages come when they are written
  const auto first = (reinterpret_cast<uintptr_t>(pages.memory) + 4095) & ~uintptr_t(4095);
  const auto last = (reinterpret_cast<uintptr_t>(pages.memory) + pages.bytes) & ~uintptr_t(4095);
  // A piece at a time: the address space is locked meanwhile.
  constexpr uintptr_t kPiece = size_t(1) << 20;
  for (uintptr_t p = first; p < last; p += kPiece)
    if (madvise(reinterpret_cast<void*>(p), last - p < kPiece ? last - p : kPiece, MADV_POPULATE_WRITE) != 0)
      return;
#endif
}

void unmap_pages(void* memory, size_t bytes) {
  if (memory) munmap(memory, (bytes + 4095) & ~size_t(4095));
}

} // namespace softgl
