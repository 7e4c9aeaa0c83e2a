#include "commands/vertices/index_range.h"

#include <algorithm>
#include <cstring>

#include "base/cpu_features.h"
#include "base/fast_paths.h"

namespace softgl {
namespace {

// Loads through a packed struct: indices in client memory may have any alignment.
template <class T> struct __attribute__((packed, may_alias)) Unaligned { T value; };

template <class T>
__attribute__((always_inline)) inline IndexRange scan(const void* indices, uint32_t count) {
  const auto* p = static_cast<const Unaligned<T>*>(indices);
  T low = T(~T(0)), high = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const T v = p[i].value;
    low = v < low ? v : low;
    high = v > high ? v : high;
  }
  return {low, high};
}
__attribute__((always_inline)) inline IndexRange scan_any(const void* indices, GLenum type, uint32_t count) {
  if (type == GL_UNSIGNED_BYTE) return scan<uint8_t>(indices, count);
  if (type == GL_UNSIGNED_SHORT) return scan<uint16_t>(indices, count);
  return scan<uint32_t>(indices, count);
}

// Integers only: the same answer from either. SSE2 has no minimum of unsigned integers.
__attribute__((target("avx2"))) IndexRange scan_wide(const void* indices, GLenum type, uint32_t count) {
  return scan_any(indices, type, count);
}
IndexRange scan_narrow(const void* indices, GLenum type, uint32_t count) {
  return scan_any(indices, type, count);
}

} // namespace

IndexRange index_range(const void* indices, GLenum type, uint32_t count) {
  static const bool wide = selected_isa() >= Isa::V3;
  return wide ? scan_wide(indices, type, count) : scan_narrow(indices, type, count);
}

IndexRange copy_indices(const void* indices, GLenum type, uint32_t count, void* copy) {
  constexpr uint32_t kPiece = 4096; // stays in the first-level cache between the two passes
  const uint32_t bytes = index_bytes(type);
  const auto* from = static_cast<const unsigned char*>(indices);
  auto* to = static_cast<unsigned char*>(copy);
  IndexRange all{~0u, 0};
  for (uint32_t done = 0; done < count; done += kPiece) {
    const uint32_t n = std::min(kPiece, count - done);
    const IndexRange r = index_range(from + size_t(done) * bytes, type, n);
    all = {std::min(all.low, r.low), std::max(all.high, r.high)};
    std::memcpy(to + size_t(done) * bytes, from + size_t(done) * bytes, size_t(n) * bytes);
  }
  return all;
}

IndexRange index_range(BufferObject& buffer, size_t offset, GLenum type, uint32_t count) {
  if (!takes(FastPath::CachedRanges)) return index_range(buffer.storage->bytes + offset, type, count);
  std::lock_guard lock(buffer.ranges_mutex);
  if (!buffer.ranges)
    buffer.ranges = std::make_unique<BufferObject::CachedRange[]>(BufferObject::kCachedRanges);
  const size_t hash = (offset / 4 * 0x9e3779b97f4a7c15ull + count * 0xc2b2ae3d27d4eb4full) >> 56;
  BufferObject::CachedRange& entry = buffer.ranges[hash % BufferObject::kCachedRanges];
  if (entry.version != buffer.version || entry.offset != offset || entry.count != count || entry.type != type)
    entry = {buffer.version, offset, count, type, index_range(buffer.storage->bytes + offset, type, count)};
  return entry.range;
}

} // namespace softgl
