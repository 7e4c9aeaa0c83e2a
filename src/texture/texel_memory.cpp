#include "texture/texel_memory.h"

#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

#include "base/pages.h"

namespace softgl {
namespace {

// From here on memory comes from the system in huge pages. 16 million texels from the heap, zeroed by hand,
// took 90 ms before the first was stored; with pages that arrive when they are written it is a fifth of it.
constexpr size_t kManyBytes = kHugePage;

} // namespace

TexelMemory::TexelMemory(size_t bytes) : size_(bytes) {
  if (bytes == 0) return;
  data_ = static_cast<unsigned char*>(bytes < kManyBytes ? std::calloc(1, bytes) : map_pages(bytes));
  if (!data_) throw std::bad_alloc();
}

TexelMemory::TexelMemory(const TexelMemory& other) : TexelMemory(other.size_) {
  if (size_) std::memcpy(data_, other.data_, size_);
}

TexelMemory::TexelMemory(TexelMemory&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}

TexelMemory& TexelMemory::operator=(TexelMemory other) noexcept {
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  return *this;
}

TexelMemory::~TexelMemory() {
  if (size_ < kManyBytes)
    std::free(data_);
  else
    unmap_pages(data_, size_);
}

} // namespace softgl
