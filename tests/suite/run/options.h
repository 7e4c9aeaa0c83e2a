// The command line of softgl-conformance.
#pragma once

namespace softgl::suite {

/// With --since and --compare kAllPass says that no test got worse, and kSomeFail that one did.
constexpr int kAllPass = 0, kSomeFail = 1, kUsage = 2, kNoContext = 3;

/// Runs the program; gives the exit status.
int run_suite(int argc, char** argv);

} // namespace softgl::suite
