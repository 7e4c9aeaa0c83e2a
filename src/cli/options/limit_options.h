// The options for models of unknown origin.
#pragma once

#include <CLI/App.hpp>

#include "options/run_limits.h"

namespace softgl::cli {

void add_limits(CLI::App& app, RunLimits& limits);

} // namespace softgl::cli
