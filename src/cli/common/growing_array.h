// A growing array of plain values that never clears what it grows by.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

namespace softgl::cli {

// std::vector zeroes what resize() adds and copies on growth; realloc moves large blocks by remapping pages,
// which is most of the difference between 300 and 500 MB/s of OBJ text.
template <class T> class GrowingArray {
  static_assert(std::is_trivially_copyable_v<T>);

public:
  GrowingArray() = default;
  GrowingArray(GrowingArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)),
        capacity_(std::exchange(other.capacity_, 0)) {}
  GrowingArray& operator=(GrowingArray&& other) noexcept {
    if (this != &other) {
      std::free(data_);
      data_ = std::exchange(other.data_, nullptr);
      size_ = std::exchange(other.size_, 0);
      capacity_ = std::exchange(other.capacity_, 0);
    }
    return *this;
  }
  ~GrowingArray() { std::free(data_); }
  // Takes over memory from malloc that holds `size` values.
  static GrowingArray adopt(T* data, size_t size) {
    GrowingArray array;
    array.data_ = data;
    array.size_ = array.capacity_ = size;
    return array;
  }

  T* data() { return data_; }
  const T* data() const { return data_; }
  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](size_t index) { return data_[index]; }
  const T& operator[](size_t index) const { return data_[index]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  T& back() { return data_[size_ - 1]; }

  // Room for `count` more values, not yet counted in size().
  T* room(size_t count) {
    if (size_ + count > capacity_) [[unlikely]]
      grow(size_ + count);
    return data_ + size_;
  }
  void commit(size_t count) { size_ += count; }
  T* extend(size_t count) {
    T* first = room(count);
    size_ += count;
    return first;
  }
  void append(T value) {
    *room(1) = value;
    ++size_;
  }
  void append(const T* values, size_t count) {
    if (count) std::memcpy(extend(count), values, count * sizeof(T));
  }
  void fill(size_t count, T value) {
    T* first = extend(count);
    for (size_t i = 0; i < count; ++i) first[i] = value;
  }
  void truncate(size_t size) { size_ = size; }
  void release() { *this = GrowingArray(); }

private:
  void grow(size_t needed) {
    size_t capacity = capacity_ + capacity_ / 2 + 256;
    if (capacity < needed) capacity = needed;
    if (capacity > SIZE_MAX / sizeof(T)) throw std::bad_alloc();
    T* data = static_cast<T*>(std::realloc(static_cast<void*>(data_), capacity * sizeof(T)));
    if (!data) throw std::bad_alloc();
    data_ = data;
    capacity_ = capacity;
  }

  T* data_ = nullptr;
  size_t size_ = 0;
  size_t capacity_ = 0;
};

} // namespace softgl::cli
