// What came out of a run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "run/child.h"
#include "run/test.h"
#include "run/verdict.h"

namespace softgl::suite {

enum class Outcome { Pass, Fail, NotSupported };
/// "pass", "fail", "not supported".
const char* word_of(Outcome outcome);

/// Whether the plain picture is OSMesa 22.3.6's, byte for byte. The specification does not ask for it.
enum class Exact { NotCompared, Same, Different };

struct LevelResult {
  std::string level; // of paths.h
  bool pass = false;
  std::string text; // why not
  Verdict verdict;
  std::vector<uint8_t> color; // kept where it failed
  uint64_t hash = 0;          // of the color, where it failed
};

struct TestResult {
  const Test* test = nullptr;
  Outcome outcome = Outcome::Fail;
  std::string text; // of the first failure
  std::vector<LevelResult> levels;
  uint64_t hash = 0; // of the plain picture
  Exact exact = Exact::NotCompared;
};

struct RunResult {
  std::string subject;
  SubjectFacts facts;
  std::vector<TestResult> tests;
  int count(Outcome outcome) const;
};

/// Which path levels: all, the plain one and one more that the seed chooses, the plain one.
enum class Levels { All, Some, Plain };

struct RunOptions {
  SubjectName subject;
  std::string suite = "all", filter;
  Levels levels = Levels::All;
  uint64_t seed = 0;
  double seconds = 60; // for the levels of one test, and for some tests that share a process
  int jobs = 2;        // processes at a time
};

/// The tests that the options choose.
std::vector<const Test*> chosen_tests(const RunOptions& options);
/// Asks the GL what it is, in a child. Throws std::runtime_error with the reason if there is no context.
SubjectFacts probe(const RunOptions& options);
bool is_supported(const Need& need, const SubjectFacts& facts);
/// What the body of a test uses and the window lacks: "a depth buffer", "a stencil buffer"; else nothing.
std::string missing_buffer(const Script& body, const SubjectFacts& facts);
/// "OpenGL 1.2 or GL_EXT_rescale_normal".
std::string text_of(const Need& need);
/// `done` is called in the parent after each test, in their order.
RunResult run(const RunOptions& options, const SubjectFacts& facts,
              const std::function<void(const TestResult&)>& done);
/// The number of tests whose plain picture is OSMesa's.
int count_exact(const RunResult& result);
uint64_t hash_of(const std::vector<uint8_t>& bytes);

} // namespace softgl::suite
