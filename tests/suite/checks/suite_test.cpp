// softgl-conformance: on softgl and on OSMesa, on libraries that misbehave, and on faults that are put into
// softgl.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "checks/suite_runs.h"
#include "expect/machine.h"
#include "run/paths.h"
#include "test_paths.h"

namespace softgl::suite {
namespace {

struct Hostile { // sets how the hostile library misbehaves
  explicit Hostile(const char* kind) {
    setenv("HOSTILE_GL", kind, 1), setenv("HOSTILE_GL_REAL", SOFTGL_TEST_LIBRARY, 1);
  }
  ~Hostile() { unsetenv("HOSTILE_GL"); }
};
const char* const kTest = "lighting.diffuse.alone";

TestResult hostile_result(const char* kind, double seconds = 60) {
  const Hostile hostile(kind);
  RunOptions options = options_for(SOFTGL_TEST_HOSTILE_GL, kTest);
  options.seconds = seconds, options.levels = Levels::Plain;
  return run_quietly(options).tests.at(0);
}

} // namespace

TEST_CASE("the conformance suite finds in softgl what is known", "[suite]") {
  check_known(run_quietly(options_for(SOFTGL_TEST_LIBRARY)), "softgl");
}

TEST_CASE("the conformance suite finds nothing in softgl's answers of the specification", "[suite]") {
  setenv("SOFTGL_ANSWERS", "specification", 1);
  RunOptions options = options_for(SOFTGL_TEST_LIBRARY);
  options.levels = Levels::Plain;
  CHECK(failures(run_quietly(options)).empty());
  // On all path levels, what softgl else takes over from OSMesa.
  const std::set<std::string> known = known_failures("softgl");
  CHECK(known.size() >= 9);
  for (const std::string& name : known) {
    INFO(name);
    const RunResult result = run_quietly(options_for(SOFTGL_TEST_LIBRARY, name));
    CHECK(result.tests.size() == 1);
    CHECK(result.count(Outcome::Pass) == 1);
  }
  unsetenv("SOFTGL_ANSWERS");
}

TEST_CASE("the conformance suite finds in llvmpipe what is known", "[suite]") {
  setenv("GALLIUM_DRIVER", "llvmpipe", 1), setenv("LP_NUM_THREADS", "0", 1);
  const char* other = std::getenv("SOFTGL_TEST_OSMESA");
  RunOptions options = options_for(other ? other : "libOSMesa.so.8");
  options.levels = Levels::Plain;
  check_known(run_quietly(options), "llvmpipe");
}

TEST_CASE("every conformance test shows something and is certain of it", "[suite]") {
  std::set<std::string> names;
  for (const Test& t : all_tests()) {
    INFO(t.name);
    CHECK(names.insert(t.name).second);
    CHECK(!t.section.empty());
    CHECK(t.sentence.ends_with("."));
    const Script script = whole_script(t);
    Claims claims = Claims::Wrong;
    const Expectation e = expected_picture(script, kWindowWidth, kWindowHeight, {}, &claims);
    CHECK(claims != Claims::Wrong);
    // A test of queries alone has no picture.
    const auto queries = std::count_if(script.calls.begin(), script.calls.end(),
                                       [](const Call& c) { return facts_of(c.command).query; });
    if (e.covered == 0 && queries >= 2) continue;
    CHECK(e.covered > 30);
    CHECK(e.uncertain() < kWindowWidth * kWindowHeight / 4);
    // Not one color only: something besides the background, or lines and points that have witnesses.
    std::set<long> colors;
    for (const auto& answers : e.pixels)
      for (int c = 0; c < 3; c++) colors.insert(1000 * c + std::lround(answers[0].color[c].middle() * 255));
    CHECK((colors.size() > 3 || !e.witnesses.empty()));
    // A width of more than a sixth tells nothing. Polygons of many corners are open between them.
    if (t.open.empty() && t.section != "2.14.7, table 2.12") {
      int wide = 0;
      for (const auto& answers : e.pixels)
        for (const Interval& c : answers[0].color) wide += c.high - c.low > 1.0 / 6;
      // At the border of two texels all four components of a pixel may be either's.
      const int components = suite_of(t) == "texture" ? 4 : 1;
      CHECK(wide < components * kWindowWidth * kWindowHeight / 25);
    }
  }
  CHECK(names.size() >= 150);
}

TEST_CASE("every path level changes a script, and all calls have names of C", "[suite]") {
  const Test& test = *chosen_tests(options_for("", kTest)).at(0);
  Script body;
  test.body(body);
  for (const PathLevel& level : path_levels()) {
    INFO(level.name);
    const std::optional<Script> script = level.make(body);
    REQUIRE(script);
    const std::string text = to_c(*script, "");
    CHECK((level.name == std::string("plain")) == (text == to_c(whole_script(test), "")));
    CHECK(text.find("glEnable(GL_") != std::string::npos);
  }
  for (const Test& t : all_tests()) {
    const std::string text = to_c(whole_script(t), "");
    INFO(t.name);
    for (const char* call : {"glEnable(", "glDisable(", "glLightfv(", "glMaterialfv(", "glFogi("})
      for (size_t at = 0; (at = text.find(call, at)) != std::string::npos; at++)
        CHECK(text.compare(at + std::string(call).size(), 3, "GL_") == 0);
  }
}

TEST_CASE("a GL that gives no context has no verdict", "[suite]") {
  for (const auto& [kind, reason] : {std::pair{"no context", "returned NULL"},
                                     {"no version", "returned NULL"},
                                     {"not current", "GL_FALSE"},
                                     {"small window", "48 x 48"},
                                     {"no bits", "no red"}}) {
    const Hostile hostile(kind);
    CHECK_THROWS_WITH(probe(options_for(SOFTGL_TEST_HOSTILE_GL, kTest)), Catch::Contains(reason));
  }
  CHECK_THROWS_AS(probe(options_for("/there/is/no/library.so")), std::runtime_error);
}

TEST_CASE("a GL that misbehaves never passes", "[suite]") {
  CHECK(hostile_result("").outcome == Outcome::Pass);
  const std::pair<const char*, const char*> kinds[] = {
      {"missing", "no glLightfv"}, {"crash", "Segmentation fault"},
      {"leave", "ended before"},   {"does nothing", "wrong"},
      {"garbage", "wrong"},        {"errors", "GL error"},
      {"one bit", "cannot hold"},
  };
  for (const auto& [kind, text] : kinds) {
    INFO(kind);
    const TestResult result = hostile_result(kind);
    CHECK(result.outcome == Outcome::Fail);
    CHECK_THAT(result.text, Catch::Contains(text));
  }
}

TEST_CASE("a GL that says it has all fails where it has not", "[suite]") {
  const Hostile hostile("says it has all");
  RunOptions options = options_for(SOFTGL_TEST_HOSTILE_GL, "lighting.phong.spot*");
  options.levels = Levels::Plain;
  const RunResult result = run_quietly(options);
  CHECK(result.count(Outcome::Fail) == 2);
}

TEST_CASE("windows of other depths, sizes and directions are no failure", "[suite]") {
  for (const char* kind : {"565", "565 y down", "bgra", "no depth", "large window"}) {
    INFO(kind);
    const Hostile hostile(kind);
    RunOptions options = options_for(SOFTGL_TEST_HOSTILE_GL, "lighting.[fmr]*");
    options.levels = Levels::Some;
    const SubjectFacts facts = probe(options);
    CHECK(facts.precision.bits[1] == (std::string(kind).starts_with("565") ? 6 : 8));
    CHECK(facts.stencil_bits == (std::string(kind) == "large window" || std::string(kind) == "bgra" ? 8 : 0));
    std::set<std::string> known;
    for (const std::string& name : known_failures("softgl"))
      if (name.starts_with("lighting.f") || name.starts_with("lighting.m")) known.insert(name);
    // Three pixels that are a little off lie within the intervals of five bits.
    if (std::string(kind).starts_with("565")) known.erase("lighting.fog.after_separate_specular");
    const RunResult result = run(options, facts, [](const TestResult&) {});
    CHECK(failures(result) == known);
    CHECK(result.count(Outcome::Pass) > 40);
  }
}

TEST_CASE("a GL that hangs fails when its time is over", "[suite]") {
  CHECK_THAT(hostile_result("hang", 1).text, Catch::Contains("out of time"));
}

TEST_CASE("every seeded fault is caught by the test that the table names", "[suite]") {
  const RunOptions clean = options_for(SOFTGL_TEST_FAULTY_LIBRARY, kTest);
  setenv("SOFTGL_ISA", "baseline", 1);
  CHECK(run_quietly(clean).tests.at(0).outcome == Outcome::Pass);
  std::set<std::string> faults;
  for (const auto& row : table("faults/caught.tsv")) {
    INFO(row.at(0) << ": " << row.at(2));
    faults.insert(row.at(0));
    setenv("SOFTGL_SEEDED_FAULT", row.at(0).c_str(), 1);
    RunOptions options = options_for(SOFTGL_TEST_FAULTY_LIBRARY, row.at(1));
    options.levels = Levels::Plain;
    const RunResult result =
        run(options, SubjectFacts{"", "", "1.5", "GL_WIN_phong_shading", 15, {}, 24, 8, 16},
            [](const TestResult&) {});
    REQUIRE(result.tests.size() == 1);
    CHECK(result.tests[0].outcome == Outcome::Fail);
    CHECK_THAT(result.tests[0].text, Catch::Contains("wrong") || Catch::Contains("raise"));
  }
  unsetenv("SOFTGL_SEEDED_FAULT"), unsetenv("SOFTGL_ISA");
  std::set<std::string> all;
#define SEEDED_FAULT(name, meaning) all.insert(#name);
#include "shaders/common/seeded_faults.inc"
#undef SEEDED_FAULT
  CHECK(faults == all);
  CHECK(all.size() >= 60);
}

TEST_CASE("every test of lighting is needed", "[suite]") {
  // Two tests of the same sentence must each catch a fault that no other test does.
  std::map<std::string, std::vector<std::string>> sentences; // and which of their tests catch nothing alone
  std::set<std::string> names, all, alone;
  for (const auto& row : table("faults/needed.tsv")) {
    names.insert(row.at(0)), sentences[row.at(2)].push_back(row.at(3) == "-" ? row.at(0) : "");
    for (std::istringstream faults(row.at(3)); !faults.eof();) {
      std::string fault;
      if (faults >> fault && fault != "-") alone.insert(fault);
    }
  }
  for (const auto& [sentence, tests] : sentences)
    for (const std::string& test : tests) {
      INFO(sentence << " " << test);
      CHECK((tests.size() == 1 || test.empty()));
    }
  std::map<std::string, std::string> written;
  for (const auto& row : table("faults/needed.tsv")) written[row.at(0)] = row.at(1) + ": " + row.at(2);
  for (const Test& t : all_tests()) {
    if (suite_of(t) != "lighting") continue;
    INFO(t.name << ": the table is older than the test; catch_faults.py writes it");
    all.insert(t.name);
    CHECK(written[t.name] == t.section + ": " + t.sentence);
  }
  CHECK(names == all);
  std::set<std::string> caught_once;
  for (const auto& row : table("faults/caught.tsv"))
    if (row.at(3) == "1" && row.at(1).starts_with("lighting.")) caught_once.insert(row.at(0));
  CHECK(alone == caught_once);
}

} // namespace softgl::suite
