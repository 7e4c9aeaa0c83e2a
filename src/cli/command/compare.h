// `softgl compare`: two pictures, or the pictures of two folders.
#pragma once

#include "options/program_options.h"

namespace softgl::cli {

// Prints to standard output and returns the exit code: kSuccess, or kDiffers.
int run_compare(const CompareOptions& options);

} // namespace softgl::cli
