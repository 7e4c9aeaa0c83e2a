#include "report/report.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "expect/machine.h"
#include "report/c_program.h"
#include "report/markup.h"
#include "report/pictures.h"
#include "run/paths.h"

namespace softgl::suite {
namespace {

std::string hexadecimal(uint64_t hash) {
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

} // namespace

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw std::runtime_error("cannot make " + path + ": " + error.message());
}

void write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  if (!(file << text) || !file.flush()) throw std::runtime_error("cannot write " + path);
}

std::string to_json(const RunResult& result) {
  using nlohmann::json;
  json tests = json::array();
  for (const TestResult& t : result.tests) {
    json levels = json::array();
    for (const LevelResult& l : t.levels)
      levels.push_back({{"level", l.level},
                        {"pass", l.pass},
                        {"text", l.text},
                        {"wrong_pixels", l.verdict.wrong_pixels},
                        {"other_side", l.verdict.other_side},
                        {"hash", hexadecimal(l.hash)}});
    const char* const exact_words[] = {"not compared", "same", "different"};
    json row = {{"name", t.test->name},
                {"section", t.test->section},
                {"sentence", t.test->sentence},
                {"outcome", word_of(t.outcome)},
                {"text", t.text},
                {"as_osmesa", exact_words[int(t.exact)]},
                {"hash", hexadecimal(t.hash)},
                {"levels", levels}};
    for (const LevelResult& l : t.levels) {
      if (l.pass || l.color.empty()) continue;
      row["got"] = base64(png_of(l.color, kWindowWidth, kWindowHeight));
      row["expected"] = base64(png_of(expected_bytes(expected_picture(whole_script(*t.test), kWindowWidth,
                                                                      kWindowHeight, result.facts.precision)),
                                      kWindowWidth, kWindowHeight));
      break;
    }
    tests.push_back(std::move(row));
  }
  const int* b = result.facts.precision.bits;
  const json bits = {{"red", b[0]},
                     {"green", b[1]},
                     {"blue", b[2]},
                     {"alpha", b[3]},
                     {"depth", result.facts.depth_bits},
                     {"stencil", result.facts.stencil_bits}};
  const json whole = {{"gl", result.subject},
                      {"vendor", result.facts.vendor},
                      {"renderer", result.facts.renderer},
                      {"version", result.facts.version},
                      {"extensions", result.facts.extensions},
                      {"bits", bits},
                      {"pass", result.count(Outcome::Pass)},
                      {"fail", result.count(Outcome::Fail)},
                      {"not_supported", result.count(Outcome::NotSupported)},
                      {"tests", tests}};
  // A GL may give any bytes as its name.
  return whole.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string to_junit(const RunResult& result) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"softgl-conformance\" tests=\"" +
      std::to_string(result.tests.size()) + "\" failures=\"" + std::to_string(result.count(Outcome::Fail)) +
      "\" skipped=\"" + std::to_string(result.count(Outcome::NotSupported)) + "\">\n";
  for (const TestResult& t : result.tests) {
    text += "  <testcase classname=\"" + suite_of(*t.test) + "\" name=\"" + escaped(t.test->name) + "\">";
    if (t.outcome == Outcome::Fail)
      text += "<failure message=\"" + escaped(t.text) + "\">" +
              escaped(t.test->section + ": " + t.test->sentence) + "</failure>";
    if (t.outcome == Outcome::NotSupported) text += "<skipped message=\"" + escaped(t.text) + "\"/>";
    text += "</testcase>\n";
  }
  return text + "</testsuite>\n";
}

void write_sheet(const std::vector<const Test*>& tests, const std::string& path) {
  int width = 0, height = 0;
  const std::vector<uint8_t> sheet = contact_sheet(tests, &width, &height);
  write_file(path, png_of(sheet, width, height));
}

namespace {

std::string hash_rows(const RunResult& result) {
  std::string rows;
  for (const TestResult& t : result.tests) {
    char row[200];
    std::snprintf(row, sizeof row, "HASH(\"%s\", 0x%016llxu)\n", t.test->name.c_str(),
                  static_cast<unsigned long long>(t.hash));
    if (t.hash) rows += row;
  }
  return rows;
}

// The failed test's script on the path where it failed first, as a program.
std::string program_of(const TestResult& t, const RunOptions& options, const SubjectFacts& facts) {
  for (const LevelResult& level : t.levels) {
    const bool answer = is_wrong_answer(level.text);
    if (level.pass || level.color.empty() || (level.verdict.wrong_pixels == 0 && !answer)) continue;
    Script body;
    t.test->body(body);
    for (const PathLevel& path : path_levels()) {
      if (level.level != path.name) continue;
      const Script script = *path.make(body);
      const auto program = [&](const Script& shown, const Verdict& verdict, const std::string& note) {
        return c_program(*t.test, shown, answer ? nullptr : &verdict, t.test->name, options.subject, note);
      };
      // The machine does not know all state of the other paths.
      if (level.level != "plain")
        return program(script, level.verdict,
                       " * Path: " + level.level + ". The whole test, with all its calls.\n");
      const Minimized m = minimized(script, options, facts);
      if (!m.fails_again) return program(script, level.verdict, " * Drawn once more it did not fail.\n");
      return program(m.script, m.verdict,
                     m.is_minimal ? "" : " * Not all calls may be needed: too many were tried already.\n");
    }
  }
  return "";
}

} // namespace

void write_reports(const ReportFiles& files, const RunResult& result, const RunOptions& options) {
  if (!files.json.empty()) write_file(files.json, to_json(result));
  if (!files.junit.empty()) write_file(files.junit, to_junit(result));
  if (!files.hashes.empty()) write_file(files.hashes, hash_rows(result));
  if (files.folder.empty()) return;
  make_folder(files.folder);
  std::map<std::string, std::string> programs;
  for (const TestResult& t : result.tests) {
    if (t.outcome != Outcome::Fail) continue;
    const std::string program = program_of(t, options, result.facts);
    if (program.empty()) continue;
    programs[t.test->name] = program;
    write_file(files.folder + "/" + t.test->name + ".c", program);
  }
  write_file(files.folder + "/results.json", to_json(result));
  write_file(files.folder + "/index.html", to_html(result, programs));
}

} // namespace softgl::suite
