// A program whose calls the library writes to a trace (SOFTGL_TRACE).
#pragma once

#include <functional>
#include <string>

#include "support/gl.h"

namespace softgl::test {

struct TracedRun {
  int status = -1;    // as waitpid gives it
  std::string trace;  // the file
  std::string errors; // what came to standard error
};

/// Calls `program` in a child process with a library of its own, which opens the trace as it is loaded.
/// `file`: the value of SOFTGL_TRACE; empty: one that is read and removed afterwards.
TracedRun run_traced(const std::function<void(const Gl&)>& program, const std::string& file = {});

/// The trace without what differs from run to run: pointers become POINTER, times and amounts of memory N,
/// and the first line and the names of fast paths go.
std::string comparable_trace(const std::string& trace);

} // namespace softgl::test
