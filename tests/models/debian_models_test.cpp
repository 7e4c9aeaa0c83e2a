// Models that others made, where they are at hand: debian.txt lists 50, debian_models.py draws them.
#include <catch2/catch.hpp>

#include <cstdlib>

#include "models/command_line.h"
#include "test_paths.h"

using namespace softgl::test;

TEST_CASE("models of Debian are drawn as the list says", "[models][debian]") {
  const std::string script =
      "python3 " SOFTGL_TEST_SOURCE_DIR "/tests/models/debian_models.py " SOFTGL_TEST_BINARY_DIR "/softgl";
  if (!has_program("python3")) {
    WARN("SKIPPED: this needs python3");
    return;
  }
  const char* folder = std::getenv("SOFTGL_DEBIAN_MODELS");
  const ShellRun run =
      run_shell(script + (folder ? " --folder '" + std::string(folder) + "'" : std::string()));
  INFO(run.output);
  if (run.code == 77 && !folder) {
    WARN("SKIPPED: no package with models of tests/models/debian.txt is installed");
    return;
  }
  CHECK(run.code == 0);
}
