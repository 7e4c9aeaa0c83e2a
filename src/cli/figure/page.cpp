#include "figure/page.h"

#include <algorithm>

#include "image/lettering.h"

namespace softgl::cli {
namespace {

constexpr double kGap = 14, kPageMargin = 24;
constexpr double kLabel = 13, kLabelLine = 18;
constexpr double kText = 17, kTextLine = 25, kHeading = 30;

} // namespace

void append_pictures(Drawing& drawing, std::vector<PageEntry> entries, int columns,
                     const std::string& title) {
  const double width = (kPageWidth - kGap * (columns - 1)) / columns;
  if (!title.empty()) {
    drawing.words({0, drawing.height + 22}, title, 16);
    drawing.height += 34;
  }
  double x = 0, tallest = 0;
  for (PageEntry& entry : entries) {
    const double height = width * entry.picture.height / entry.picture.width;
    tallest = std::max(tallest, height);
    double y = drawing.height + height + kLabelLine;
    drawing.parts.emplace_back(PlacedPicture{{x, drawing.height},
                                             width,
                                             height,
                                             std::make_shared<const Picture>(std::move(entry.picture)),
                                             entry.name,
                                             entry.label});
    if (!entry.label.empty()) {
      drawing.words({x, y}, shortened(entry.label, kLabel, width), kLabel);
      y += kLabelLine;
    }
    if (!entry.formula.empty()) drawing.formula({x, y}, entry.formula, kLabel, Words::kStart, kInk);
    x += width + kGap;
  }
  drawing.height += tallest + 2 * kLabelLine + kGap;
}

Drawing lay_out(Page page) {
  Drawing sheet;
  sheet.width = kPageWidth + 2 * kPageMargin;
  sheet.polygon({{0, 0}, {sheet.width, 0}, {sheet.width, 0}, {0, 0}}, kPaper); // its height follows
  sheet.words({kPageMargin, kPageMargin + kHeading}, page.title, kHeading);
  double y = kPageMargin + kHeading + 34;
  const double drawn = page.drawing.height;
  sheet.append(std::move(page.drawing), {kPageMargin, y});
  y += drawn + 16;
  for (const std::string& formula : page.formulas) {
    y += 32;
    sheet.formula({kPageMargin, y}, formula, 22, Words::kStart, kBlue);
  }
  y += 14;
  for (const std::string& sentence : page.sentences)
    for (const std::string& line : text_lines(sentence, kText, kPageWidth)) {
      y += kTextLine;
      sheet.formula({kPageMargin, y}, line, kText);
    }
  sheet.height = y + kPageMargin;
  auto& paper = std::get<Shape>(sheet.parts.front());
  paper.points[2].y = paper.points[3].y = sheet.height;
  return sheet;
}

std::string plain_formula(const std::string& formula) {
  std::string text;
  for (const char c : formula)
    if (c != '_') text += c;
  return text;
}

} // namespace softgl::cli
