// Two runs beside each other: what has changed since.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace softgl::suite {

/// How a test changed, the worst first. `StillFailing` and `OtherBytes` have another picture than before.
enum class Change {
  NewlyFailing,
  NoLongerSupported,
  NewlyPassing,
  StillFailing,
  OtherBytes,
  Added,
  Removed,
  Same
};
/// "newly failing"
const char* word_of(Change change);

/// One side of a test: what results.json says of it.
struct TestRow {
  std::string name, section, sentence, outcome, text, hash;
  std::string failures;      // which levels failed, how, and with which pictures
  std::string got, expected; // PNG in base64; empty if the test did not fail
};
struct RunRows {
  std::map<std::string, std::string> facts; // "renderer" and the like
  std::vector<TestRow> tests;
};

struct TestChange {
  Change change = Change::Same;
  TestRow before, after; // one of them has no name if the test was added or removed
  const TestRow& test() const { return after.name.empty() ? before : after; }
};
struct FactChange {
  std::string name, before, after;
};

struct Comparison {
  std::string before, after; // what the runs are called
  std::vector<FactChange> facts;
  std::vector<TestChange> tests; // all, the worst changes first
  int count(Change change) const;
  /// A test fails that did not, or is no longer supported.
  bool worse() const { return count(Change::NewlyFailing) + count(Change::NoLongerSupported) > 0; }
};

/// The text of a results.json. Throws std::runtime_error, with `name`, if it is none.
RunRows parse_results(const std::string& json, const std::string& name);
/// From a results.json, or a folder of --report that holds one. Throws std::runtime_error.
RunRows read_results(const std::string& path);

Comparison compare(const RunRows& before, const RunRows& after);

std::string changes_as_text(const Comparison& comparison);
std::string changes_as_json(const Comparison& comparison);
std::string changes_as_html(const Comparison& comparison);

} // namespace softgl::suite
