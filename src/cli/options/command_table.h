// What the command line takes, as a table: help, man pages, completions and tests all read this one.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace softgl::cli {

// Stands for all others in a list of values.
constexpr const char* kOtherValues = "...";

struct OptionRow {
  std::vector<std::string> names; // with their dashes, short ones first; of an operand its only name, without
  std::string group;              // heading in --help
  std::string value;              // what the help calls its value, such as DEG; empty: takes none
  std::vector<std::string> choices; // values to offer
  bool any_value = true;            // there are values beside the choices
  std::string text;
  bool required = false;
  bool many = false; // an operand that may come several times
  bool list = false; // several choices with commas between them
  bool file = false; // the value is a file's name
};

struct CommandRow {
  std::string program = "softgl";
  std::string word; // "info"; empty: the program itself
  std::string text;
  std::vector<OptionRow> operands, options; // options in the order of the help, without the program's own
  bool takes_program_options = false;       // and all options of the program
  std::vector<std::string> examples;        // commands for a shell
  std::string notes;                        // what the help says below, in paragraphs
  std::vector<CommandRow> commands;
};

// The name that the help shows: the first long one.
const std::string& main_name(const OptionRow& option);

CommandRow describe(const CLI::App& app);

} // namespace softgl::cli
