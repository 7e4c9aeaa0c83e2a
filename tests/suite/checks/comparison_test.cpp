// What has changed between two runs: softgl, and softgl with a fault.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include <sys/wait.h>

#include "report/comparison.h"
#include "test_paths.h"

namespace softgl::suite {
namespace {

const std::string kProgram = SOFTGL_TEST_BINARY_DIR "/softgl-conformance",
                  kFolder = SOFTGL_TEST_OUTPUT "/suite_changes";
// The fault makes half_vector_is_unit fail; positional passes with and without it.
const std::string kRun = kProgram +
                         " --gl osmesa:" SOFTGL_TEST_FAULTY_LIBRARY
                         " --levels plain --filter 'lighting.specular.[hp]*' --report " +
                         kFolder;

int status_of(const std::string& command, const char* fault = "") {
  const std::string environment =
      "SOFTGL_ISA=baseline " + (*fault ? std::string("SOFTGL_SEEDED_FAULT=") + fault + " " : "");
  return WEXITSTATUS(std::system((environment + command + " >" + kFolder + "/output 2>&1").c_str()));
}

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

nlohmann::json row(const char* name, const char* outcome, const char* hash = "1") {
  return {{"name", name},
          {"outcome", outcome},
          {"text", ""},
          {"hash", hash},
          {"levels", nlohmann::json::array()}};
}
RunRows rows(const std::vector<nlohmann::json>& tests, const char* version = "1.5",
             const char* extensions = "GL_a GL_b") {
  const nlohmann::json whole = {
      {"gl", "x"}, {"renderer", "r"}, {"version", version}, {"extensions", extensions}, {"tests", tests}};
  return parse_results(whole.dump(), "here");
}

} // namespace

TEST_CASE("two runs are compared", "[suite]") {
  std::filesystem::remove_all(kFolder);
  std::filesystem::create_directories(kFolder);
  REQUIRE(status_of(kRun + "/good") == 0);
  REQUIRE(status_of(kRun + "/bad --since " + kFolder + "/good", "infinite_half_not_unit") == 1);
  const auto changes = nlohmann::json::parse(read(kFolder + "/bad/changes.json"));
  CHECK(changes["worse"] == true);
  CHECK(changes["counts"]["newly failing"] == 1);
  CHECK(changes["counts"]["as before"] >= 1);
  CHECK_THAT(read(kFolder + "/output"),
             Catch::Contains("newly failing                lighting.specular.half_vector_is_unit"));
  const std::string page = read(kFolder + "/bad/changes.html");
  CHECK_THAT(page, Catch::Contains("<h2>newly failing</h2>") && Catch::Contains("<figcaption>after"));

  CHECK(status_of(kProgram + " --compare " + kFolder + "/bad " + kFolder + "/good/results.json --report " +
                  kFolder + "/back") == 0);
  CHECK_THAT(read(kFolder + "/back/changes.html"),
             Catch::Contains("<h2>newly passing</h2>") && Catch::Contains("<figcaption>before"));
  CHECK(status_of(kProgram + " --compare " + kFolder + "/good " + kFolder + "/good") == 0);
  CHECK_THAT(read(kFolder + "/output"), Catch::Contains("as before") && !Catch::Contains("newly"));
  // Failing tests that fail as before are no reason for a status of 1; a run with a fault of its own, twice,
  // is the same.
  CHECK(status_of(kRun + "/bad_again --since " + kFolder + "/bad", "infinite_half_not_unit") == 0);
  CHECK(status_of(kProgram + " --compare " + kFolder + "/good " + kFolder + "/none") == 2);
  CHECK(status_of(kProgram + " --compare " + kFolder + "/good") == 2);
  CHECK(status_of(kRun + "/bad --since " + kFolder + "/output") == 2);
}

TEST_CASE("each change of a test has its word", "[suite]") {
  const auto change = [](const char* before, const char* after) {
    return compare(rows({row("a", before)}), rows({row("a", after)})).tests.at(0).change;
  };
  CHECK(change("pass", "fail") == Change::NewlyFailing);
  CHECK(change("not supported", "fail") == Change::NewlyFailing);
  CHECK(change("fail", "pass") == Change::NewlyPassing);
  CHECK(change("not supported", "pass") == Change::NewlyPassing);
  CHECK(change("pass", "not supported") == Change::NoLongerSupported);
  CHECK(change("fail", "not supported") == Change::NoLongerSupported);
  CHECK(change("fail", "fail") == Change::Same);
  CHECK(compare(rows({row("a", "pass", "1")}), rows({row("a", "pass", "2")})).tests.at(0).change ==
        Change::OtherBytes);

  auto failing = row("a", "fail"), otherwise = failing;
  failing["levels"] = {{{"level", "plain"}, {"pass", false}, {"text", "wrong"}, {"hash", "1"}},
                       {{"level", "fog"}, {"pass", true}, {"text", ""}, {"hash", "0"}}};
  otherwise["levels"] = {{{"level", "plain"}, {"pass", false}, {"text", "wrong"}, {"hash", "2"}}};
  CHECK(compare(rows({failing}), rows({otherwise})).tests.at(0).change == Change::StillFailing);

  const Comparison c = compare(rows({row("a", "pass"), row("b", "fail")}),
                               rows({row("b", "fail"), row("c", "fail")}, "2.1", "GL_b GL_c"));
  CHECK(!c.worse()); // a test that is new was never better
  REQUIRE(c.tests.size() == 3);
  CHECK(c.tests[0].change == Change::Added);
  CHECK(c.tests[0].test().name == "c");
  CHECK(c.tests[1].change == Change::Removed);
  CHECK(c.tests[1].test().name == "a");
  REQUIRE(c.facts.size() == 2);
  CHECK((c.facts[0].name == "extensions" && c.facts[0].before == "GL_a" && c.facts[0].after == "GL_c"));
  CHECK((c.facts[1].name == "version" && c.facts[1].before == "1.5" && c.facts[1].after == "2.1"));
}

TEST_CASE("what is no results.json is told so", "[suite]") {
  for (const char* text : {"", "[]", "{}", "{\"tests\": 3}", "{\"tests\": [{}]}",
                           "{\"tests\": [{\"name\": \"a\", \"outcome\": \"great\", \"levels\": []}]}"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_results(text, "here"), std::runtime_error);
  }
  // Text of a GL or of another's file is text in the page, nothing else.
  auto bad = row("<b>", "fail");
  bad["got"] = "\"><script>", bad["text"] = "<script>";
  const std::string page = changes_as_html(compare(rows({row("<b>", "pass")}), rows({bad})));
  CHECK_THAT(page,
             Catch::Contains("&lt;script&gt;") && !Catch::Contains("<script>") && !Catch::Contains("<b><"));
}

} // namespace softgl::suite
