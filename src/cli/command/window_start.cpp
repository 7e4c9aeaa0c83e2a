#include "command/window_start.h"

#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

namespace softgl::cli {

void start_window(int argc, const char* const* argv) {
  std::string program = "softgl-view";
  std::vector<char*> words = {program.data()};
  for (int i = 0; i < argc; ++i) words.push_back(const_cast<char*>(argv[i]));
  words.push_back(nullptr);
  std::error_code unknown;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", unknown);
  if (!unknown) ::execv((self.parent_path() / program).c_str(), words.data());
  ::execvp(program.c_str(), words.data());
}

} // namespace softgl::cli
