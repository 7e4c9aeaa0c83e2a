// A comparison of two runs as text, JSON and HTML.
#include <nlohmann/json.hpp>

#include "report/comparison.h"
#include "report/markup.h"

namespace softgl::suite {
namespace {

std::string counts(const Comparison& c) {
  std::string text;
  for (int i = 0; i <= int(Change::Same); i++)
    if (const int n = c.count(Change(i)))
      text += (text.empty() ? "" : "; ") + std::to_string(n) + " " + word_of(Change(i));
  return text.empty() ? "no tests" : text;
}

// What is said of a change, beside the name of the test.
std::string detail(const TestChange& t) {
  switch (t.change) {
  case Change::StillFailing: return t.after.text + " (was: " + t.before.text + ")";
  case Change::NewlyPassing: return t.before.text.empty() ? "" : "was: " + t.before.text;
  case Change::Removed: return "was: " + t.before.outcome;
  case Change::Added: return t.after.outcome + (t.after.text.empty() ? "" : ": " + t.after.text);
  default: return t.after.text;
  }
}

} // namespace

std::string changes_as_text(const Comparison& c) {
  std::string text = c.before + " -> " + c.after + "\n";
  for (const FactChange& f : c.facts) text += f.name + ": \"" + f.before + "\" -> \"" + f.after + "\"\n";
  for (const TestChange& t : c.tests) {
    if (t.change == Change::Same) continue;
    std::string line = word_of(t.change);
    line.resize(29, ' ');
    text += line + t.test().name + "  " + detail(t) + "\n";
  }
  return text + counts(c) + "\n";
}

std::string changes_as_json(const Comparison& c) {
  using nlohmann::json;
  json facts = json::array(), tests = json::array(), numbers = json::object();
  for (const FactChange& f : c.facts)
    facts.push_back({{"name", f.name}, {"before", f.before}, {"after", f.after}});
  for (int i = 0; i <= int(Change::Same); i++) numbers[word_of(Change(i))] = c.count(Change(i));
  for (const TestChange& t : c.tests)
    if (t.change != Change::Same)
      tests.push_back({{"name", t.test().name},
                       {"change", word_of(t.change)},
                       {"before", {{"outcome", t.before.outcome}, {"text", t.before.text}}},
                       {"after", {{"outcome", t.after.outcome}, {"text", t.after.text}}}});
  const json whole = {{"before", c.before}, {"after", c.after},  {"worse", c.worse()},
                      {"facts", facts},     {"counts", numbers}, {"tests", tests}};
  return whole.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string changes_as_html(const Comparison& c) {
  std::string page = page_begin("What has changed") + "<table><tr><td>Before<td>" + escaped(c.before) +
                     "<tr><td>After<td>" + escaped(c.after) + "<tr><td>Tests<td>" + counts(c) + "</table>";
  if (!c.facts.empty()) {
    page += "<h2>What the GL says of itself</h2><table><tr><th><th>Before<th>After";
    for (const FactChange& f : c.facts)
      page += "<tr><td>" + escaped(f.name) + (f.name == "extensions" ? " of one only" : "") + "<td>" +
              escaped(f.before) + "<td>" + escaped(f.after);
    page += "</table>";
  }
  Change heading = Change::Same;
  for (const TestChange& t : c.tests) {
    if (t.change == Change::Same) continue;
    if (t.change != heading) page += std::string("<h2>") + word_of(t.change) + "</h2>";
    heading = t.change;
    const bool bad = t.change == Change::NewlyFailing || t.change == Change::NoLongerSupported;
    const std::string &expected = t.after.expected.empty() ? t.before.expected : t.after.expected,
                      &name = t.test().name;
    page += "<section id=\"" + escaped(name) + "\"><h3" + (bad ? " class=fail" : "") + ">" + escaped(name) +
            "</h3><p><b>OpenGL 1.5, " + escaped(t.test().section) + ".</b> " + escaped(t.test().sentence) +
            "</p><p>" + escaped(detail(t)) + "</p>" + figure(expected, "expected") +
            figure(t.before.got, "before") + figure(t.after.got, "after") + "</section>";
  }
  return page + "\n";
}

} // namespace softgl::suite
