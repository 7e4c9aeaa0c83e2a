// The program softgl-conformance as its users start it: exit statuses and files.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include <sys/wait.h>

#include "test_paths.h"

namespace softgl::suite {
namespace {

const std::string kProgram = SOFTGL_TEST_BINARY_DIR "/softgl-conformance",
                  kFolder = SOFTGL_TEST_OUTPUT "/suite";
const std::string kSoftgl = " --gl osmesa:" SOFTGL_TEST_LIBRARY;

int status_of(const std::string& command) {
  return WEXITSTATUS(std::system((command + " >/dev/null 2>&1").c_str()));
}

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

TEST_CASE("softgl-conformance ends with 0, 1, 2 or 3", "[suite]") {
  CHECK(status_of(kProgram + kSoftgl + " --filter 'lighting.diffuse.a*' --levels plain") == 0);
  CHECK(status_of(kProgram + " --gl softgl --filter 'lighting.diffuse.a*' --levels plain") == 0);
  CHECK(status_of(kProgram + kSoftgl + " --filter '*shininess_0_spot' --levels plain") == 1);
  CHECK(status_of(kProgram) == 2);
  CHECK(status_of(kProgram + " --list") == 0);
  CHECK(status_of(kProgram + " --gl directx") == 2);
  CHECK(status_of(kProgram + " --gl osmesa:") == 2);
  CHECK(status_of(kProgram + kSoftgl + " --suite nothing") == 2);
  CHECK(status_of(kProgram + kSoftgl + " --filter nothing") == 2);
  CHECK(status_of(kProgram + kSoftgl + " --filter '*diffuse.alone' --json /there/is/no/folder/a.json") == 2);
  CHECK(status_of(kProgram + " --gl osmesa:/there/is/no/library.so") == 3);
}

TEST_CASE("a report has a page, JSON, and a program of C for the failure", "[suite]") {
  std::filesystem::remove_all(kFolder);
  std::filesystem::create_directories(kFolder);
  const std::string name = "lighting.material.shininess_0_spot";
  CHECK(status_of(kProgram + kSoftgl + " --filter 'lighting.material.s*' --levels plain --report " + kFolder +
                  " --junit " + kFolder + "/junit.xml") == 1);
  const auto results = nlohmann::json::parse(read(kFolder + "/results.json"));
  CHECK(results["fail"] == 2);
  CHECK(results["pass"].get<int>() + 2 == int(results["tests"].size()));
  const std::string page = read(kFolder + "/index.html"), junit = read(kFolder + "/junit.xml");
  for (const char* text : {"data:image/png;base64,", "2.14.1", name.c_str(),
                           "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF", "<h2>Failures"})
    CHECK_THAT(page, Catch::Contains(text));
  CHECK(page.find("http://") == std::string::npos); // needs nothing else
  CHECK_THAT(junit, Catch::Contains("failures=\"2\"") && Catch::Contains("<failure message="));

  const std::string program = kFolder + "/" + name + ".c";
  CHECK(read(program).find("glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS") ==
        std::string::npos); // 0 is the default: cut away
  // As the comment in it says.
  CHECK_THAT(read(program),
             Catch::Contains("cc " + name + ".c -o " + name + " " SOFTGL_TEST_LIBRARY " -Wl,-rpath,"));
  const std::string folder = std::filesystem::path(SOFTGL_TEST_LIBRARY).parent_path().string();
  REQUIRE(status_of("cd " + kFolder + " && cc -std=c99 -Wall -Werror -I" SOFTGL_TEST_SOURCE_DIR "/include " +
                    name + ".c -o failure " SOFTGL_TEST_LIBRARY " -Wl,-rpath," + folder) == 0);
  CHECK(status_of(kFolder + "/failure") == 1);                  // the failure shows without the suite
  CHECK_THAT(read(program), !Catch::Contains("Not all calls")); // the budget sufficed
  const std::string text = read(program);
  CHECK(std::count(text.begin(), text.end(), '\n') < 85);
}

TEST_CASE("a wrong error and a wrong answer give a program of C", "[suite]") {
  struct Wrong {
    const char *fault, *test, *call;
  };
  const std::string folder = kFolder + "_wrong"; // the test above runs at the same time
  for (const Wrong& w :
       {Wrong{"negative_viewport_silent", "vertices.errors.viewport", "expectError(GL_INVALID_VALUE);"},
        Wrong{"depth_range_not_clamped", "vertices.matrices.depth_range_clamped",
              "expectGetFloatv(GL_DEPTH_RANGE"},
        Wrong{"planes_not_restored", "vertices.clipping.planes_saved", "expectIsEnabled(GL_CLIP_PLANE1"},
        Wrong{"viewport_outside_refused", "vertices.matrices.viewport_outside", "glViewport(-60"}}) {
    INFO(w.fault);
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    setenv("SOFTGL_SEEDED_FAULT", w.fault, 1), setenv("SOFTGL_ISA", "baseline", 1);
    CHECK(status_of(kProgram + " --gl osmesa:" SOFTGL_TEST_FAULTY_LIBRARY " --levels plain --filter " +
                    w.test + " --report " + folder) == 1);
    const std::string text = read(folder + "/" + w.test + ".c");
    CHECK_THAT(text, Catch::Contains(w.call) && !Catch::Contains("Not all calls"));
    CHECK(std::count(text.begin(), text.end(), '\n') < 85);
    const std::string build = "cd " + folder +
                              " && cc -std=c99 -Wall -Werror -I" SOFTGL_TEST_SOURCE_DIR "/include " + w.test +
                              ".c -o ";
    const auto linked = [](const std::string& library) {
      return library + " -Wl,-rpath," + std::filesystem::path(library).parent_path().string();
    };
    REQUIRE(status_of(build + "wrong " + linked(SOFTGL_TEST_FAULTY_LIBRARY)) == 0);
    CHECK(status_of(folder + "/wrong") == 1);
    unsetenv("SOFTGL_SEEDED_FAULT"), unsetenv("SOFTGL_ISA");
    REQUIRE(status_of(build + "right " + linked(SOFTGL_TEST_LIBRARY)) == 0);
    CHECK(status_of(folder + "/right") == 0); // what it shows is the fault's
  }
}

} // namespace softgl::suite
