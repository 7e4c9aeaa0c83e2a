// A failure as a program of C that anyone can build and run, without the suite.
#pragma once

#include <string>

#include "run/results.h"

namespace softgl::suite {

/// What a failure may cost: pictures that are drawn.
constexpr int kMinimizerScripts = 600;

/// Whether the fault of a picture is a wrong error or answer, which a program of C can show.
bool is_wrong_answer(const std::string& fault);

struct Minimized {
  Script script;
  Verdict verdict;
  std::string fault;        // in place of the verdict, if an error or an answer is wrong
  bool fails_again = false; // else the script is whole, and there is no verdict
  bool is_minimal =
      false; // without any one of its calls it does not fail; false if the budget was over before
};
/// Cuts the script down to the calls that the failure needs: the picture still differs from what is expected.
Minimized minimized(const Script& script, const RunOptions& options, const SubjectFacts& facts);

/// A program that draws the script, reads the pixel of the verdict, says what it is and what it should be,
/// and ends with 1 if it is wrong. Without a verdict it does so with errors and answers. `name` is its file
/// without ".c"; `note`: lines of a comment.
std::string c_program(const Test& test, const Script& script, const Verdict* verdict, const std::string& name,
                      const SubjectName& subject, const std::string& note);

} // namespace softgl::suite
