#include "options/help_page.h"

#include <sstream>

namespace softgl::cli {
namespace {

constexpr size_t kTextColumn = 23;

// A name on the left, its text on the right; a long name has a line of its own.
std::string entry(const std::string& name, const std::string& text) {
  std::string line = "  " + name;
  line += line.size() + 2 > kTextColumn ? "\n" + std::string(kTextColumn, ' ')
                                        : std::string(kTextColumn - line.size(), ' ');
  return line + wrapped(text, kHelpWidth - kTextColumn, kTextColumn) + "\n";
}

std::string label_of(const OptionRow& option) {
  std::string label = main_name(option);
  if (option.names.front() != label) label = option.names.front() + ", " + label;
  return option.value.empty() ? label : label + " " + option.value;
}

std::string operand_label(const OptionRow& operand) {
  const std::string label = operand.value + (operand.many ? "..." : "");
  return operand.required ? label : "[" + label + "]";
}

std::string usage(const CommandRow& command) {
  std::string text =
      "Usage: " + command.program + " " + (command.word.empty() ? "" : command.word + " ") + "[OPTIONS]";
  for (const OptionRow& operand : command.operands) text += " " + operand_label(operand);
  text += "\n";
  return command.commands.empty() ? text : text + "       " + command.program + " COMMAND --help\n";
}

} // namespace

std::string wrapped(const std::string& text, size_t width, size_t indent) {
  std::istringstream words(text);
  std::string result;
  size_t column = 0;
  for (std::string word; words >> word;) {
    if (column > 0 && column + 1 + word.size() > width) {
      result += "\n" + std::string(indent, ' ');
      column = 0;
    } else if (column > 0) {
      result += " ";
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result;
}

std::string help_page(const CommandRow& command) {
  std::string page = wrapped(command.text, kHelpWidth, 0) + "\n" + usage(command) + "\n";
  for (const OptionRow& operand : command.operands)
    page += entry(operand.value + (operand.many ? " ..." : ""), operand.text);
  std::string group;
  for (const OptionRow& option : command.options) {
    if (option.group != group) page += option.group + ":\n";
    group = option.group;
    page += entry(label_of(option), option.text);
  }
  if (command.takes_program_options) page += "and the options of a picture: softgl --help\n";
  if (!command.commands.empty()) page += "Commands:\n";
  for (const CommandRow& each : command.commands)
    page += entry(each.word, each.text.substr(0, each.text.find(';')));
  if (!command.examples.empty()) page += "\nExamples:\n";
  for (const std::string& example : command.examples) page += "  " + example + "\n";
  std::istringstream paragraphs(command.notes);
  if (!command.notes.empty()) page += "\n";
  for (std::string paragraph; std::getline(paragraphs, paragraph);)
    page += wrapped(paragraph, kHelpWidth, 0) + "\n";
  return page;
}

} // namespace softgl::cli
