// Bits: those of a mask, one by one, and those of values.
#pragma once

#include <cstdint>
#include <cstring>

namespace softgl {

/// True where two values are the same bit by bit, as pictures need it: -0 is not 0, and what is not a number
/// is itself.
inline bool same_bits(const void* a, const void* b, size_t bytes) { return std::memcmp(a, b, bytes) == 0; }

/// for (const int i : Bits(mask)): the numbers of the bits that are set, the lowest first.
class Bits {
public:
  explicit Bits(uint32_t mask) : mask_(mask) {}

  class Iterator {
  public:
    explicit Iterator(uint32_t left) : left_(left) {}
    int operator*() const { return __builtin_ctz(left_); }
    Iterator& operator++() {
      left_ &= left_ - 1;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return left_ != other.left_; }

  private:
    uint32_t left_;
  };
  Iterator begin() const { return Iterator(mask_); }
  Iterator end() const { return Iterator(0); }

private:
  uint32_t mask_;
};

} // namespace softgl
