#include "options/command_table.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <sstream>

namespace softgl::cli {
namespace {

// CLI11 joins what a value is called and the descriptions of its checks: "HOW:{flat,gouraud}". An open list
// of choices ends with dots.
void take_value(const std::string& type, OptionRow& row) {
  const size_t colon = std::min(type.find(":{"), type.size());
  row.value = type.substr(0, colon);
  if (colon == type.size()) return;
  std::istringstream words(type.substr(colon + 2, type.find('}', colon) - colon - 2));
  row.any_value = false;
  for (std::string word; std::getline(words, word, ',');)
    if (word == kOtherValues)
      row.any_value = true;
    else
      row.choices.push_back(word);
}

OptionRow describe(const CLI::Option& option) {
  OptionRow row;
  for (const std::string& name : option.get_snames()) row.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) row.names.push_back("--" + name);
  const bool operand = option.get_positional();
  if (operand) row.names = {option.get_name(true, false)};
  row.group = option.get_group();
  if (option.get_type_size() != 0) take_value(option.get_type_name(), row);
  row.text = option.get_description();
  row.required = option.get_required();
  row.many = operand && option.get_expected_max() > 1;
  row.list = row.value == "LIST";
  row.file = operand || row.value == "FILE";
  return row;
}

void take_footer(const std::string& footer, CommandRow& row) {
  std::istringstream lines(footer);
  bool examples = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "Examples:") {
      examples = true;
    } else if (examples && line.rfind("  ", 0) == 0) {
      row.examples.push_back(line.substr(2));
    } else {
      examples = false;
      if (!line.empty() || !row.notes.empty()) row.notes += line + "\n";
    }
  }
}

} // namespace

const std::string& main_name(const OptionRow& option) {
  const auto is_long = [](const std::string& name) { return name.rfind("--", 0) == 0; };
  const auto found = std::find_if(option.names.begin(), option.names.end(), is_long);
  return found == option.names.end() ? option.names.front() : *found;
}

CommandRow describe(const CLI::App& app) {
  CommandRow row;
  row.word = app.get_parent() ? app.get_name() : "";
  row.text = app.get_description();
  row.takes_program_options = app.get_fallthrough();
  std::vector<OptionRow> general;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    const bool is_general = option == app.get_help_ptr() || option == app.get_version_ptr();
    (option->get_positional() ? row.operands
     : is_general             ? general
                              : row.options)
        .push_back(describe(*option));
  }
  for (OptionRow& each : general) {
    if (!row.options.empty()) each.group = row.options.back().group;
    row.options.push_back(each);
  }
  take_footer(app.get_footer(), row);
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_group().empty()) row.commands.push_back(describe(*command));
  return row;
}

} // namespace softgl::cli
