#include "obj/number_parser.h"

#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>

namespace softgl::cli {

namespace {
struct TokenEnds {
  bool table[256] = {};
  constexpr TokenEnds() {
    for (const unsigned char c : {' ', '\t', '\n', '\r', '\v', '\f', '\0', '#', '\\'}) table[c] = true;
  }
};

template <class T> bool read_exactly(const char* first, const char* last, T& value) {
  if (last - first >= 2 && *first == '+') { // from_chars knows no plus
    ++first;
    if (*first == '+' || *first == '-') return false;
  }
  const auto result = std::from_chars(first, last, value);
  if (result.ptr != last) return false;
  if (result.ec == std::errc::result_out_of_range) {
    // from_chars leaves the value alone; strtod says whether it is 0, denormal or infinite.
    const std::string token(first, last);
    if constexpr (sizeof(T) == sizeof(double))
      value = std::strtod(token.c_str(), nullptr);
    else
      value = std::strtof(token.c_str(), nullptr);
    return true;
  }
  return result.ec == std::errc();
}
} // namespace

constexpr TokenEnds kTokenEnds;
const bool kEndsToken[256] = {
#define SOFTGL_ROW(n) \
  kTokenEnds.table[n], kTokenEnds.table[(n) + 1], kTokenEnds.table[(n) + 2], kTokenEnds.table[(n) + 3], \
      kTokenEnds.table[(n) + 4], kTokenEnds.table[(n) + 5], kTokenEnds.table[(n) + 6], \
      kTokenEnds.table[(n) + 7]
#define SOFTGL_ROWS(n) SOFTGL_ROW(n), SOFTGL_ROW((n) + 8), SOFTGL_ROW((n) + 16), SOFTGL_ROW((n) + 24)
    SOFTGL_ROWS(0),   SOFTGL_ROWS(32),  SOFTGL_ROWS(64),  SOFTGL_ROWS(96),
    SOFTGL_ROWS(128), SOFTGL_ROWS(160), SOFTGL_ROWS(192), SOFTGL_ROWS(224)};

bool read_unusual_number(const char* first, const char* last, double& value) {
  if (read_exactly(first, last, value)) return true;
  // What older C libraries of Windows print: 1.#QNAN, -1.#IND, 1.#INF ('#' has ended the token).
  if (last - first >= 2 && last[-1] == '.' && last[0] == '#') {
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  return false;
}

float round_to_float_exactly(const char* first, const char* last, double value) {
  float exact;
  return read_exactly(first, last, exact) ? exact : float(value);
}

} // namespace softgl::cli
