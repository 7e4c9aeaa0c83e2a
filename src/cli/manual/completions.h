// What shells read to complete a command line.
#pragma once

#include <string>

#include "options/command_table.h"

namespace softgl::cli {

std::string bash_completion(const CommandRow& program);
std::string zsh_completion(const CommandRow& program);
std::string fish_completion(const CommandRow& program);

// A word between apostrophes, as all three shells read it.
std::string in_apostrophes(const std::string& text);

} // namespace softgl::cli
