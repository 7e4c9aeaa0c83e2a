// One stream, played while the k-th allocation fails, and what must hold afterwards.
#pragma once

#include <cstdint>
#include <string>

#include "faults/failing_malloc.h"
#include "faults/streams.h"

namespace softgl::test {

struct Episode {
  Stream stream;
  uint64_t seed = 1;
  uint64_t k = 0; // 0: nothing fails
  bool persistent = false;
  const LiveMemory* usual = nullptr; // what is left where nothing fails; null: not known yet
};

struct Outcome {
  uint64_t calls = 0, failed = 0;
  uint64_t result = 0;        // of the stream while memory ended
  bool out_of_memory = false; // and it said so
  bool disorderly = false;    // pictures of the stream say nothing
  uint64_t frame = 0;         // the reference frame drawn after it
  uint64_t again = 0;         // of the stream, played once more
  bool again_out_of_memory = false;
  LiveMemory left;        // after the contexts are gone
  char failure[200] = {}; // what went wrong on the way; empty: nothing
};

/// Plays an episode in this process.
Outcome play(const Gl& gl, const Episode& episode);
/// What is wrong with an outcome, in words; empty: nothing.
std::string judge(const Outcome& outcome, const Outcome& without_failure);

} // namespace softgl::test
