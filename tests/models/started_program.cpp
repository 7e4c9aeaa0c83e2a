#include "models/started_program.h"

#include "models/program_runner.h"
#include "test_paths.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace softgl::test {

StartedProgram::StartedProgram(const std::vector<std::string>& arguments, const std::string& limits) {
  static int number = 0;
  errors_ = output_folder("started") + std::to_string(number++);
  const std::string program = std::string(SOFTGL_TEST_BINARY_DIR) + "/softgl",
                    script = limits + " exec \"$0\" \"$@\"";
  std::vector<std::string> words = {"sh", "-c", script, program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  process_ = ::fork();
  if (process_ != 0) {
    ::setpgid(process_, process_); // whoever is first
    group_ = process_;
    return;
  }
  const int file = ::open(errors_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644),
            nothing = ::open("/dev/null", O_RDWR);
  ::setpgid(0, 0);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(nothing, STDOUT_FILENO);
  ::dup2(file, STDERR_FILENO);
  ::setenv("XDG_CONFIG_HOME", "/nonexistent", 1);
  ::execv("/bin/sh", argv.data());
  ::_exit(127);
}

StartedProgram::~StartedProgram() {
  if (process_ == 0) return;
  send_to_all(SIGKILL);
  wait();
}

std::vector<pid_t> StartedProgram::children() const {
  const std::string process = std::to_string(process_);
  std::istringstream text(read_bytes("/proc/" + process + "/task/" + process + "/children"));
  std::vector<pid_t> all;
  for (pid_t child; text >> child;) all.push_back(child);
  return all;
}

void StartedProgram::send_to_all(int signal) const { ::kill(-group_, signal); }

bool StartedProgram::has_ended() {
  if (process_ != 0 && ::waitpid(process_, &status_, WNOHANG) == process_) process_ = 0;
  return process_ == 0;
}

int StartedProgram::wait() {
  while (process_ != 0 && ::waitpid(process_, &status_, 0) < 0 && errno == EINTR) {}
  process_ = 0;
  return WIFSIGNALED(status_) ? 128 + WTERMSIG(status_) : WEXITSTATUS(status_);
}

std::string StartedProgram::errors() const { return read_bytes(errors_); }

} // namespace softgl::test
