// Who sends which piece of the picture to whom, so that in the end each rank has one piece of all ranks'
// samples.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace softgl::cli {

// Half open.
struct Piece {
  size_t first = 0, last = 0;
};

// Radix-k compositing. In each round groups of k ranks cut their common piece into k, and each collects one
// of them. With k = 2 this is binary swap. Ranks beyond the largest number whose prime factors are at most 7
// first give all they have to another rank.
class ExchangePlan {
public:
  // `radix`: most ranks of a group; 0: chosen by the number of samples. Small pictures take fewer rounds,
  // large ones less memory for what is on its way.
  ExchangePlan(int ranks, size_t samples, int radix = 0);

  // Ranks that take part in the rounds; the others give their samples to the rank that is so much lower.
  int active() const { return active_; }
  size_t rounds() const { return radices_.size(); }

  struct Step {
    std::vector<int> members;  // of the rank's group, itself included
    std::vector<Piece> pieces; // of each member
    size_t own;                // place of the rank among them
  };
  Step step(int rank, size_t round) const;
  // What the rank has in the end.
  Piece final_piece(int rank) const;

private:
  size_t samples_;
  int active_;
  std::vector<int> radices_;
};

} // namespace softgl::cli
