// The options of a run that draws more than one picture.
#pragma once

#include <CLI/App.hpp>

#include "options/program_options.h"

namespace softgl::cli {

void add_many(CLI::App& app, ProgramOptions& options);

// After parsing: a sentence about a mistake, or nothing. The format is known. Sets how values are drawn for
// it.
std::string complete_many(ProgramOptions& options);

} // namespace softgl::cli
