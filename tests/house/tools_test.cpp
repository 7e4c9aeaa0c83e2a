// What Python and clang-format say about the sources. Where one of them is missing, a case is skipped.
#include <catch2/catch.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <sys/wait.h>

#include "house/source_tree.h"
#include "test_paths.h"

namespace softgl::test {
namespace {

struct Answer {
  int code; // 127: there is no such program
  std::string text;
};

Answer run(const std::string& command) {
  Answer answer{-1, ""};
  const std::string whole = "cd '" SOFTGL_TEST_SOURCE_DIR "' && " + command + " 2>&1";
  FILE* pipe = popen(whole.c_str(), "r");
  REQUIRE(pipe);
  for (char part[256]; std::fgets(part, sizeof part, pipe);) answer.text += part;
  answer.code = WEXITSTATUS(pclose(pipe));
  return answer;
}

bool has_program(const std::string& name) { return run("command -v " + name).code == 0; }

/// A folder for what a case writes, empty.
std::string fresh_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(SOFTGL_TEST_OUTPUT) / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder.string();
}

/// The lines that silence clang-tidy without a list of checks and a reason, as NOLINT(check): reason.
std::string silent_lines(const std::string& path, const std::string& text) {
  static const std::regex reasoned("NOLINT(NEXTLINE|BEGIN|END)?\\([a-z0-9.,* -]+\\): \\S.*");
  std::string found;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const size_t at = line.find("NOLINT");
    if (at != std::string::npos && !std::regex_match(line.substr(at), reasoned))
      found += path + ":" + std::to_string(number) + "\n";
  }
  return found;
}

constexpr char kRegistry[] = "/usr/share/khronos-api/gl.xml"; // Debian's package khronos-api

} // namespace

TEST_CASE("the generated files are what generate.py writes", "[house]") {
  if (!has_program("python3") || !std::filesystem::exists(kRegistry)) {
    WARN("SKIPPED: this needs python3 and " << kRegistry);
    return;
  }
  const Answer answer = run("python3 src/api/generate/generate.py --check");
  INFO(answer.text);
  CHECK(answer.code == 0);

  // A copy in which one file was edited by hand is refused.
  const std::string copy = fresh_folder("stale");
  REQUIRE(run("mkdir '" + copy + "/commands' && cp -r src/api '" + copy +
              "' && cp -r src/commands/generated '" + copy + "/commands'")
              .code == 0);
  const std::string check = "python3 '" + copy + "/api/generate/generate.py' --check";
  CHECK(run(check).code == 0);
  std::ofstream(copy + "/api/generated/names.cpp", std::ios::app) << "// by hand\n";
  const Answer refusal = run(check);
  CHECK(refusal.code == 1);
  CHECK(refusal.text == "generated files under src are stale: api/generated/names.cpp\n");
}

TEST_CASE("every command has a test, and the document that says which is fresh", "[house]") {
  if (!has_program("python3") || !std::filesystem::exists(kRegistry)) {
    WARN("SKIPPED: this needs python3 and " << kRegistry);
    return;
  }
  const Answer answer = run("python3 src/api/generate/coverage.py --check");
  INFO(answer.text);
  CHECK(answer.code == 0);

  // A copy whose document was edited by hand is refused, and one whose tests lack a command, as well.
  const std::string copy = fresh_folder("coverage");
  REQUIRE(run("cp --parents -r src/api/generate src/context/state_table.inc reference/COVERAGE.md tests '" +
              copy + "'")
              .code == 0);
  const std::string check = "python3 '" + copy + "/src/api/generate/coverage.py' --check";
  CHECK(run(check).code == 0);
  const std::string stale = "reference/COVERAGE.md is stale: run src/api/generate/coverage.py\n";
  std::ofstream(copy + "/reference/COVERAGE.md", std::ios::app) << "by hand\n";
  const Answer refusal = run(check);
  CHECK(refusal.code == 1);
  CHECK(refusal.text == stale);

  const std::string tests = copy + "/tests/spec/occlusion_queries_test.cpp";
  std::ofstream(tests) << "// gl.Rectsv(a, b)\n"
                          "const char* text = \"gl.Rectsv(a, b)\";\n";
  std::filesystem::remove(copy + "/tests/spec/command_forms_test.cpp");
  const Answer lacking = run(check);
  CHECK(lacking.code == 1);
  CHECK_THAT(lacking.text, Catch::Contains("no test touches glRectsv\n") && Catch::EndsWith(stale));
  std::ofstream(tests) << "#define FORMS(letter) gl.Rect##letter##v(a, a + 2)\nvoid f() { FORMS(s); }\n";
  CHECK_THAT(run(check).text,
             !Catch::Contains("glRectsv\n") && Catch::Contains("no test touches glRectdv\n"));
}

TEST_CASE("clang-format changes no source", "[house]") {
  if (!has_program("clang-format-14")) {
    WARN("SKIPPED: this needs clang-format-14");
    return;
  }
  const std::string folder = fresh_folder("format"), list = folder + "/files";
  std::ofstream names(list);
  for (const auto& [path, text] : source_tree())
    if (is_source(path) && path.find("/generated/") == std::string::npos) names << path << "\n";
  names.close();
  const Answer answer = run("xargs clang-format-14 --dry-run -Werror < '" + list + "'");
  INFO(answer.text);
  CHECK(answer.code == 0);

  REQUIRE(run("cp .clang-format '" + folder + "'").code == 0);
  std::ofstream(folder + "/bad.cpp") << "int  two_blanks;\n";
  const Answer refusal = run("clang-format-14 --dry-run -Werror '" + folder + "/bad.cpp'");
  CHECK(refusal.code == 1);
  CHECK_THAT(refusal.text, Catch::Contains("code should be clang-formatted"));
}

TEST_CASE("whoever silences clang-tidy says why", "[house]") {
  for (const auto& [path, text] : source_tree())
    if (is_source(path) && path.rfind("tests/house/", 0) != 0) CHECK(silent_lines(path, text) == "");
  CHECK(silent_lines("a.h", "f(); // NOLINT(bugprone-exception-escape): main ends the program\n") == "");
  CHECK(silent_lines("a.h", "\nf(); // NOLINT\n") == "a.h:2\n");
  CHECK(silent_lines("a.h", "f(); // NOLINT(bugprone-exception-escape)\n") == "a.h:1\n");
  CHECK(silent_lines("a.h", "// NOLINTNEXTLINE: a reason and no check\n") == "a.h:1\n");
}

} // namespace softgl::test
