// Runs the chosen tests: in children, some at a time.
#include <algorithm>
#include <deque>
#include <map>
#include <stdexcept>
#include <utility>

#include "expect/machine.h"
#include "run/paths.h"
#include "run/results.h"

namespace softgl::suite {
namespace {

const std::map<std::string, uint64_t>& osmesa_hashes() {
  static const std::map<std::string, uint64_t> hashes = {
#define HASH(name, hash) {name, hash},
#include "run/osmesa_hashes.inc"
#undef HASH
  };
  return hashes;
}

// A test and the scripts of its levels; none if it is not supported.
struct Prepared {
  TestResult result;
  std::vector<Script> scripts;
};

Prepared prepare(const Test& test, size_t index, const RunOptions& options, const SubjectFacts& facts) {
  Prepared p;
  p.result.test = &test;
  Script body;
  test.body(body);
  std::string needed = missing_buffer(body, facts);
  if (!is_supported(test.need, facts)) needed = text_of(test.need);
  if (!needed.empty()) {
    p.result.outcome = Outcome::NotSupported, p.result.text = "needs " + needed;
    return p;
  }
  const std::vector<PathLevel>& levels = path_levels();
  const size_t other = 1 + (index * 7 + options.seed) % (levels.size() - 1);
  for (size_t i = 0; i < levels.size(); i++) {
    if (i != 0 && options.levels != Levels::All && (i != other || options.levels == Levels::Plain)) continue;
    if (std::optional<Script> script = levels[i].make(body)) {
      p.scripts.push_back(std::move(*script));
      p.result.levels.push_back({levels[i].name, false, "", {}, {}, 0});
    }
  }
  return p;
}

// Compares what was drawn. `fault`: of the whole process.
void judge_test(TestResult& result, const Expectation& expected, const DrawnPicture* pictures,
                const std::string& fault, const SubjectFacts& facts) {
  result.outcome = Outcome::Pass, result.text = "", result.exact = Exact::NotCompared;
  for (size_t i = 0; i < result.levels.size(); i++) {
    LevelResult& level = result.levels[i];
    const DrawnPicture& picture = pictures[i];
    level = {level.level, false, picture.fault, {}, {}, 0};
    if (picture.fault.empty()) {
      level.verdict = judge(expected, picture.color, facts.precision);
      level.pass = level.verdict.pass, level.text = level.verdict.text;
    }
    if (i == 0 && picture.fault.empty()) {
      result.hash = hash_of(picture.color);
      const auto osmesa = osmesa_hashes().find(result.test->name);
      if (osmesa != osmesa_hashes().end())
        result.exact = osmesa->second == result.hash ? Exact::Same : Exact::Different;
    }
    if (level.pass) continue;
    level.color = picture.color, level.hash = hash_of(picture.color);
    if (result.outcome == Outcome::Pass)
      result.outcome = Outcome::Fail, result.text = level.level + ": " + level.text;
  }
  // Every picture may be right and the process still have died behind the last one.
  if (result.outcome == Outcome::Pass && !fault.empty()) result.outcome = Outcome::Fail, result.text = fault;
}

// The pictures of one test, whose expectation is that of the GL's choice.
void judge_test(TestResult& result, const DrawnPicture* pictures, const std::string& fault,
                SubjectFacts facts) {
  const Script script = whole_script(*result.test);
  const auto judge_choice = [&] {
    try {
      judge_test(result, expected_picture(script, kWindowWidth, kWindowHeight, facts.precision), pictures,
                 fault, facts);
    } catch (const std::logic_error& e) { throw std::logic_error(result.test->name + ": " + e.what()); }
  };
  judge_choice();
  if (result.outcome == Outcome::Pass || !result.test->need.leaves_normals_open) return;
  TestResult first = result;
  facts.precision.unit_normals = false;
  judge_choice();
  if (result.outcome != Outcome::Pass) result = std::move(first);
}

// Tests that share a child: loading a library takes longer than drawing.
struct Group {
  std::vector<Prepared> tests;
  std::vector<Script> scripts;
  std::unique_ptr<RunningChild> child;
};
constexpr size_t kScriptsOfGroup = 16;

void finish(Group& group, const RunOptions& options, const SubjectFacts& facts) {
  if (!group.child) return; // none is supported
  const ChildResult child = group.child->finish();
  group.child.reset();
  size_t first = 0;
  for (Prepared& p : group.tests) {
    if (p.scripts.empty()) continue;
    judge_test(p.result, &child.pictures[first], child.fault, facts);
    first += p.scripts.size();
    // What fails may be another test's fault: it gets a process of its own, and its verdict is that.
    if (p.result.outcome == Outcome::Pass || p.scripts.size() == group.scripts.size()) continue;
    const ChildResult alone = run_in_child(options.subject, p.scripts, options.seconds);
    judge_test(p.result, alone.pictures.data(), alone.fault, facts);
  }
}

} // namespace

RunResult run(const RunOptions& options, const SubjectFacts& facts,
              const std::function<void(const TestResult&)>& done) {
  RunResult result{options.subject.text, facts, {}};
  std::deque<Group> running;
  const auto finish_first = [&] {
    finish(running.front(), options, facts);
    for (Prepared& p : running.front().tests) {
      result.tests.push_back(std::move(p.result));
      done(result.tests.back());
    }
    running.pop_front();
  };
  Group group;
  const auto start = [&] {
    if (group.tests.empty()) return;
    if (!group.scripts.empty())
      group.child = std::make_unique<RunningChild>(options.subject, group.scripts, options.seconds);
    running.push_back(std::exchange(group, {}));
    if (running.size() >= size_t(std::max(options.jobs, 1))) finish_first();
  };
  size_t index = 0;
  for (const Test* test : chosen_tests(options)) {
    group.tests.push_back(prepare(*test, index++, options, facts));
    const std::vector<Script>& scripts = group.tests.back().scripts;
    group.scripts.insert(group.scripts.end(), scripts.begin(), scripts.end());
    if (group.scripts.size() >= kScriptsOfGroup) start();
  }
  start();
  while (!running.empty()) finish_first();
  return result;
}

} // namespace softgl::suite
