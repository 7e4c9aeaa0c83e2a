#include "options/settings.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <unistd.h>

#include "common/program_error.h"
#include "common/source_text.h"

extern char** environ;

namespace softgl::cli {
namespace {

constexpr std::string_view kPrefix = "SOFTGL_OPT_";

[[noreturn]] void refuse_setting(const std::string& where, const std::string& sentence) {
  throw ProgramError(kUsageError, where + ": " + sentence);
}

bool has(const CommandRow& command, const std::string& option) {
  if (option == "--config" || option == "--help" || option == "--version") return false;
  return std::any_of(command.options.begin(), command.options.end(),
                     [&](const OptionRow& row) { return main_name(row) == option; });
}

const CommandRow* find(const CommandRow& program, const std::string& word) {
  if (word.empty()) return &program;
  const auto found = std::find_if(program.commands.begin(), program.commands.end(),
                                  [&](const CommandRow& command) { return command.word == word; });
  return found == program.commands.end() ? nullptr : &*found;
}

// Takes what is for one command.
class Collector {
public:
  Collector(const CommandRow& program, const std::string& word)
      : program_(program), command_(*find(program, word)) {}

  // A part of the file for one command alone.
  void enter(const std::string& word, const std::string& where) {
    section_ = find(program_, word);
    if (!section_ || word.empty()) refuse_setting(where, "there is no command \"" + word + "\"");
  }

  void add(const std::string& option, const std::string& value, const std::string& where) {
    const bool known = section_ ? takes(*section_, option) : anybody_takes(option);
    if (!known) refuse_setting(where, "there is no option " + option);
    if ((section_ && section_ != &command_) || !takes(command_, option)) return;
    const auto same = std::find_if(settings_.begin(), settings_.end(),
                                   [&](const Setting& setting) { return setting.option == option; });
    Setting& setting = same == settings_.end() ? settings_.emplace_back() : *same;
    setting.option = option;
    setting.where = where;
    setting.values.push_back(value);
  }

  std::vector<Setting> take() { return std::move(settings_); }

private:
  bool takes(const CommandRow& command, const std::string& option) const {
    return has(command, option) || (command.takes_program_options && has(program_, option));
  }
  bool anybody_takes(const std::string& option) const {
    return has(program_, option) ||
           std::any_of(program_.commands.begin(), program_.commands.end(),
                       [&](const CommandRow& command) { return has(command, option); });
  }

  const CommandRow& program_;
  const CommandRow& command_;
  const CommandRow* section_ = nullptr;
  std::vector<Setting> settings_;
};

bool is_setting(std::string_view variable) {
  return variable.substr(0, kPrefix.size()) == kPrefix && variable.rfind("SOFTGL_OPT_CONFIG=", 0) != 0;
}

std::string_view trimmed(std::string_view text) {
  constexpr const char* kBlanks = " \t\r\xef\xbb\xbf";
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

void read_line(std::string_view line, const std::string& where, Collector& collector) {
  line = trimmed(line);
  if (line.empty() || line[0] == '#') return;
  if (line[0] == '[') {
    if (line.back() != ']') refuse_setting(where, "a part begins with [COMMAND]");
    return collector.enter(std::string(line.substr(1, line.size() - 2)), where);
  }
  const size_t equal = std::min(line.find('='), line.size());
  const std::string_view name = trimmed(line.substr(0, equal));
  if (name.empty() || name.find_first_of(" \t-") == 0 || name.find_first_of(" \t") != std::string_view::npos)
    refuse_setting(where, "a setting is NAME = VALUE, without dashes before the name");
  const std::string value(equal == line.size() ? "true" : trimmed(line.substr(equal + 1)));
  collector.add("--" + std::string(name), value, where);
}

} // namespace

bool has_environment_settings() {
  for (char** variable = environ; *variable; ++variable)
    if (is_setting(*variable)) return true;
  return false;
}

std::vector<Setting> environment_settings(const CommandRow& program, const std::string& word) {
  Collector collector(program, word);
  for (char** variable = environ; *variable; ++variable) {
    const std::string_view text = *variable;
    if (!is_setting(text)) continue;
    const size_t equal = std::min(text.find('='), text.size());
    std::string option = "--";
    for (const char c : text.substr(kPrefix.size(), equal - kPrefix.size()))
      option += c == '_' ? '-' : c >= 'A' && c <= 'Z' ? char(c + 32) : c;
    const std::string value(text.substr(std::min(equal + 1, text.size())));
    collector.add(option, value, std::string(text.substr(0, equal)));
  }
  return collector.take();
}

std::vector<Setting> file_settings(const std::string& path, const CommandRow& program,
                                   const std::string& word) {
  constexpr size_t kMostBytes = 1 << 20;
  try {
    const SourceText text = SourceText::open_named(path);
    if (text.size() > kMostBytes) throw ProgramError(kUsageError, path + ": too large for settings");
    Collector collector(program, word);
    std::string_view rest(text.begin(), text.size());
    for (size_t number = 1; !rest.empty(); ++number) {
      const size_t end = std::min(rest.find('\n'), rest.size());
      read_line(rest.substr(0, end), path + ":" + std::to_string(number), collector);
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return collector.take();
  } catch (const ProgramError& error) { throw ProgramError(kUsageError, error.what()); }
}

std::string default_settings_file() {
  const char* folder = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  std::string path;
  if (folder && *folder)
    path = std::string(folder) + "/softgl/config";
  else if (home && *home)
    path = std::string(home) + "/.config/softgl/config";
  return !path.empty() && ::access(path.c_str(), F_OK) == 0 ? path : std::string();
}

} // namespace softgl::cli
