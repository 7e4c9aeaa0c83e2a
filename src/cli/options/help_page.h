// --help: a page that fits a screen.
#pragma once

#include <string>

#include "options/command_table.h"

namespace softgl::cli {

constexpr size_t kHelpWidth = 100; // columns

std::string help_page(const CommandRow& command);

// Lines of at most `width` columns, those after the first indented.
std::string wrapped(const std::string& text, size_t width, size_t indent);

} // namespace softgl::cli
