#include "manual/completions.h"

namespace softgl::cli {
namespace {

// Text inside of [] or between colons of _arguments.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string action(const OptionRow& option) {
  if (option.file) return "_files";
  if (option.choices.empty()) return " ";
  std::string words;
  for (const std::string& choice : option.choices) words += (words.empty() ? "" : " ") + choice;
  return option.list ? "_sequence compadd - " + words : "(" + words + ")";
}

std::string specification(const OptionRow& option) {
  std::string others, text;
  for (const std::string& name : option.names) others += (others.empty() ? "" : " ") + name;
  for (const std::string& name : option.names) {
    const bool is_long = name.rfind("--", 0) == 0;
    // A light may come several times.
    std::string line = option.value == "LIGHT" ? "*" : "(" + others + ")";
    line += name + (option.value.empty() ? "" : is_long ? "=" : "+") + "[" + plain(option.text) + "]";
    if (!option.value.empty()) line += ":" + plain(option.value) + ":" + action(option);
    text += "    " + in_apostrophes(line) + "\n";
  }
  return text;
}

std::string specifications(const CommandRow& command) {
  std::string text;
  for (const OptionRow& option : command.options) text += specification(option);
  return text;
}

} // namespace

std::string zsh_completion(const CommandRow& program) {
  std::string text = "#compdef softgl\n# zsh completion for softgl; written by its build\n\n"
                     "_softgl() {\n  local -a specs commands\n  local word command\n  commands=(\n";
  for (const CommandRow& command : program.commands)
    text += "    " + in_apostrophes(command.word + ":" + plain(command.text)) + "\n";
  text += "  )\n  for word in ${words[2,CURRENT-1]}; do\n    case $word in\n";
  for (const CommandRow& command : program.commands)
    text += "    " + command.word + ") command=" + command.word + "; break ;;\n";
  text += "    esac\n  done\n  case $command in\n";
  for (const CommandRow& command : program.commands)
    text += "  " + command.word + ") specs=(\n" + specifications(command) +
            (command.takes_program_options ? specifications(program) : std::string()) + "  ) ;;\n";
  text += "  *) specs=(\n" + specifications(program) + "  ) ;;\n  esac\n";
  return text + "  if [[ -z $command && $words[CURRENT] != -* ]]; then\n"
                "    _arguments -s -S $specs '*:model:->operand' && return\n"
                "    [[ $state == operand ]] && _alternative "
                "'commands:command:{_describe command commands}' 'files:model:_files'\n"
                "    return\n  fi\n  _arguments -s -S $specs '*:file:_files'\n}\n\n_softgl \"$@\"\n";
}

} // namespace softgl::cli
