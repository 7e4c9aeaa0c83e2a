#include "options/taken_settings.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "common/program_error.h"
#include "options/option_kinds.h"
#include "options/settings.h"

namespace softgl::cli {
namespace {

void take_setting(const Setting& setting, CLI::Option& option) {
  if (option.count() > 0) return;
  try {
    const bool flag = option.get_expected_min() == 0;
    const bool many = option.get_expected_max() > 1;
    for (const std::string& value : setting.values)
      if (flag && &value == &setting.values.back())
        option.add_result(option.get_flag_value(option.get_name(), value));
      else if (!flag && (many || &value == &setting.values.back()))
        option.add_result(value);
    option.run_callback();
  } catch (const CLI::Error& mistake) {
    std::string sentence = one_line(mistake.what());
    if (sentence.find(setting.option) == std::string::npos) sentence = setting.option + ": " + sentence;
    throw ProgramError(kUsageError, setting.where + ": " + sentence);
  }
}

} // namespace

void take_settings(CLI::App& app, const std::string& config) {
  const std::vector<CLI::App*> active = app.get_subcommands();
  CLI::App& command = active.empty() ? app : *active.front();
  const CLI::Option* own = command.get_option_no_throw("--config");
  const bool named = (own && own->count() > 0) || app.count("--config") > 0;
  const char* variable = std::getenv("SOFTGL_OPT_CONFIG");
  const std::string file = named ? config : variable ? variable : default_settings_file();
  if (file.empty() && !has_environment_settings()) return;
  const CommandRow program = describe(app);
  const std::string word = active.empty() ? "" : command.get_name();
  const auto take = [&](const std::vector<Setting>& settings) {
    for (const Setting& setting : settings) {
      CLI::Option* option = command.get_option_no_throw(setting.option);
      take_setting(setting, option ? *option : *app.get_option(setting.option));
    }
  };
  take(environment_settings(program, word));
  if (!file.empty()) take(file_settings(file, program, word));
}

std::string one_line(std::string sentence) {
  std::replace(sentence.begin(), sentence.end(), '\n', ' ');
  return sentence;
}

} // namespace softgl::cli
