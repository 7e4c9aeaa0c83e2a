// What `softgl compare` says, to people and to programs.
#pragma once

#include <string>
#include <vector>

#include "image/comparison.h"

namespace softgl::cli {

struct PairResult {
  enum Outcome { kSame, kDifferent, kMissing, kOtherSize, kUnreadable } outcome = kSame;
  std::string name;          // in folders: the path that both share
  std::string first, second; // paths
  std::string sentence;      // why, where there are no numbers
  Comparison numbers;        // without verdicts
  int width = 0, height = 0;
  double seconds = 0;                                              // of the whole
  double read_seconds = 0, compare_seconds = 0, write_seconds = 0; // of its parts
};

std::string as_line(const PairResult& result);
std::string as_label(const PairResult& result); // two short lines about the numbers
std::string as_json(const PairResult& result, const std::string& indent);
// One suite with a case for each pair, as Jenkins and GitLab read it.
std::string as_junit(const std::vector<PairResult>& results);

} // namespace softgl::cli
