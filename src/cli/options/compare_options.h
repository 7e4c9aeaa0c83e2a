// The options of `softgl compare`.
#pragma once

#include <CLI/App.hpp>

#include "options/program_options.h"

namespace softgl::cli {

CLI::App* add_compare(CLI::App& app, CompareOptions& options);

} // namespace softgl::cli
