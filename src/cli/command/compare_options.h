// The options of `softgl compare`.
#pragma once

#include <CLI/App.hpp>

#include "command/compare.h"

namespace softgl::cli {

CLI::App* add_compare(CLI::App& app, CompareOptions& options);

} // namespace softgl::cli
