// Programs with windows draw with softgl what they draw with OSMesa: hacks of xscreensaver (xscreensaver-gl,
// xscreensaver-data), and GLFW (libglfw3). All need xvfb.
#include <catch2/catch.hpp>

#include <filesystem>
#include <string>

#include "clients/client_runs.h"
#include "test_paths.h"

namespace softgl::test {
namespace {

const std::string kPrograms = "/usr/bin/python3 " SOFTGL_TEST_SOURCE_DIR "/tests/clients/";

bool is_there(const std::string& path) { return std::filesystem::exists(path); }

} // namespace

TEST_CASE("hacks of xscreensaver draw what they draw with OSMesa", "[clients]") {
  if (!is_there("/usr/libexec/xscreensaver/gears") ||
      !is_there("/usr/libexec/xscreensaver/xscreensaver-getimage") || !has_program("Xvfb") ||
      !is_there(SOFTGL_TEST_EGL)) {
    WARN("SKIPPED: xscreensaver-gl, xscreensaver-data, xvfb or libegl-dev is not installed");
    return;
  }
  // Together they use most of what the hacks use: tests/clients/NOTES.md lists all of them.
  const std::string hacks = "antspotlight endgame energystream gflux maze3d mirrorblob moebius molecule "
                            "pipes sonar unicrud winduprobot";
  std::string answers;
  for (const std::string& line : output_lines(kPrograms +
                                              "xscreensaver_hacks.py --shim " SOFTGL_TEST_EGL
                                              " --library " SOFTGL_TEST_LIBRARY " --against " +
                                              system_library() + " " + hacks))
    answers += line + "\n";
  INFO(answers);
  CHECK(answers.find("12 of 12 are identical") != std::string::npos);
}

TEST_CASE("GLFW's windows have the pictures that they have with OSMesa", "[clients]") {
  int code = 0;
  output_of("/usr/bin/python3 -c 'import ctypes; ctypes.CDLL(\"libglfw.so.3\")'", code);
  if (code != 0 || !has_program("Xvfb")) {
    WARN("SKIPPED: libglfw3 or xvfb is not installed");
    return;
  }
  const Pair pair = run_with_both("glfw", [](const std::string& library) {
    return "LD_LIBRARY_PATH=" + loader_folder(library) + " " + kPrograms + "glfw_client.py";
  });
  CHECK(pair.theirs.size() > 1'000'000);
  CHECK((pair.ours == pair.theirs));
}

} // namespace softgl::test
