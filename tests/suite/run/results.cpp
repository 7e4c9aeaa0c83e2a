#include "run/results.h"

#include <fnmatch.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "expect/machine.h"
#include "run/paths.h"

namespace softgl::suite {

const char* word_of(Outcome outcome) {
  const char* const words[] = {"pass", "fail", "not supported"};
  return words[int(outcome)];
}

int RunResult::count(Outcome outcome) const {
  return int(
      std::count_if(tests.begin(), tests.end(), [&](const TestResult& t) { return t.outcome == outcome; }));
}

std::vector<const Test*> chosen_tests(const RunOptions& options) {
  std::vector<const Test*> chosen;
  for (const Test& test : all_tests()) {
    if (options.suite != "all" && suite_of(test) != options.suite) continue;
    if (!options.filter.empty() && fnmatch(options.filter.c_str(), test.name.c_str(), 0) != 0) continue;
    chosen.push_back(&test);
  }
  return chosen;
}

SubjectFacts probe(const RunOptions& options) {
  const ChildResult child = run_in_child(options.subject, {Script{}}, options.seconds);
  if (!child.fault.empty()) throw std::runtime_error(child.fault);
  if (child.facts.version_number < 11)
    throw std::runtime_error("the version \"" + child.facts.version + "\" is not 1.1 or later");
  return child.facts;
}

bool is_supported(const Need& need, const SubjectFacts& facts) {
  if (facts.version_number >= need.version) return true;
  const std::string extension = need.extension;
  return !extension.empty() &&
         (" " + facts.extensions + " ").find(" " + extension + " ") != std::string::npos;
}

uint64_t hash_of(const std::vector<uint8_t>& bytes) { // FNV-1a
  uint64_t hash = 0xcbf29ce484222325u;
  for (uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
  return hash;
}

int count_exact(const RunResult& result) {
  return int(std::count_if(result.tests.begin(), result.tests.end(),
                           [](const TestResult& t) { return t.exact == Exact::Same; }));
}

namespace {

const std::map<std::string, uint64_t>& osmesa_hashes() {
  static const std::map<std::string, uint64_t> hashes = {
#define HASH(name, hash) {name, hash},
#include "run/osmesa_hashes.inc"
#undef HASH
  };
  return hashes;
}

TestResult run_test(const Test& test, size_t index, const RunOptions& options, const SubjectFacts& facts) {
  TestResult result;
  result.test = &test;
  if (!is_supported(test.need, facts)) {
    result.outcome = Outcome::NotSupported;
    result.text = "needs OpenGL " + std::to_string(test.need.version / 10) + "." +
                  std::to_string(test.need.version % 10) + " or " + test.need.extension;
    return result;
  }
  const Expectation expected =
      expected_picture(whole_script(test), kWindowWidth, kWindowHeight, facts.precision);
  Script body;
  test.body(body);
  std::vector<Script> scripts;
  const std::vector<PathLevel>& levels = path_levels();
  const size_t other = 1 + (index * 7 + options.seed) % (levels.size() - 1);
  for (size_t i = 0; i < levels.size(); i++) {
    if (i != 0 && options.levels != Levels::All && (i != other || options.levels == Levels::Plain)) continue;
    if (std::optional<Script> script = levels[i].make(body)) {
      scripts.push_back(std::move(*script));
      result.levels.push_back({levels[i].name, false, "", {}, {}, 0});
    }
  }
  const ChildResult child = run_in_child(options.subject, scripts, options.seconds);
  for (size_t i = 0; i < scripts.size(); i++) {
    LevelResult& level = result.levels[i];
    const DrawnPicture& picture = child.pictures[i];
    if (!picture.fault.empty()) {
      level.text = picture.fault;
    } else {
      level.verdict = judge(expected, picture.color, facts.precision);
      level.pass = level.verdict.pass, level.text = level.verdict.text;
    }
    if (i == 0 && picture.fault.empty()) {
      result.hash = hash_of(picture.color);
      const auto osmesa = osmesa_hashes().find(test.name);
      if (osmesa != osmesa_hashes().end())
        result.exact = osmesa->second == result.hash ? Exact::Same : Exact::Different;
    }
    if (!level.pass) level.color = picture.color, level.hash = hash_of(picture.color);
  }
  result.outcome = Outcome::Pass;
  for (const LevelResult& level : result.levels)
    if (!level.pass && result.outcome == Outcome::Pass)
      result.outcome = Outcome::Fail, result.text = level.level + ": " + level.text;
  // Every picture may be right and the process still have died behind the last one.
  if (result.outcome == Outcome::Pass && !child.fault.empty())
    result.outcome = Outcome::Fail, result.text = child.fault;
  return result;
}

} // namespace

RunResult run(const RunOptions& options, const SubjectFacts& facts,
              const std::function<void(const TestResult&)>& done) {
  RunResult result{options.subject.text, facts, {}};
  size_t index = 0;
  for (const Test* test : chosen_tests(options)) {
    result.tests.push_back(run_test(*test, index++, options, facts));
    done(result.tests.back());
  }
  return result;
}

} // namespace softgl::suite
