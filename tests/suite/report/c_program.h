// A failure as a program of C that anyone can build and run, without the suite.
#pragma once

#include <string>

#include "run/results.h"

namespace softgl::suite {

/// Cuts the script down to the calls that the failure needs: the picture still differs from what is expected.
/// The script comes back whole if the failure does not show again.
Script minimized(const Script& script, const RunOptions& options, const SubjectFacts& facts,
                 Verdict* verdict);

/// A program that draws the script, reads the pixel of the verdict, and says what it is and what it should
/// be. It is built with -lOSMesa, or with -DUSE_EGL -lEGL -lGL.
std::string c_program(const Test& test, const Script& script, const Verdict& verdict);

} // namespace softgl::suite
