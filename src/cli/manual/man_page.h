// A command's man page, as text for roff's macros man(7).
#pragma once

#include <string>

#include "options/command_table.h"

namespace softgl::cli {

std::string man_page(const CommandRow& program, const CommandRow& command);

} // namespace softgl::cli
