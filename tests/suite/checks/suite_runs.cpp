#include "checks/suite_runs.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

#include "test_paths.h"

namespace softgl::suite {

RunOptions options_for(const std::string& library, const std::string& filter) {
  RunOptions options;
  options.subject = {Binding::OSMesa, library, "osmesa:" + library};
  options.filter = filter, options.levels = Levels::Some;
  return options;
}

RunResult run_quietly(const RunOptions& options) {
  return run(options, probe(options), [](const TestResult&) {});
}

std::set<std::string> failures(const RunResult& result) {
  std::set<std::string> names;
  for (const TestResult& t : result.tests)
    if (t.outcome == Outcome::Fail) names.insert(t.test->name);
  return names;
}

std::vector<std::vector<std::string>> table(const std::string& file) {
  std::ifstream in(SOFTGL_TEST_SOURCE_DIR "/tests/suite/" + file);
  std::vector<std::vector<std::string>> rows;
  for (std::string line, cell; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    rows.emplace_back();
    for (std::istringstream cells(line); std::getline(cells, cell, '\t');) rows.back().push_back(cell);
  }
  return rows;
}
std::set<std::string> known_failures(const std::string& gl) {
  std::set<std::string> names;
  for (const auto& row : table("known_failures.tsv"))
    if (row.at(0).find(gl) != std::string::npos) names.insert(row.at(1));
  return names;
}

std::set<std::string> tests_that_need(const std::string& extension) {
  std::set<std::string> names;
  for (const Test& test : all_tests())
    if (test.need.extension == extension) names.insert(test.name);
  return names;
}

std::set<std::string> not_supported(const RunResult& result) {
  std::set<std::string> names;
  for (const TestResult& t : result.tests)
    if (t.outcome == Outcome::NotSupported) names.insert(t.test->name);
  return names;
}

void check_known(const RunResult& result, const std::string& gl, const std::string& door) {
  std::set<std::string> known = known_failures(gl), missing, wanted_failures, wanted_missing;
  if (!door.empty()) known.merge(known_failures(door));
  if (gl != "softgl") missing = tests_that_need("GL_WIN_phong_shading");
  for (const TestResult& t : result.tests) {
    Script body;
    t.test->body(body);
    if (missing.count(t.test->name) || !missing_buffer(body, result.facts).empty())
      wanted_missing.insert(t.test->name);
    else if (known.count(t.test->name))
      wanted_failures.insert(t.test->name);
  }
  CHECK(failures(result) == wanted_failures);
  CHECK(not_supported(result) == wanted_missing);
}

} // namespace softgl::suite
