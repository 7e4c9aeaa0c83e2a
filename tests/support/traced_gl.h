// A library whose calls are numbered, printed and left out at will: how a failing scene is cut down to a few
// calls.
#pragma once

#include <cstdio>
#include <vector>

#include "support/gl.h"

namespace softgl::test {

struct CallFilter {
  const std::vector<bool>* skip = nullptr; // by call number; calls beyond its end are made
  FILE* print = nullptr;                   // one line for each call that is made
  int next = 0;                            // number of the next call
  bool in_list = false, in_primitive = false;
  bool primitive_skipped = false; // between a Begin that was left out and its End
  bool cleared = false;           // the first Clear was called
};

/// A table whose functions obey `filter` and call `real`. One at a time, on one thread; OSMesa functions,
/// GetError and Finish are always called and not numbered. Both arguments must outlive its use.
Gl traced(const Gl& real, CallFilter& filter);

} // namespace softgl::test
