#include "manual/completions.h"

namespace softgl::cli {
namespace {

std::string line(const OptionRow& option, const std::string& condition) {
  std::string text = "complete -c softgl -n " + in_apostrophes(condition);
  for (const std::string& name : option.names)
    text += name.rfind("--", 0) == 0 ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.value.empty()) text += option.file ? " -r -F" : " -x";
  std::string choices;
  for (const std::string& choice : option.choices) choices += (choices.empty() ? "" : " ") + choice;
  if (option.list)
    text += " -a " + in_apostrophes("(__fish_append , " + choices + ")");
  else if (!choices.empty())
    text += " -a " + in_apostrophes(choices);
  return text + " -d " + in_apostrophes(option.text) + "\n";
}

} // namespace

std::string fish_completion(const CommandRow& program) {
  std::string text = "# fish completion for softgl; written by its build\n", all, own;
  for (const CommandRow& command : program.commands) {
    all += " " + command.word;
    if (!command.takes_program_options) own += " " + command.word;
  }
  for (const CommandRow& command : program.commands)
    text += "complete -c softgl -n " + in_apostrophes("not __fish_seen_subcommand_from" + all) + " -a " +
            command.word + " -d " + in_apostrophes(command.text) + "\n";
  for (const OptionRow& option : program.options)
    text += line(option, "not __fish_seen_subcommand_from" + own);
  for (const CommandRow& command : program.commands)
    for (const OptionRow& option : command.options)
      text += line(option, "__fish_seen_subcommand_from " + command.word);
  return text;
}

} // namespace softgl::cli
