// The table of options, and shells that read what is made of it.
#pragma once

#include <string>
#include <vector>

#include "clients/client_runs.h" // has_program()
#include "options/command_line.h"

namespace softgl::test {

// The program first, then its commands.
std::vector<cli::CommandRow> all_commands();

// The command's options, and those of the program where it takes them.
std::vector<cli::OptionRow> options_of(const cli::CommandRow& command);

// "softgl" or "softgl info".
std::string words_of(const cli::CommandRow& command);

// Of the build, below the folder share.
std::string shared_file(const std::string& name);

// What /bin/sh -c prints, errors as well.
struct ShellRun {
  int code = -1;
  std::string output;
};
ShellRun run_shell(const std::string& command);

std::vector<std::string> text_lines(const std::string& text);

} // namespace softgl::test
