// The options of softgl figure.
#pragma once

#include <CLI/App.hpp>

#include "options/program_options.h"

namespace softgl::cli {

CLI::App* add_figure(CLI::App& app, ProgramOptions& options);
// What follows from them: names and model, what the output is. A sentence about a mistake, or nothing.
std::string complete_figure_output(ProgramOptions& options);

} // namespace softgl::cli
