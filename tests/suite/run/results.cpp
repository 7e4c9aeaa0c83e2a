#include "run/results.h"

#include <fnmatch.h>

#include <algorithm>
#include <stdexcept>

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

std::string text_of(const Need& need) {
  const std::string version =
      "OpenGL " + std::to_string(need.version / 10) + "." + std::to_string(need.version % 10);
  if (need.version == kNoVersion) return need.extension;
  return version + (*need.extension ? std::string(" or ") + need.extension : "");
}

bool is_supported(const Need& need, const SubjectFacts& facts) {
  if (facts.version_number >= need.version) return true;
  const std::string extension = need.extension;
  return !extension.empty() &&
         (" " + facts.extensions + " ").find(" " + extension + " ") != std::string::npos;
}

std::string missing_buffer(const Script& body, const SubjectFacts& facts) {
  for (const Call& call : body.calls) {
    if (call.command == Command::Accum && facts.accumulation_bits == 0) return "an accumulation buffer";
    if (call.command != Command::Enable) continue;
    if (call.e(0) == GL_DEPTH_TEST && facts.depth_bits == 0) return "a depth buffer";
    if (call.e(0) == GL_STENCIL_TEST && facts.stencil_bits == 0) return "a stencil buffer";
  }
  return "";
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

} // namespace softgl::suite
