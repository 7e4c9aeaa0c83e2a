#include "obj/number_parser.h"

#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

namespace softgl::cli {

namespace {
struct TokenEnds {
  bool table[256] = {};
  constexpr explicit TokenEnds(bool comment) {
    for (const unsigned char c : {' ', '\t', '\n', '\r', '\v', '\f', '\0', '\\'}) table[c] = true;
    table[uint8_t('#')] = comment;
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

// Behind the '.' at `mark - 1`: what older C libraries of Windows print, #QNAN, #SNAN, #IND, #INF, or J and R
// where they round that, and zeros up to the wanted number of digits. The end of the token, or null.
const char* end_of_windows_word(const char* mark) {
  for (const std::string_view word : {"#QNAN", "#SNAN", "#IND", "#INF", "#J", "#R"}) {
    size_t length = 0;
    while (length < word.size() && mark[length] == word[length]) ++length;
    if (length < word.size()) continue;
    const char* p = mark + length;
    while (*p >= '0' && *p <= '9') ++p;
    if (ends_token(*p)) return p;
  }
  return nullptr;
}
} // namespace

#define SOFTGL_ROW(t, n) \
  (t)[n], (t)[(n) + 1], (t)[(n) + 2], (t)[(n) + 3], (t)[(n) + 4], (t)[(n) + 5], (t)[(n) + 6], (t)[(n) + 7]
#define SOFTGL_ROWS(t, n) \
  SOFTGL_ROW(t, n), SOFTGL_ROW(t, (n) + 8), SOFTGL_ROW(t, (n) + 16), SOFTGL_ROW(t, (n) + 24)
#define SOFTGL_TABLE(t) \
  { \
    SOFTGL_ROWS(t, 0), SOFTGL_ROWS(t, 32), SOFTGL_ROWS(t, 64), SOFTGL_ROWS(t, 96), SOFTGL_ROWS(t, 128), \
        SOFTGL_ROWS(t, 160), SOFTGL_ROWS(t, 192), SOFTGL_ROWS(t, 224) \
  }
constexpr TokenEnds kTokenEnds(true), kNumberEnds(false);
const bool kEndsToken[256] = SOFTGL_TABLE(kTokenEnds.table);
const bool kEndsNumber[256] = SOFTGL_TABLE(kNumberEnds.table);

bool read_unusual_number(const char*& cursor, double& value) {
  const char* first = cursor;
  const char* last = first;
  while (!ends_token(*last)) ++last;
  cursor = last;
  if (*last == '#' && last > first && last[-1] == '.') {
    if (const char* end = end_of_windows_word(last)) {
      cursor = end;
      value = std::numeric_limits<double>::quiet_NaN(); // an infinite one is of no more use
      return true;
    }
  }
  return read_exactly(first, last, value);
}

bool has_decimal_comma(const char* token) {
  const auto digits = [](const char*& p) {
    const char* first = p;
    while (*p >= '0' && *p <= '9') ++p;
    return p > first;
  };
  const char* p = token;
  p += *p == '-' || *p == '+';
  if (!digits(p) || *p != ',' || !digits(++p)) return false;
  if ((*p | 32) == 'e') {
    ++p;
    p += *p == '-' || *p == '+';
    if (!digits(p)) return false;
  }
  return ends_token(*p);
}

float round_to_float_exactly(const char* first, const char* last, double value) {
  float exact;
  return read_exactly(first, last, exact) ? exact : float(value);
}

} // namespace softgl::cli
