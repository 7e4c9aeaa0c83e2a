// Plays scripts on the GL under test in a process of its own, which may crash, hang or lie.
#pragma once

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
  int depth_bits = 0, stencil_bits = 0;
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

/// Each script gets a new context. Never throws for what the GL does.
ChildResult run_in_child(const SubjectName& subject, const std::vector<Script>& scripts, double seconds);

} // namespace softgl::suite
