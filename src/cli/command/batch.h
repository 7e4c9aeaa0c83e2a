// `softgl batch`: many jobs, each in one of several processes.
#pragma once

#include "options/command_line.h"

namespace softgl::cli {

// Returns the exit code; throws ProgramError for what ends the run before a picture is drawn. The process has
// no other thread.
int run_batch(const ProgramOptions& options, const std::vector<GivenOption>& given, unsigned threads);

} // namespace softgl::cli
