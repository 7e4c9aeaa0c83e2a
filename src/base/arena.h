// A bump allocator: blocks of memory that live until the frame ends. Not safe for two threads at once; each
// thread of a frame has its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/pages.h"

namespace softgl {

class Arena {
public:
  explicit Arena(size_t block_bytes = 256 * 1024) : block_bytes_(block_bytes) {}
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;
  ~Arena() { release(); }

  /// `bytes` of uninitialised memory, aligned to 64 bytes. Throws std::bad_alloc.
  void* allocate(size_t bytes) {
    bytes = (bytes + 63) & ~size_t(63);
    if (size_t(end_ - next_) < bytes) grow(bytes);
    void* p = next_;
    next_ += bytes;
    used_ += bytes;
    return p;
  }
  template <class T> T* allocate_array(size_t count) {
    static_assert(std::is_trivially_destructible_v<T>);
    return static_cast<T*>(allocate(count * sizeof(T)));
  }
  template <class T, class... A> T* make(A&&... arguments) {
    static_assert(std::is_trivially_destructible_v<T>);
    return new (allocate(sizeof(T))) T{std::forward<A>(arguments)...};
  }
  /// Opens what is left of a block, at least `minimum` bytes, to a writer who does not know yet how much it
  /// needs. Nothing else may be allocated until give_back() says how much was used.
  void* allocate_rest(size_t minimum, size_t& bytes) {
    minimum = (minimum + 63) & ~size_t(63);
    if (size_t(end_ - next_) < minimum) grow(minimum);
    bytes = size_t(end_ - next_);
    return next_;
  }
  void give_back(void* start, size_t used_bytes) {
    used_bytes = (used_bytes + 63) & ~size_t(63);
    next_ = static_cast<std::byte*>(start) + used_bytes;
    if (next_ > end_) next_ = end_; // the block's size need not be a multiple of 64
    used_ += used_bytes;
  }
  /// Forgets all allocations and keeps the blocks for the next frame.
  void reset() {
    used_ = 0;
    current_ = 0;
    next_ = end_ = nullptr;
  }
  /// Forgets all allocations and gives the blocks back.
  void release() {
    for (const Block& b : blocks_)
      if (b.owned) unmap_pages(b.memory, b.size);
    blocks_.clear();
    reset();
  }
  /// Where allocation stands, and back there: forgets what was allocated since.
  struct Mark {
    size_t current, used;
    std::byte *next, *end;
  };
  Mark mark() const { return {current_, used_, next_, end_}; }
  void rewind(const Mark& m) { current_ = m.current, used_ = m.used, next_ = m.next, end_ = m.end; }
  size_t used() const { return used_; }
  /// Gets a first block that belongs to somebody else, who keeps it as long; all others will be large.
  void begin_with(Pages block) {
    blocks_.insert(blocks_.begin(), {static_cast<std::byte*>(block.memory), block.bytes, false});
    block_bytes_ = 2 * kHugePage;
  }
  /// Begins at once with a large block, if there is none yet; gives it, or nothing.
  Pages prepare() {
    if (!blocks_.empty()) return {};
    block_bytes_ = 2 * kHugePage;
    grow(1);
    reset();
    return {blocks_[0].memory, blocks_[0].size};
  }

private:
  struct Block {
    std::byte* memory;
    size_t size;
    bool owned;
  };
  void grow(size_t bytes) {
    while (current_ < blocks_.size() && blocks_[current_].size < bytes) ++current_;
    if (current_ == blocks_.size()) {
      // Small contexts stay small; what is larger lives in huge pages, which are zeroed seven times as fast
      // as it takes to fault small ones in (0.11 and 0.78 ms a megabyte).
      const size_t size = bytes > block_bytes_ ? (bytes + 4095) & ~size_t(4095) : block_bytes_;
      block_bytes_ = 2 * kHugePage;
      blocks_.reserve(blocks_.size() + 1);
      auto* memory = static_cast<std::byte*>(map_pages(size));
      if (!memory) throw std::bad_alloc();
      blocks_.push_back({memory, size, true});
    }
    next_ = blocks_[current_].memory;
    end_ = next_ + blocks_[current_].size;
    ++current_;
  }
  std::vector<Block> blocks_;
  size_t block_bytes_, current_ = 0, used_ = 0;
  std::byte *next_ = nullptr, *end_ = nullptr;
};

} // namespace softgl
