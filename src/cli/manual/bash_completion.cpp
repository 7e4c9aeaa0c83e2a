#include "manual/completions.h"

namespace softgl::cli {

std::string in_apostrophes(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

namespace {

// What the shell gets to know about an option: how to complete its value.
std::string value_case(const OptionRow& option) {
  if (option.value.empty()) return {};
  std::string names, choices;
  for (const std::string& name : option.names) names += (names.empty() ? "" : "|") + name;
  for (const std::string& choice : option.choices) choices += (choices.empty() ? "" : " ") + choice;
  const char* kind = option.file ? "file" : option.list ? "list" : "word";
  return "    " + names + ") kind=" + kind + " choices=" + in_apostrophes(choices) + " ;;\n";
}

std::string names_of(const CommandRow& command) {
  std::string names;
  for (const OptionRow& option : command.options)
    for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  return names;
}

// Looks at the line itself: the shell cuts words at = and :, and values have both.
constexpr const char* kHead = R"(# bash completion for softgl; written by its build

_softgl_command() {
  local word
  command=
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $word in
)";

constexpr const char* kMiddle = R"(    esac
  done
}

# Words of $1 that continue $2.
_softgl_offer() {
  local word
  for word in $1; do
    case $word in "$2"*) COMPREPLY+=("$word") ;; esac
  done
}

_softgl_files() {
  compopt -o filenames 2> /dev/null
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$1")
}

_softgl() {
)";

constexpr const char* kBody =
    R"(  local command kind= choices= options= option prefix= before cut= breaks= choice done=
  local line=${COMP_LINE:0:COMP_POINT}
  local typed=${line##*[[:space:]]}
  local word=$typed
  read -r -a before <<< "${line%"$typed"}"
  option=${before[${#before[@]}-1]}
  case $word in --*=*) option=${word%%=*}; prefix=$option=; word=${word#*=} ;; esac
  COMPREPLY=()
  _softgl_command
  case $command in
)";

constexpr const char* kTail = R"(  esac
  case $kind in
  file) _softgl_files "$word" ;;
  list)
    case $word in *,*) done=${word%,*}, ;; esac
    for choice in $choices; do
      case $done$choice in "$word"*) COMPREPLY+=("$done$choice") ;; esac
    done ;;
  word) _softgl_offer "$choices" "$word" ;;
  *)
    case $word in
    -*) _softgl_offer "$options" "$word" ;;
    *)
      [ "$command" ] || _softgl_offer "$commands" "$word"
      _softgl_files "$word" ;;
    esac ;;
  esac
  # The shell puts in what follows the last of its own cuts.
  [ "$prefix" ] && COMPREPLY=("${COMPREPLY[@]/#/$prefix}")
  case $COMP_WORDBREAKS in *=*) breaks+='=' ;; esac
  case $COMP_WORDBREAKS in *:*) breaks+=':' ;; esac
  [ "$breaks" ] && cut=${typed%"${typed##*[$breaks]}"}
  COMPREPLY=("${COMPREPLY[@]#"$cut"}")
}
complete -F _softgl softgl
)";

} // namespace

std::string bash_completion(const CommandRow& program) {
  std::string text = kHead, words;
  for (const CommandRow& command : program.commands) {
    text += "    " + command.word + ") command=" + command.word + "; return ;;\n";
    words += (words.empty() ? "" : " ") + command.word;
  }
  text += kMiddle + ("  local commands=" + in_apostrophes(words)) + "\n" + kBody;
  const auto add = [&text](const char* pattern, const CommandRow& command, const CommandRow* more) {
    text += std::string("  ") + pattern + ")\n    options=" +
            in_apostrophes(names_of(command) + (more ? " " + names_of(*more) : std::string())) +
            "\n    case $option in\n";
    for (const OptionRow& option : command.options) text += value_case(option);
    for (const OptionRow& option : more ? more->options : std::vector<OptionRow>())
      text += value_case(option);
    text += "    esac ;;\n";
  };
  for (const CommandRow& command : program.commands)
    add(command.word.c_str(), command, command.takes_program_options ? &program : nullptr);
  add("*", program, nullptr);
  return text + kTail;
}

} // namespace softgl::cli
