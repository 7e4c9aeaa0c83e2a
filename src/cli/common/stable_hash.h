// A hash that is the same on every machine and in every version.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace softgl::cli {

// 64 bits, not cryptographic. Each step is h = (h ^ word) * 0x100000001b3, h ^= h >> 32, from
// 0xcbf29ce484222325 on. Words have eight bytes, the first being the lowest; the last is filled with zeros.
class StableHash {
public:
  void add(uint64_t word) {
    value_ = (value_ ^ word) * 0x100000001b3;
    value_ ^= value_ >> 32;
  }

  // Their number, then the bytes.
  void add(const void* bytes, size_t count) {
    const auto* at = static_cast<const unsigned char*>(bytes);
    add(count);
    for (; count >= 8; count -= 8, at += 8) add(word_at(at, 8));
    if (count > 0) add(word_at(at, count));
  }
  void add(std::string_view text) { add(text.data(), text.size()); }

  uint64_t value() const { return value_; }

  // 16 hexadecimal digits.
  std::string text() const {
    std::string digits(16, '0');
    for (size_t i = 0; i < 16; ++i) digits[i] = "0123456789abcdef"[value_ >> (60 - 4 * i) & 15];
    return digits;
  }

private:
  static uint64_t word_at(const unsigned char* bytes, size_t count) {
    uint64_t word = 0;
    for (size_t i = 0; i < count; ++i) word |= uint64_t(bytes[i]) << (8 * i);
    return word;
  }

  uint64_t value_ = 0xcbf29ce484222325;
};

} // namespace softgl::cli
