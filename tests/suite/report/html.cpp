// The report as one page that needs nothing else: pictures are inside.
#include <algorithm>
#include <map>

#include "expect/machine.h"
#include "report/markup.h"
#include "report/pictures.h"
#include "report/report.h"
#include "run/paths.h"

namespace softgl::suite {
namespace {

std::string image(const std::vector<uint8_t>& color, const char* title) {
  return figure(base64(png_of(color, kWindowWidth, kWindowHeight)), title);
}

// White where a pixel is none of its answers, the worse the brighter; black where it is right.
std::vector<uint8_t> difference(const std::vector<uint8_t>& expected, const std::vector<uint8_t>& got) {
  std::vector<uint8_t> picture;
  for (size_t i = 0; i < expected.size(); i++) {
    const int step = 4 * std::abs(expected[i] - got[i]);
    picture.push_back(uint8_t(i % 4 == 3 ? 255 : std::min(step, 255)));
  }
  return picture;
}

// "lighting.spot.cutoff_30" belongs to "lighting.spot".
std::string chapter_of(const std::string& name) { return name.substr(0, name.rfind('.')); }

std::string failure(const TestResult& t, const std::map<std::string, std::string>& programs) {
  std::string text = "<section id=\"" + escaped(t.test->name) + "\"><h3 class=fail>" + escaped(t.test->name) +
                     "</h3><p><b>OpenGL 1.5, " + escaped(t.test->section) + ".</b> " +
                     escaped(t.test->sentence) + "</p>";
  if (!t.test->open.empty()) text += "<p>Left open: " + escaped(t.test->open) + "</p>";
  std::string same;
  for (const LevelResult& l : t.levels)
    if (!l.pass) same += "<li>" + escaped(l.level) + ": " + escaped(l.text) + "</li>";
  text += "<ul>" + same + "</ul>";
  for (const LevelResult& l : t.levels)
    if (!l.pass && !l.color.empty()) {
      const std::vector<uint8_t> expected =
          expected_bytes(expected_picture(whole_script(*t.test), kWindowWidth, kWindowHeight, {}));
      text += image(expected, "expected") + image(l.color, "got") +
              image(difference(expected, l.color), "difference, times 4");
      break;
    }
  const auto program = programs.find(t.test->name);
  if (program != programs.end())
    text += "<details><summary>Program that shows it</summary><pre>" + escaped(program->second) +
            "</pre></details>";
  return text + "</section>";
}

} // namespace

std::string to_html(const RunResult& result, const std::map<std::string, std::string>& programs) {
  std::string page =
      page_begin("Conformance of " + result.facts.renderer) + "<table><tr><td>GL<td>" +
      escaped(result.subject) + "<tr><td>Vendor<td>" + escaped(result.facts.vendor) + "<tr><td>Version<td>" +
      escaped(result.facts.version) + "<tr><td>Tests<td>" + std::to_string(result.count(Outcome::Pass)) +
      " pass, " + std::to_string(result.count(Outcome::Fail)) + " fail, " +
      std::to_string(result.count(Outcome::NotSupported)) +
      " not supported<tr><td>Byte for byte as OSMesa 22.3.6<td>" + std::to_string(count_exact(result)) +
      "</table><h2>Chapters</h2>" + "<table><tr><th>Chapter<th>Pass<th>Fail<th>Not supported";
  std::map<std::string, int> counts[3];
  std::vector<std::string> chapters;
  for (const TestResult& t : result.tests) {
    const std::string chapter = chapter_of(t.test->name);
    if (chapters.empty() || chapters.back() != chapter)
      if (std::find(chapters.begin(), chapters.end(), chapter) == chapters.end()) chapters.push_back(chapter);
    counts[int(t.outcome)][chapter]++;
  }
  for (const std::string& chapter : chapters) {
    page += "<tr><td>" + escaped(chapter);
    for (auto& count : counts) page += "<td>" + std::to_string(count[chapter]);
  }
  page += "</table>";
  if (result.count(Outcome::Fail)) page += "<h2>Failures</h2>";
  for (const TestResult& t : result.tests)
    if (t.outcome == Outcome::Fail) page += failure(t, programs);
  page += "<h2>All tests</h2><table><tr><th>Test<th>Section<th>Sentence<th>Result<th>As OSMesa 22.3.6";
  for (const TestResult& t : result.tests) {
    const char* const exact_words[] = {"<td>", "<td>same bytes", "<td>other bytes"};
    const char* const words[] = {"<td class=pass>pass", "<td class=fail>fail", "<td>not supported"};
    page += "<tr><td>" + escaped(t.test->name) + "<td>" + escaped(t.test->section) + "<td>" +
            escaped(t.test->sentence) + words[int(t.outcome)] + exact_words[int(t.exact)];
  }
  page += "</table><h2>Path levels</h2><p>Each test is drawn again under state that must not matter.</p><ul>";
  for (const PathLevel& level : path_levels())
    page += "<li>" + std::string(level.name) + ": " + level.meaning + "</li>";
  return page + "</ul>\n";
}

} // namespace softgl::suite
