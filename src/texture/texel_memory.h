// The memory of an image's texels.
#pragma once

#include <cstddef>

namespace softgl {

/// Zeroed bytes, which nobody has touched yet where they are many: each is then brought in when it is
/// written.
class TexelMemory {
public:
  TexelMemory() = default;
  explicit TexelMemory(size_t bytes); // throws std::bad_alloc
  TexelMemory(const TexelMemory& other);
  TexelMemory(TexelMemory&& other) noexcept;
  TexelMemory& operator=(TexelMemory other) noexcept;
  ~TexelMemory();

  unsigned char* data() { return data_; }
  const unsigned char* data() const { return data_; }
  size_t size() const { return size_; }

private:
  unsigned char* data_ = nullptr;
  size_t size_ = 0;
};

} // namespace softgl
