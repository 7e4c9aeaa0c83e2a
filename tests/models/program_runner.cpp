#include "models/program_runner.h"

#include "test_paths.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <tuple>
#include <unistd.h>

namespace softgl::test {

std::string read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

std::string write_bytes(const std::string& path, const std::string& bytes) {
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

std::string pyramid(int height) {
  return "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 " + std::to_string(height) +
         " 0\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
}

std::string output_folder(const std::string& name) {
  static struct Folders {
    std::set<std::string> made;
    const pid_t process = ::getpid();
    ~Folders() {
      if (::getpid() != process) return;
      for (const std::string& folder : made) {
        std::error_code ignored;
        std::filesystem::remove_all(folder, ignored);
      }
    }
  } folders;
  const std::string folder =
      std::string(SOFTGL_TEST_OUTPUT) + "/" + name + "-" + std::to_string(folders.process) + "/";
  std::filesystem::create_directories(folder);
  folders.made.insert(folder);
  return folder;
}

// Files instead of pipes: no deadlock, whatever the amount.
ProgramRun run_command(const std::vector<std::string>& words, const std::string& input,
                       const std::vector<std::string>& environment) {
  const std::string stem = output_folder("run");
  const std::string paths[3] = {stem + "in", stem + "out", stem + "err"};
  std::ofstream(paths[0], std::ios::binary) << input;
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    const int flags[3] = {O_RDONLY, O_WRONLY | O_CREAT | O_TRUNC, O_WRONLY | O_CREAT | O_TRUNC};
    for (int i = 0; i < 3; ++i) {
      const int file = ::open(paths[i].c_str(), flags[i], 0644);
      if (file < 0 || ::dup2(file, i) < 0) ::_exit(127);
    }
    ::setenv("XDG_CONFIG_HOME", "/nonexistent", 1); // the user's own settings are no matter of the tests
    for (const std::string& variable : environment) ::putenv(const_cast<char*>(variable.c_str()));
    ::execvp(argv[0], argv.data());
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ProgramRun run;
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.output = read_bytes(paths[1]);
  run.errors = read_bytes(paths[2]);
  for (const std::string& path : paths) std::filesystem::remove(path);
  return run;
}

ProgramRun run_softgl(const std::vector<std::string>& arguments, const std::string& input,
                      const std::vector<std::string>& environment) {
  std::vector<std::string> words = {std::string(SOFTGL_TEST_BINARY_DIR) + "/softgl"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_command(words, input, environment);
}

TestPicture parse_ppm(const std::string& bytes) {
  TestPicture picture;
  int used = 0;
  if (std::sscanf(bytes.c_str(), "P6 %d %d 255%n", &picture.width, &picture.height, &used) != 2)
    throw std::runtime_error("not a PPM picture");
  const auto size = size_t(3) * size_t(picture.width) * size_t(picture.height);
  const auto start = size_t(used) + 1;
  if (bytes.size() != start + size) throw std::runtime_error("a PPM picture of the wrong size");
  picture.rgb.assign(bytes.begin() + static_cast<long>(start), bytes.end());
  return picture;
}

TestPicture read_ppm(const std::string& path) { return parse_ppm(read_bytes(path)); }

size_t TestPicture::colors() const {
  std::set<std::tuple<uint8_t, uint8_t, uint8_t>> seen;
  for (size_t i = 0; i < rgb.size(); i += 3) seen.emplace(rgb[i], rgb[i + 1], rgb[i + 2]);
  return seen.size();
}

TestPicture::Box TestPicture::drawn() const {
  Box box{width, -1, height, -1};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (std::equal(at(x, y), at(x, y) + 3, at(0, 0))) continue;
      box.left = std::min(box.left, x);
      box.right = std::max(box.right, x);
      box.top = std::min(box.top, y);
      box.bottom = std::max(box.bottom, y);
    }
  return box;
}

} // namespace softgl::test
