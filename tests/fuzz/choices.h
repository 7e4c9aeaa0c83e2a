// Numbers that decide what a test does: random ones, or those that a fuzzer's bytes spell.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>

#include "support/random.h"

namespace softgl::test {

/// Draw one number per statement: the order of evaluation of call arguments is open.
class Choices {
public:
  explicit Choices(uint64_t seed) : random_(seed) {}
  /// Behind the last byte every number is the lowest of its range.
  explicit Choices(std::span<const uint8_t> bytes) : random_(0), bytes_(bytes), from_bytes_(true) {}

  /// An integer in [low, high].
  int integer(int low, int high) {
    const auto span = uint64_t(int64_t(high) - low + 1);
    return int(int64_t(low) + int64_t(bits(span <= 256 ? 1 : span <= 65536 ? 2 : 4) % span));
  }
  /// True in `percent` of a hundred cases.
  bool chance(int percent) { return integer(0, 99) >= 100 - percent; }
  template <class T> T pick(std::initializer_list<T> values) {
    return values.begin()[integer(0, int(values.size()) - 1)];
  }
  uint64_t seed() { return bits(8); }
  /// All bytes are used up.
  bool ended() const { return from_bytes_ && bytes_.empty(); }

private:
  uint64_t bits(int count) {
    if (!from_bytes_) return random_.bits() >> 8; // the upper ones of 64 are as good as the lower ones
    uint64_t value = 0;
    for (; count > 0 && !bytes_.empty(); --count, bytes_ = bytes_.subspan(1)) value = value << 8 | bytes_[0];
    return value;
  }

  Random random_;
  std::span<const uint8_t> bytes_;
  bool from_bytes_ = false;
};

} // namespace softgl::test
