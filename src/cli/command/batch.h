// All pictures of a run, drawn by as many threads as there are.
#pragma once

#include "command/options.h"

namespace softgl::cli {

// Reads each model once. Messages go to standard error, by model. Returns the exit code; throws ProgramError
// for what ends the run.
int draw_pictures(const ProgramOptions& options, unsigned threads);

} // namespace softgl::cli
