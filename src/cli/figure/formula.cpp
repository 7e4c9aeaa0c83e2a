#include "figure/formula.h"

#include "image/lettering.h"

namespace softgl::cli {
namespace {

size_t letter_length(unsigned char first) {
  return first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
}

} // namespace

std::vector<FormulaRun> formula_runs(std::string_view text) {
  std::vector<FormulaRun> runs;
  const auto add = [&runs](FormulaRun::Level level, std::string_view part) {
    if (runs.empty() || runs.back().level != level) runs.push_back({level, {}});
    runs.back().text += part;
  };
  for (size_t at = 0; at < text.size();) {
    const char c = text[at];
    if ((c != '_' && c != '^') || at + 1 >= text.size()) {
      add(FormulaRun::kBase, text.substr(at++, 1));
      continue;
    }
    const auto level = c == '_' ? FormulaRun::kBelow : FormulaRun::kAbove;
    const size_t close = text.find('}', ++at);
    if (text[at] == '{' && close != std::string_view::npos) {
      add(level, text.substr(at + 1, close - at - 1));
      at = close + 1;
    } else {
      const size_t length = letter_length(static_cast<unsigned char>(text[at]));
      add(level, text.substr(at, length));
      at += length;
    }
  }
  return runs;
}

double formula_width(std::string_view text, double size) {
  double width = 0;
  for (const FormulaRun& run : formula_runs(text))
    width += text_width(run.text, run.level == FormulaRun::kBase ? size : size * kSmallLetters);
  return width;
}

} // namespace softgl::cli
