// The memory that commands of the fuzzers read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

namespace softgl::test {

/// 32 MiB, of which the first pages are not 0: as bytes, shorts or words they hold numbers below 21.
struct InputMemory {
  alignas(64) unsigned char images[1 << 25];
  alignas(64) uint32_t indices[1024];
  const void* index_arrays[8];
  InputMemory() {
    for (size_t i = 0; i < 1 << 18; ++i) images[i] = static_cast<unsigned char>(i * 37 + (i >> 7));
    for (uint32_t i = 0; i < std::size(indices); ++i) indices[i] = i * 7 % 21;
    for (size_t i = 0; i < std::size(index_arrays); ++i) index_arrays[i] = indices + i * 8;
  }
};
inline InputMemory& input() {
  static InputMemory memory;
  return memory;
}

} // namespace softgl::test
