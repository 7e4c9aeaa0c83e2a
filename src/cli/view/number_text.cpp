#include "view/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace softgl::cli {

std::string fixed_text(double value, int digits) {
  char buffer[512]; // the largest double has 309 digits before the point
  const auto [end, failed] = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed,
                                           std::clamp(digits, 0, 100));
  if (failed != std::errc()) return "0";
  std::string text(buffer, end);
  if (text.find('.') != std::string::npos) {
    text.resize(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string triple_text(const std::array<double, 3>& values, int digits) {
  return fixed_text(values[0], digits) + "," + fixed_text(values[1], digits) + "," +
         fixed_text(values[2], digits);
}

std::string significant_text(double value, int digits) {
  const int before = value == 0 ? 1 : int(std::floor(std::log10(std::fabs(value)))) + 1;
  return fixed_text(value, digits - before);
}

std::string shortest_text(float value) {
  char buffer[64];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

} // namespace softgl::cli
