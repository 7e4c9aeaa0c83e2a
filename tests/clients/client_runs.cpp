#include "clients/client_runs.h"

#include <catch2/catch.hpp>

#include <cstdio>
#include <dlfcn.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sys/wait.h>

#include "support/gl.h"
#include "test_paths.h"

namespace softgl::test {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string run(const std::string& environment, const std::string& command, const std::string& file) {
  fs::remove(file);
  int code = 0;
  const std::string text = output_of(environment + " " + command + " " + file, code);
  INFO(text);
  REQUIRE(code == 0);
  return bytes_of(file);
}

} // namespace

std::string system_library() {
  Dl_info info{};
  REQUIRE(dladdr(reinterpret_cast<void*>(osmesa_library().OSMesaMakeCurrent), &info));
  return info.dli_fname;
}

std::string output_of(const std::string& command, int& code) {
  std::string text;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  REQUIRE(pipe);
  char part[4096];
  for (size_t n; (n = fread(part, 1, sizeof part, pipe)) > 0;) text.append(part, n);
  const int status = pclose(pipe);
  code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return text;
}

std::vector<std::string> output_lines(const std::string& command) {
  int code = 0;
  const std::string text = output_of(command, code);
  INFO(text);
  REQUIRE(code == 0);
  std::vector<std::string> lines;
  for (size_t at = 0, end; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    lines.push_back(text.substr(at, end - at));
  REQUIRE(!lines.empty());
  return lines;
}

bool has_program(const std::string& name) {
  int code = 0;
  output_of("command -v " + name, code);
  return code == 0;
}

std::string client_folder() {
  const fs::path folder = fs::path(SOFTGL_TEST_OUTPUT) / "clients";
  fs::create_directories(folder);
  return folder.string();
}

std::string loader_folder(const std::string& library) {
  const fs::path folder =
      fs::path(client_folder()) / (library == system_library() ? "osmesa_library" : "softgl_library");
  fs::create_directories(folder);
  std::error_code exists;
  for (const char* name : {"libOSMesa.so", "libOSMesa.so.8"})
    fs::create_symlink(library, folder / name, exists);
  return folder.string();
}

Pair run_with_both(const std::string& name, const std::function<std::string(const std::string&)>& with) {
  const std::string file = client_folder() + "/" + name;
  return {run("SOFTGL_QUADS=osmesa", with(SOFTGL_TEST_LIBRARY), file + ".softgl"),
          run("MESA_GL_VERSION_OVERRIDE=1.5", with(system_library()), file + ".osmesa")};
}

} // namespace softgl::test
