// Plays scripts on the GL under test in a process of its own, which may crash, hang or lie.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "expect/expectation.h"
#include "gl/subject.h"

namespace softgl::suite {

/// What the GL says of itself.
struct SubjectFacts {
  std::string vendor, renderer, version, extensions;
  int version_number = 0; // 15 for 1.5
  Precision precision;
  int depth_bits = 0, stencil_bits = 0, accumulation_bits = 0;
};

struct DrawnPicture {
  std::vector<uint8_t> color; // RGBA, rows from below
  std::string fault;          // empty if a picture came out: a missing function, GL errors
};

struct ChildResult {
  std::string fault; // of the whole process: no context, a signal, out of time. Empty: the pictures are there
  SubjectFacts facts;
  std::vector<DrawnPicture> pictures; // one a script; those that were not reached have a fault
};

/// A child that draws. Nothing throws for what the GL does.
class RunningChild {
public:
  /// Starts it. Each script gets a new context. The time for all of them begins now.
  RunningChild(const SubjectName& subject, const std::vector<Script>& scripts, double seconds);
  RunningChild(const RunningChild&) = delete;
  RunningChild& operator=(const RunningChild&) = delete;
  /// Kills it if it still runs.
  ~RunningChild();
  /// Waits for its end, or for that of its time.
  ChildResult finish();

private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Starts a child and waits for it.
ChildResult run_in_child(const SubjectName& subject, const std::vector<Script>& scripts, double seconds);

} // namespace softgl::suite
