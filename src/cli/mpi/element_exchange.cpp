#include "mpi/element_exchange.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace softgl::cli {

void IndexSet::measure(const IndexList& list) {
  for (const int32_t index : list.values)
    if (holds(index)) {
      low_ = std::min(low_, index);
      high_ = std::max(high_, index);
    }
}

void IndexSet::add(const IndexList& list) {
  if (bits_.empty() && high_ >= low_) bits_.resize(size_t(high_ - low_) / 64 + 1);
  for (const int32_t index : list.values)
    if (holds(index)) bits_[size_t(index - low_) / 64] |= uint64_t(1) << (index - low_) % 64;
}

std::vector<uint32_t> IndexSet::numbers() {
  std::vector<uint32_t> numbers;
  for (size_t word = 0; word < bits_.size(); ++word) {
    before_.push_back(uint32_t(numbers.size()));
    for (uint64_t bits = bits_[word]; bits; bits &= bits - 1)
      numbers.push_back(uint32_t(low_) + uint32_t(64 * word) + uint32_t(std::countr_zero(bits)));
  }
  return numbers;
}

void IndexSet::renumber(IndexList& list) const {
  for (int32_t& index : list.values) {
    if (index == kAbsent) continue;
    if (!holds(index)) {
      index = kNowhere;
      continue;
    }
    const size_t word = size_t(index - low_) / 64;
    const uint64_t lower = (uint64_t(1) << (index - low_) % 64) - 1;
    index = int32_t(before_[word] + uint32_t(std::popcount(bits_[word] & lower)));
  }
}

template <class T> GrowingArray<T> fetch_elements(const std::vector<uint32_t>& numbers, GrowingArray<T> own,
                                                  size_t per_element, const std::vector<uint64_t>& firsts,
                                                  const Ranks& ranks) {
  const auto rank = size_t(ranks.rank());
  const size_t bytes = per_element * sizeof(T);
  // The numbers rise, so those of each owner stand together.
  std::vector<size_t> cuts;
  cuts.reserve(firsts.size());
  for (const uint64_t first : firsts)
    cuts.push_back(size_t(std::lower_bound(numbers.begin(), numbers.end(), first) - numbers.begin()));
  std::vector<std::vector<uint32_t>> asked(firsts.size() - 1);
  for (size_t owner = 0; owner < asked.size(); ++owner)
    if (owner != rank) asked[owner].assign(numbers.data() + cuts[owner], numbers.data() + cuts[owner + 1]);
  std::vector<std::vector<uint32_t>> answers = ranks.swap(std::move(asked));
  for (std::vector<uint32_t>& answer : answers) {
    std::vector<uint32_t> elements(answer.size() * bytes / 4);
    for (size_t i = 0; i < answer.size(); ++i)
      std::memcpy(elements.data() + i * bytes / 4, &own[per_element * size_t(answer[i] - firsts[rank])],
                  bytes);
    answer = std::move(elements);
  }
  answers = ranks.swap(std::move(answers));
  GrowingArray<T> result;
  T* to = result.extend(per_element * numbers.size());
  for (size_t owner = 0; owner < answers.size(); ++owner) {
    for (size_t i = cuts[rank]; owner == rank && i < cuts[rank + 1]; ++i)
      std::memcpy(to + per_element * i, &own[per_element * size_t(numbers[i] - firsts[rank])], bytes);
    if (!answers[owner].empty())
      std::memcpy(to + per_element * cuts[owner], answers[owner].data(), 4 * answers[owner].size());
    answers[owner] = {};
  }
  return result;
}

template GrowingArray<float> fetch_elements(const std::vector<uint32_t>&, GrowingArray<float>, size_t,
                                            const std::vector<uint64_t>&, const Ranks&);
template GrowingArray<double> fetch_elements(const std::vector<uint32_t>&, GrowingArray<double>, size_t,
                                             const std::vector<uint64_t>&, const Ranks&);

} // namespace softgl::cli
