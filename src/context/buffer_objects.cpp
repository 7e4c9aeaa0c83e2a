#include "context/buffer_objects.h"

#include <cstdlib>
#include <new>

#include "base/early_pages.h"
#include "base/pages.h"

namespace softgl {

BufferStorage::BufferStorage(size_t n) : size(n) {
  if (n > SIZE_MAX - kSpareBytes) throw std::bad_alloc();
  // Zeroed pages are free; a buffer without data reads as zero.
  bytes = static_cast<unsigned char*>(take_early_pages(n + kSpareBytes));
  if (bytes) return;
  bytes = static_cast<unsigned char*>(std::calloc(1, n + kSpareBytes));
  if (!bytes) throw std::bad_alloc();
  prefer_huge_pages({bytes, n});
}
BufferStorage::~BufferStorage() {
  if (!give_back_early_pages(bytes)) std::free(bytes);
}

} // namespace softgl
