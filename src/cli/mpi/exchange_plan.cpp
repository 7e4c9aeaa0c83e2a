#include "mpi/exchange_plan.h"

#include <algorithm>

namespace softgl::cli {
namespace {

constexpr int kLargestPrime = 7;
constexpr size_t kSmallPicture = size_t(1) << 18; // samples, 3 MB of messages

// Prime factors, the largest first; empty if one is too large.
std::vector<int> prime_factors(int number) {
  std::vector<int> factors;
  for (const int prime : {7, 5, 3, 2})
    for (; number % prime == 0; number /= prime) factors.push_back(prime);
  if (number > 1) factors.clear();
  return factors;
}

// Factors that stand together are multiplied while the product is no larger than `most`.
std::vector<int> joined(const std::vector<int>& factors, int most) {
  std::vector<int> radices;
  for (const int factor : factors)
    if (!radices.empty() && radices.back() * factor <= most)
      radices.back() *= factor;
    else
      radices.push_back(factor);
  return radices;
}

Piece part_of(Piece piece, size_t number, size_t count) {
  const size_t size = piece.last - piece.first;
  return {piece.first + size * number / count, piece.first + size * (number + 1) / count};
}

} // namespace

ExchangePlan::ExchangePlan(int ranks, size_t samples, int radix) : samples_(samples), active_(ranks) {
  std::vector<int> factors;
  while (active_ > 1 && (factors = prime_factors(active_)).empty()) --active_;
  if (radix == 0) radix = samples <= kSmallPicture ? kLargestPrime + 1 : 2;
  radices_ = joined(factors, radix);
}

ExchangePlan::Step ExchangePlan::step(int rank, size_t round) const {
  Piece piece{0, samples_};
  int stride = 1;
  for (size_t r = 0; r < round; ++r) {
    const int radix = radices_[r];
    piece = part_of(piece, size_t(rank / stride % radix), size_t(radix));
    stride *= radix;
  }
  const int radix = radices_[round], own = rank / stride % radix;
  Step step;
  step.own = size_t(own);
  for (int i = 0; i < radix; ++i) {
    step.members.push_back(rank + (i - own) * stride);
    step.pieces.push_back(part_of(piece, size_t(i), size_t(radix)));
  }
  return step;
}

Piece ExchangePlan::final_piece(int rank) const {
  if (rank >= active_) return {0, 0};
  if (radices_.empty()) return {0, samples_};
  const Step last = step(rank, rounds() - 1);
  return last.pieces[last.own];
}

} // namespace softgl::cli
