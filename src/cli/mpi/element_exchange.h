// Vertices that a rank's faces name, wherever in the file they stand.
#pragma once

#include <cstdint>
#include <vector>

#include "common/growing_array.h"
#include "mpi/ranks.h"
#include "obj/obj_chunk.h"

namespace softgl::cli {

// The numbers that lists of indices hold, each once, in rising order. Others than 0 to `count` - 1 are left
// out.
class IndexSet {
public:
  explicit IndexSet(uint64_t count) : count_(count) {}

  // First all lists, then all lists again: the set takes a bit for each number between the least and the
  // largest.
  void measure(const IndexList& list);
  void add(const IndexList& list);
  // After the last add().
  std::vector<uint32_t> numbers();
  // Numbers become places in numbers(). Those that are left out become kNowhere; kAbsent stays.
  void renumber(IndexList& list) const;

private:
  bool holds(int32_t index) const { return index >= 0 && uint64_t(index) < count_; }

  const uint64_t count_;
  int32_t low_ = kNowhere, high_ = -1;
  std::vector<uint64_t> bits_;
  std::vector<uint32_t> before_; // numbers before each word of bits_
};

// The elements of those numbers, in their order. `own` are this rank's, of `per_element` values each; the
// first one has number firsts[rank], and firsts has one entry more than there are ranks. All ranks call.
template <class T> GrowingArray<T> fetch_elements(const std::vector<uint32_t>& numbers, GrowingArray<T> own,
                                                  size_t per_element, const std::vector<uint64_t>& firsts,
                                                  const Ranks& ranks);

} // namespace softgl::cli
