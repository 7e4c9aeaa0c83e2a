// The command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "options/command_table.h"
#include "options/program_options.h"

namespace softgl::cli {

// An option as the command line has it, by its first long name; a flag has no values.
struct GivenOption {
  std::string name;
  std::vector<std::string> values;
};

// What main() is to do: options, or an end with that exit code (help, version, or a mistake already
// reported).
struct ParsedOptions {
  std::optional<ProgramOptions> options;
  int exit_code = 0;
  std::vector<GivenOption> given = {}; // with `options`, those of a picture, without the models
};

ParsedOptions parse_options(int argc, const char* const* argv);

// The options of one picture, for which there is a command line without the program's name. Of an option that
// comes twice the last counts, but for --light. Throws ProgramError (kUsageError).
ProgramOptions parse_picture(const std::vector<std::string>& words);

// What parse_options() takes.
CommandRow describe_command_line();

} // namespace softgl::cli
