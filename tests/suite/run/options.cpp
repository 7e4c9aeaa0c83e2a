#include "run/options.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <set>
#include <thread>

#include "expect/machine.h"
#include "report/comparison.h"
#include "report/report.h"
#include "run/results.h"

namespace softgl::suite {
namespace {

void list_tests(const RunOptions& options) {
  for (const Test* test : chosen_tests(options))
    std::printf("%-45s %-22s %s\n", test->name.c_str(), test->section.c_str(), test->sentence.c_str());
}

// Prints what has changed, and writes the files that are wanted. The status says whether a test got worse.
int report_changes(const RunRows& before, const RunRows& after, const std::string& folder) {
  const Comparison changes = compare(before, after);
  std::printf("%s", changes_as_text(changes).c_str());
  if (!folder.empty()) {
    make_folder(folder);
    write_file(folder + "/changes.json", changes_as_json(changes));
    write_file(folder + "/changes.html", changes_as_html(changes));
  }
  return changes.worse() ? kSomeFail : kAllPass;
}

} // namespace

int run_suite(int argc, char** argv) {
  CLI::App app{"Tests whether an OpenGL draws what the specification of OpenGL 1.5 asks for.",
               "softgl-conformance"};
  app.set_version_flag("--version", SOFTGL_SUITE_VERSION);
  RunOptions options;
  ReportFiles files;
  std::string gl, levels = "all", sheet, since;
  std::vector<std::string> compared;
  std::set<std::string> suites = {"all"};
  for (const Chapter& chapter : chapters()) suites.insert(chapter.name);
  bool list = false, quiet = false;
  app.add_option("--gl", gl, "The GL under test: osmesa:PATH, egl[:PATH], glx[:PATH] or softgl");
  app.add_option("--suite", options.suite, "A chapter, or all")
      ->check(CLI::IsMember(suites))
      ->capture_default_str();
  app.add_option("--filter", options.filter,
                 "Only tests whose names match this pattern, as in lighting.spot.*");
  app.add_option("--seed", options.seed, "Chooses the path levels of --levels some");
  app.add_option("--levels", levels,
                 "Path levels of each test: all, some (the plain one and one more), or plain")
      ->check(CLI::IsMember({"all", "some", "plain"}))
      ->capture_default_str();
  app.add_option("--time", options.seconds, "Seconds that one test may take")->check(CLI::PositiveNumber);
  options.jobs = int(std::clamp(std::thread::hardware_concurrency(), 1u, 16u));
  app.add_option("--jobs", options.jobs, "Processes at a time")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  app.add_option("--report", files.folder,
                 "Writes index.html, results.json and a C program for each failure here");
  app.add_option("--json", files.json, "Writes the results as JSON");
  app.add_option("--junit", files.junit, "Writes the results as JUnit's XML");
  app.add_option(
      "--since", since,
      "Compares the run with an earlier one, whose results.json or --report folder this is: the status\n"
      "is 1 only if a test got worse. With --report also as changes.html and changes.json");
  app.add_option("--compare", compared, "Compares two earlier runs in the same way; needs no GL")
      ->type_name("OLD NEW")
      ->expected(2);
  app.add_option("--hashes", files.hashes, "Writes the rows of a chapter's osmesa_hashes.inc");
  app.add_option("--sheet", sheet, "Writes the expected pictures of the tests as one PNG; needs no GL");
  app.add_flag("--list", list, "Lists the tests");
  app.add_flag("--quiet", quiet, "Prints failures and the summary only");
  try {
    app.parse(argc, argv);
    options.levels = levels == "all" ? Levels::All : levels == "some" ? Levels::Some : Levels::Plain;
    if (list) {
      list_tests(options);
      return kAllPass;
    }
    if (!sheet.empty()) {
      write_sheet(chosen_tests(options), sheet);
      return kAllPass;
    }
    if (!compared.empty())
      return report_changes(read_results(compared[0]), read_results(compared[1]), files.folder);
    if (gl.empty()) throw CLI::RequiredError("--gl");
    options.subject = parse_subject(gl);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kAllPass : kUsage;
  } catch (const std::invalid_argument& e) {
    std::fprintf(stderr, "softgl-conformance: %s\n", e.what());
    return kUsage;
  }
  if (chosen_tests(options).empty()) {
    std::fprintf(stderr, "softgl-conformance: no test of the suite %s matches %s\n", options.suite.c_str(),
                 options.filter.empty() ? "*" : options.filter.c_str());
    return kUsage;
  }
  RunRows before;
  if (!since.empty()) before = read_results(since); // now: --report may write the same file
  SubjectFacts facts;
  try {
    facts = probe(options);
  } catch (const std::runtime_error& e) {
    std::fprintf(stderr, "softgl-conformance: %s: no context: %s\n", gl.c_str(), e.what());
    return kNoContext;
  }
  std::printf("%s, %s\n", facts.renderer.c_str(), facts.version.c_str());
  const RunResult result = run(options, facts, [&](const TestResult& t) {
    if (quiet && t.outcome == Outcome::Pass) return;
    std::printf("%-13s %-45s %s\n", t.outcome == Outcome::Fail ? "FAIL" : word_of(t.outcome),
                t.test->name.c_str(), t.text.c_str());
    std::fflush(stdout);
  });
  const int pass = result.count(Outcome::Pass), fail = result.count(Outcome::Fail);
  std::printf("%d pass, %d fail, %d not supported; %d of %zu byte for byte as OSMesa 22.3.6\n", pass, fail,
              result.count(Outcome::NotSupported), count_exact(result), result.tests.size());
  write_reports(files, result, options);
  if (!since.empty()) return report_changes(before, parse_results(to_json(result), "this run"), files.folder);
  return fail || !pass ? kSomeFail : kAllPass;
}

} // namespace softgl::suite
