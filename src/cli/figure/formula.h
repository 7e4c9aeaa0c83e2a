// Formulas as one line of text: k_a is k with a small a below it, (v·r)^a one with a small a above, and
// braces hold more than one letter: L^{4a}.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace softgl::cli {

struct FormulaRun {
  enum Level { kBase, kBelow, kAbove } level;
  std::string text;
};

std::vector<FormulaRun> formula_runs(std::string_view text);

// Of letters below and above the line: their size, and how far they are moved, as parts of the size of the
// others.
inline constexpr double kSmallLetters = 0.7, kMovedDown = 0.22, kMovedUp = 0.4;

double formula_width(std::string_view text, double size);

} // namespace softgl::cli
