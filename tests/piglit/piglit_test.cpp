// The tests of piglit that ask for OpenGL 1.5 pass, but for those that expected.tsv has a reason for. Where
// the packages piglit and libwaffle-dev are missing the case says so and is skipped.
#include <catch2/catch.hpp>

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "test_paths.h"

namespace softgl::test {
namespace {

namespace fs = std::filesystem;

const std::string kPrograms = "/usr/lib/x86_64-linux-gnu/piglit/bin";

struct PiglitTest {
  std::string name, expected, command, reason;
  std::string result; // what it gave now
};

/// Rows of four fields between tabs; the reason may be empty.
std::vector<PiglitTest> read_expected() {
  std::vector<PiglitTest> tests;
  std::ifstream in(std::string(SOFTGL_TEST_SOURCE_DIR) + "/tests/piglit/expected.tsv");
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    PiglitTest t;
    std::getline(fields, t.name, '\t');
    std::getline(fields, t.expected, '\t');
    std::getline(fields, t.command, '\t');
    std::getline(fields, t.reason, '\t');
    tests.push_back(t);
  }
  return tests;
}

const std::array<std::string, 4> kWorstFirst = {"fail", "warn", "pass", "skip"};

/// A program prints lines such as PIGLIT: {"result": "pass" }, and, where it has parts, one for each of them:
/// then the worst part counts.
std::string result_of(const std::string& output, int status) {
  if (!WIFEXITED(status)) return "crash";
  if (WEXITSTATUS(status) == 124) return "timeout";
  std::string whole = "fail";
  size_t worst = kWorstFirst.size();
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    const size_t at = line.find("PIGLIT: {");
    if (at == std::string::npos || line.find("enumerate subtests") != std::string::npos) continue;
    for (size_t i = 0; i < kWorstFirst.size(); ++i) {
      if (line.find(": \"" + kWorstFirst[i] + "\"", at) == std::string::npos &&
          line.find(" : \"" + kWorstFirst[i] + "\"", at) == std::string::npos)
        continue;
      if (line.find("\"subtest\"", at) != std::string::npos)
        worst = std::min(worst, i);
      else
        whole = kWorstFirst[i];
    }
  }
  return worst < kWorstFirst.size() ? kWorstFirst[worst] : whole;
}

std::string run(const PiglitTest& test) {
  const std::string shim = std::string(SOFTGL_TEST_BINARY_DIR) + "/../piglit";
  const std::string command = "cd '" SOFTGL_TEST_OUTPUT "/piglit' && LD_LIBRARY_PATH='" + shim +
                              "' PIGLIT_PLATFORM=gbm SOFTGL_PIGLIT_LIBRARY='" SOFTGL_TEST_LIBRARY
                              "' timeout 60 " +
                              kPrograms + "/" + test.command + " -auto 2>&1 </dev/null";
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return "not run";
  std::string text;
  char part[4096];
  for (size_t n; (n = fread(part, 1, sizeof part, pipe)) > 0;) text.append(part, n);
  return result_of(text, pclose(pipe));
}

} // namespace

TEST_CASE("piglit's tests pass, but for those with a reason", "[clients][piglit]") {
  if (!fs::exists(kPrograms) || !fs::exists(std::string(SOFTGL_TEST_BINARY_DIR) + "/../piglit")) {
    WARN("SKIPPED: piglit or libwaffle-dev is not installed");
    return;
  }
  fs::create_directories(SOFTGL_TEST_OUTPUT "/piglit");
  std::vector<PiglitTest> tests = read_expected();
  REQUIRE(tests.size() > 390);
  std::atomic<size_t> next = 0;
  const auto work = [&] {
    for (size_t i; (i = next++) < tests.size();) tests[i].result = run(tests[i]);
  };
  std::thread other(work);
  work();
  other.join();
  for (const PiglitTest& t : tests) {
    INFO(t.name << ": " << t.command);
    CHECK((t.expected == "pass" || !t.reason.empty()));
    if (t.expected == "pass") CHECK(t.result == "pass");
    if (t.expected != "pass" && t.result == "pass") WARN(t.name << " passes now: expected.tsv should say so");
  }
}

} // namespace softgl::test
