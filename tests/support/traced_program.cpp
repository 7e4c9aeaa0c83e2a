#include "support/traced_program.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>

#include "test_paths.h"

namespace softgl::test {
namespace {

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A folder that is gone with everything in it.
struct Folder {
  std::filesystem::path path;
  Folder() {
    std::filesystem::create_directories(SOFTGL_TEST_OUTPUT);
    std::string pattern = std::string(SOFTGL_TEST_OUTPUT) + "/trace.XXXXXX";
    if (!mkdtemp(pattern.data())) throw std::runtime_error("no folder for a trace");
    path = pattern;
  }
  Folder(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path); }
};

/// Of a child: ends in _exit, so that nothing of the tests runs a second time.
[[noreturn]] void be_child(const std::function<void(const Gl&)>& program, const Folder& folder,
                           const std::string& library, const std::string& file) {
  const int errors = open((folder.path / "errors").c_str(), O_WRONLY | O_CREAT, 0600);
  if (errors < 0 || dup2(errors, STDERR_FILENO) < 0) _exit(10);
  for (int s : {SIGSEGV, SIGABRT, SIGBUS}) signal(s, SIG_DFL); // not Catch's
  setenv("SOFTGL_TRACE", file.c_str(), 1);
  try {
    program(load_gl("softgl", library));
  } catch (...) { _exit(11); }
  _exit(0);
}

} // namespace

TracedRun run_traced(const std::function<void(const Gl&)>& program, const std::string& file) {
  const Folder folder;
  // The loader takes a copy for another library, and loads it anew.
  const std::string library = folder.path / "library.so";
  std::filesystem::copy_file(softgl_library().path, library);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no child process");
  if (child == 0)
    be_child(program, folder, library, file.empty() ? std::string(folder.path / "trace.%p.txt") : file);
  TracedRun run;
  waitpid(child, &run.status, 0);
  run.trace = read_file(folder.path / ("trace." + std::to_string(child) + ".txt"));
  run.errors = read_file(folder.path / "errors");
  return run;
}

std::string comparable_trace(const std::string& trace) {
  std::string text = trace.substr(trace.find('\n') + 1);
  text = std::regex_replace(text, std::regex("0x[0-9a-f]{6,}"), "POINTER");
  text = std::regex_replace(text, std::regex(", fast paths [a-z_,]+"), "");
  // What the table of functions looks up because libOSMesa.so.8 does not export it.
  while (text.starts_with("OSMesaGetProcAddress(")) text.erase(0, text.find('\n') + 1);
  return std::regex_replace(text, std::regex("[0-9]+ (bytes|workers|us)"), "N $1");
}

} // namespace softgl::test
