// The bits of a mask, one by one.
#pragma once

#include <cstdint>

namespace softgl {

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
