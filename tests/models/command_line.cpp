#include "models/command_line.h"

#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>

#include "models/program_runner.h"
#include "test_paths.h"

namespace softgl::test {

std::vector<cli::CommandRow> all_commands() {
  const cli::CommandRow program = cli::describe_command_line();
  std::vector<cli::CommandRow> all = {program};
  all.insert(all.end(), program.commands.begin(), program.commands.end());
  return all;
}

std::vector<cli::OptionRow> options_of(const cli::CommandRow& command) {
  std::vector<cli::OptionRow> options = command.options;
  const cli::CommandRow program = cli::describe_command_line();
  if (command.takes_program_options && !command.word.empty())
    options.insert(options.end(), program.options.begin(), program.options.end());
  return options;
}

std::string words_of(const cli::CommandRow& command) {
  return command.word.empty() ? "softgl" : "softgl " + command.word;
}

std::string shared_file(const std::string& name) {
  const std::string path = std::string(SOFTGL_TEST_BINARY_DIR) + "/../share/" + name;
  if (read_bytes(path).empty()) throw std::runtime_error("the build has no " + path);
  return path;
}

ShellRun run_shell(const std::string& command) {
  FILE* pipe = ::popen(("export XDG_CONFIG_HOME=/nonexistent; exec 2>&1; " + command).c_str(), "r");
  if (!pipe) throw std::runtime_error("no shell");
  ShellRun run;
  for (char part[4096]; const size_t count = std::fread(part, 1, sizeof part, pipe);)
    run.output.append(part, count);
  const int status = ::pclose(pipe);
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return run;
}

std::vector<std::string> text_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

} // namespace softgl::test
