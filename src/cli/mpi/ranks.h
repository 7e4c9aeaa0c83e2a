// The processes of a run, as MPI numbers them. The only file that calls MPI is ranks.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "common/program_error.h"

namespace softgl::cli {

// A failure that every rank knows of: one of them says it.
struct SharedError : ProgramError {
  using ProgramError::ProgramError;
};

// All ranks call each function in the same order, but for those that say otherwise. Made once.
class Ranks {
public:
  Ranks();  // MPI begins
  ~Ranks(); // and ends
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int count() const { return count_; }
  bool is_first() const { return rank_ == 0; }
  int on_this_machine() const { return on_this_machine_; }

  // Work without calls to other ranks. If it throws on any, SharedError is thrown on all of them: what the
  // lowest of those ranks has to say.
  void together(const std::function<void()>& work) const;
  // Ends all ranks, whatever they do. One rank alone may call.
  [[noreturn]] void abort(int code) const;

  // Each value becomes the largest of all ranks.
  void largest(double* values, size_t count) const;
  uint64_t largest(uint64_t value) const;
  void add(std::vector<int64_t>& values) const; // each becomes the sum of all ranks'
  uint64_t sum(uint64_t value) const;
  uint64_t sum_before(uint64_t value) const; // of the lower ranks
  bool any(bool value) const { return largest(uint64_t(value)) != 0; }

  // The first rank's.
  std::string broadcast(std::string text) const;
  // By rank; empty but at the first one.
  std::vector<std::string> gather(const std::string& text) const;
  std::vector<std::string> gather_everywhere(const std::string& text) const;

  // Words between some ranks. Fewer than 2^31 words to each.
  struct Message {
    int rank; // to or from
    std::vector<uint32_t> words;
  };
  // Sends all, and takes one from each of `senders`, in any order.
  void exchange(const std::vector<Message>& messages, const std::vector<int>& senders,
                const std::function<void(const Message&)>& take) const;

  // To every rank the words that stand at its place, and from every rank those for this one.
  std::vector<std::vector<uint32_t>> swap(std::vector<std::vector<uint32_t>> words) const;

  // What this rank has sent in exchange() and swap(), for --verbose.
  uint64_t sent_bytes() const { return sent_bytes_; }
  uint64_t sent_messages() const { return sent_messages_; }

private:
  int rank_ = 0, count_ = 1, on_this_machine_ = 1;
  mutable uint64_t sent_bytes_ = 0, sent_messages_ = 0;
};

} // namespace softgl::cli
