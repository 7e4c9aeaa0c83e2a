// Settings for what the command line does not say.
#pragma once

#include <string>

#include <CLI/App.hpp>

namespace softgl::cli {

// After parsing: the command line comes first, then the environment, then the file, which is `config` if the
// command line names it. Throws ProgramError.
void take_settings(CLI::App& app, const std::string& config);

// CLI11's sentence about a mistake.
std::string one_line(std::string sentence);

} // namespace softgl::cli
