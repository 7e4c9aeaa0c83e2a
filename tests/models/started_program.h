// The softgl program while it runs.
#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace softgl::test {

// What it says goes to a file. It is killed at the end of its scope.
class StartedProgram {
public:
  // `limits`: commands for a shell before it, such as "ulimit -v 1000000;".
  explicit StartedProgram(const std::vector<std::string>& arguments, const std::string& limits = {});
  ~StartedProgram();
  StartedProgram(const StartedProgram&) = delete;
  StartedProgram& operator=(const StartedProgram&) = delete;

  std::vector<pid_t> children() const;
  void send_to_all(int signal) const; // and to its children
  bool has_ended();
  // The exit code, or 128 and the signal that ended it.
  int wait();
  std::string errors() const;

private:
  std::string errors_;
  pid_t process_ = 0, group_ = 0;
  int status_ = 0;
};

} // namespace softgl::test
