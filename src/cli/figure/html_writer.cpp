#include "figure/html_writer.h"

#include "figure/formula.h"
#include "figure/svg_writer.h"

namespace softgl::cli {
namespace {

constexpr const char* kStyle = R"(
body { font: 18px/1.5 "DejaVu Sans", Verdana, sans-serif; color: #22262b; background: #fff; margin: 0 auto; max-width: 1060px;
  padding: 0 24px 60px; }
h1 { font-size: 34px; margin: 40px 0 10px; }
h2 { font-size: 26px; margin: 0 0 16px; }
section { border-top: 1px solid #dde1e5; margin-top: 40px; padding-top: 28px; break-inside: avoid; }
svg { display: block; width: 100%; height: auto; margin-bottom: 14px; }
.formula { color: #1f5fa8; font-size: 21px; margin: 6px 0; }
sub, sup { line-height: 0; }
p { margin: 4px 0; }
nav ol { columns: 2; padding-left: 1.6em; }
a { color: #1f5fa8; text-decoration: none; }
@media print { section { break-before: page; border: 0; } nav { display: none; } }
)";

std::string formula_markup(const std::string& formula) {
  std::string text;
  for (const FormulaRun& run : formula_runs(formula)) {
    const char* tag = run.level == FormulaRun::kBelow   ? "sub"
                      : run.level == FormulaRun::kAbove ? "sup"
                                                        : nullptr;
    text += tag ? "<" + std::string(tag) + ">" + escaped(run.text) + "</" + tag + ">" : escaped(run.text);
  }
  return text;
}

} // namespace

std::string html_document(std::vector<Page> pages, Language language, PngEffort effort) {
  const std::string title =
      pages.size() == 1
          ? pages.front().title
          : Wording{"Phong's illumination model", "Das Phongsche Beleuchtungsmodell"}.in(language);
  std::string text = "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"";
  text += Wording{"en", "de"}.in(language);
  text += "\">\n<head>\n<meta charset=\"UTF-8\"/>\n<meta name=\"viewport\" "
          "content=\"width=device-width\"/>\n<title>" +
          escaped(title) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n";
  if (pages.size() > 1) {
    text += "<h1>" + escaped(title) + "</h1>\n<nav>\n<ol>\n";
    for (const Page& page : pages)
      text += "<li><a href=\"#" + escaped(page.name) + "\">" + escaped(page.title) + "</a></li>\n";
    text += "</ol>\n</nav>\n";
  }
  for (Page& page : pages) {
    text += "<section id=\"" + escaped(page.name) + "\">\n<h2>" + escaped(page.title) + "</h2>\n";
    page.drawing.width = kPageWidth;
    text += svg_element(page.drawing, page.title, effort);
    for (const std::string& formula : page.formulas)
      text += "<p class=\"formula\">" + formula_markup(formula) + "</p>\n";
    for (const std::string& sentence : page.sentences) text += "<p>" + formula_markup(sentence) + "</p>\n";
    text += "</section>\n";
  }
  return text + "</body>\n</html>\n";
}

} // namespace softgl::cli
