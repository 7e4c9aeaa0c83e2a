// Options from the environment and from a file, for what the command line does not say.
#pragma once

#include <string>
#include <vector>

#include "options/command_table.h"

namespace softgl::cli {

// One option's values, as they would follow it on the command line.
struct Setting {
  std::string option;              // with its dashes
  std::vector<std::string> values; // the last counts, but for options that may come several times
  std::string where;               // for messages: a variable, or FILE:LINE of the last value
};

// Of all settings those that the command has. `word` is empty for the program itself. Throws ProgramError
// (kUsageError) for names that no command has, for lines that are none, and where the file cannot be read.

// Variables whose names begin with SOFTGL_OPT_: SOFTGL_OPT_LINE_WIDTH=2 is --line-width 2.
// SOFTGL_OPT_CONFIG is not one of them.
bool has_environment_settings();
std::vector<Setting> environment_settings(const CommandRow& program, const std::string& word);

// Lines NAME = VALUE, or NAME alone for an option without a value; [COMMAND] begins a part for that command
// alone. Lines that begin with # are comments.
std::vector<Setting> file_settings(const std::string& path, const CommandRow& program,
                                   const std::string& word);

// The user's own file; empty if there is none.
std::string default_settings_file();

} // namespace softgl::cli
