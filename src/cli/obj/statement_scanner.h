// Reads one statement of an OBJ file after the other: blanks, continued lines, comments, numbers.
#pragma once

#include <algorithm>
#include <cstring>
#include <limits>
#include <string_view>

#include "obj/number_parser.h"

namespace softgl::cli {

struct StatementScanner {
  const char* p; // the text ends with a zero byte behind `end`
  const char* end;
  const char* statement = nullptr; // where the present one begins, for messages

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\0' || c == '\\'; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }

  // Blanks, NUL bytes inside the text and line continuations.
  void skip_blanks() {
    for (;;) {
      if (*p == ' ' || *p == '\t') {
        ++p;
      } else if (*p == '\\' && p + 1 < end && is_line_end(p[1])) {
        p += p[1] == '\r' && p[2] == '\n' ? 3 : 2;
      } else if ((*p == '\0' && p < end) || *p == '\v' || *p == '\f') {
        ++p;
      } else {
        return;
      }
    }
  }

  bool at_statement_end() const { return is_line_end(*p) || *p == '#' || p >= end; }

  void skip_token() {
    if (*p == '\\' || *p == '#') ++p;
    while (!ends_token(*p)) ++p;
  }

  // To the next line; a comment is not continued by a backslash.
  void finish_line() {
    // Piece by piece: a file may have no line feed at all.
    for (size_t piece; p < end; p += piece) {
      piece = std::min<size_t>(size_t(end - p), 1024);
      const auto* line_feed = static_cast<const char*>(std::memchr(p, '\n', piece));
      const size_t length = line_feed ? size_t(line_feed - p) : piece;
      const auto* carriage_return = static_cast<const char*>(std::memchr(p, '\r', length));
      if (!line_feed && !carriage_return) continue;
      p = (carriage_return ? carriage_return : line_feed) + 1;
      return;
    }
  }

  void end_statement() {
    if (*p == '\n' && p < end) {
      ++p;
      return;
    }
    skip_tokens(); // more than the statement needs, such as a fourth texture coordinate
    if (p >= end) return;
    finish_line();
  }

  // Up to `limit` numbers; the rest is left. `bad` becomes the first token that is no number.
  template <class T> int numbers(T* values, int limit, const char*& bad) {
    int count = 0;
    for (; count < limit; ++count) {
      skip_blanks();
      if (at_statement_end()) break;
      const char* token = p;
      if (!read_number(p, values[count])) {
        if (p == token) skip_token();
        values[count] = std::numeric_limits<T>::quiet_NaN();
        if (!bad) bad = token;
      }
    }
    return count;
  }

  // The rest of the line, without blanks at its ends, continued lines included as they stand.
  std::string_view rest_of_line() {
    skip_blanks();
    const char* first = p;
    skip_rest();
    if (p > end) p = end;
    const char* last = p;
    while (last > first && ends_token(last[-1]) && last[-1] != '#' && last[-1] != '\\') --last;
    return {first, size_t(last - first)};
  }

  void skip_rest() {
    while (p < end && !is_line_end(*p)) {
      if (*p == '\\' && p + 1 < end && is_line_end(p[1])) p += p[1] == '\r' && p[2] == '\n' ? 2 : 1;
      ++p;
    }
  }

  // The rest of the statement, which is of no use.
  void skip_tokens() {
    while (!at_statement_end()) {
      skip_token();
      skip_blanks();
    }
  }
};

} // namespace softgl::cli
