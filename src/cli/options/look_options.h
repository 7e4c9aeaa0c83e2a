// The options of how a picture looks, and where the camera stands.
#pragma once

#include <CLI/App.hpp>

#include "options/program_options.h"

namespace softgl::cli {

void add_look(CLI::App& app, ProgramOptions& options);
void add_camera_place(CLI::App& app, ProgramOptions& options);

// After parsing, with all views: a sentence about a mistake, or nothing.
std::string complete_look(ProgramOptions& options);

} // namespace softgl::cli
