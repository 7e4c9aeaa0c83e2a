// The options of `softgl batch`.
#pragma once

#include <CLI/App.hpp>

#include "options/program_options.h"

namespace softgl::cli {

CLI::App* add_batch(CLI::App& app, ProgramOptions& options);

// After parsing: a sentence about a mistake, or nothing.
std::string complete_batch(const ProgramOptions& options);

} // namespace softgl::cli
