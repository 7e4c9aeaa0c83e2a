#include "report/comparison.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>

namespace softgl::suite {
namespace {

using nlohmann::json;

// The levels that failed. A level that passed does not count: another run may have had fewer of them.
std::string failures_of(const json& test) {
  std::string text;
  for (const json& level : test.at("levels"))
    if (!level.at("pass").get<bool>())
      text += level.at("level").get<std::string>() + ": " + level.at("text").get<std::string>() + " " +
              level.value("hash", "") + "\n";
  return text;
}

Change change_of(const TestRow& before, const TestRow& after) {
  if (before.name.empty()) return Change::Added;
  if (after.name.empty()) return Change::Removed;
  if (before.outcome != after.outcome)
    return after.outcome == "fail"   ? Change::NewlyFailing
           : after.outcome == "pass" ? Change::NewlyPassing
                                     : Change::NoLongerSupported;
  if (after.outcome == "fail" && before.failures != after.failures) return Change::StillFailing;
  return before.hash == after.hash ? Change::Same : Change::OtherBytes;
}

// Words that only one of the texts has: the names of extensions.
std::string words_without(const std::string& text, const std::string& without) {
  std::istringstream other(without), words(text);
  const std::set<std::string> known{std::istream_iterator<std::string>(other), {}};
  std::string left;
  for (std::string word; words >> word;)
    if (!known.contains(word)) left += (left.empty() ? "" : " ") + word;
  return left;
}

} // namespace

const char* word_of(Change change) {
  const char* const words[] = {"newly failing",
                               "no longer supported",
                               "newly passing",
                               "still failing, but otherwise",
                               "passes, with another picture",
                               "new test",
                               "test is gone",
                               "as before"};
  return words[int(change)];
}

int Comparison::count(Change change) const {
  return int(
      std::count_if(tests.begin(), tests.end(), [&](const TestChange& t) { return t.change == change; }));
}

RunRows parse_results(const std::string& text, const std::string& name) {
  RunRows rows;
  try {
    const json whole = json::parse(text);
    for (const char* fact : {"gl", "vendor", "renderer", "version", "extensions"})
      rows.facts[fact] = whole.value(fact, "");
    if (whole.contains("bits"))
      for (const auto& [component, bits] : whole["bits"].items())
        rows.facts["bits of " + component] = std::to_string(bits.get<int>());
    for (const json& test : whole.at("tests")) {
      TestRow row;
      row.name = test.at("name"), row.outcome = test.at("outcome"), row.text = test.value("text", "");
      if (row.name.empty() ||
          (row.outcome != "pass" && row.outcome != "fail" && row.outcome != "not supported"))
        throw std::runtime_error(name + ": a test without name or outcome");
      row.section = test.value("section", ""), row.sentence = test.value("sentence", "");
      row.hash = test.value("hash", ""), row.failures = failures_of(test);
      row.got = test.value("got", ""), row.expected = test.value("expected", "");
      rows.tests.push_back(std::move(row));
    }
  } catch (const json::exception& e) {
    throw std::runtime_error(name + " is not a results.json of softgl-conformance: " + e.what());
  }
  return rows;
}

RunRows read_results(const std::string& path) {
  const std::string name = std::filesystem::is_directory(path) ? path + "/results.json" : path;
  std::ifstream file(name, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw std::runtime_error("cannot read " + name);
  return parse_results(text, name);
}

Comparison compare(const RunRows& before, const RunRows& after) {
  Comparison c;
  const auto name_of = [](const RunRows& run) {
    return run.facts.at("renderer") + " (" + run.facts.at("gl") + ")";
  };
  c.before = name_of(before), c.after = name_of(after);
  for (const auto& [name, value] : after.facts) {
    const auto found = before.facts.find(name);
    if (found == before.facts.end() || found->second == value) continue;
    if (name == "extensions")
      c.facts.push_back({name, words_without(found->second, value), words_without(value, found->second)});
    else
      c.facts.push_back({name, found->second, value});
  }
  std::map<std::string, const TestRow*> old_rows;
  for (const TestRow& row : before.tests) old_rows[row.name] = &row;
  const auto add = [&](const TestRow& old_row, const TestRow& new_row) {
    c.tests.push_back({change_of(old_row, new_row), old_row, new_row});
  };
  for (const TestRow& row : after.tests) {
    const auto found = old_rows.find(row.name);
    add(found == old_rows.end() ? TestRow{} : *found->second, row);
    if (found != old_rows.end()) old_rows.erase(found);
  }
  for (const TestRow& row : before.tests)
    if (old_rows.contains(row.name)) add(row, {});
  std::stable_sort(c.tests.begin(), c.tests.end(),
                   [](const TestChange& a, const TestChange& b) { return a.change < b.change; });
  return c;
}

} // namespace softgl::suite
