#include "common/json_text.h"

#include <cmath>
#include <cstdint>
#include <cstdio>

namespace softgl::cli {

std::string json_number(double value) {
  if (!std::isfinite(value)) return "null";
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string json_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = uint8_t(c);
    if (c == '"' || c == '\\')
      (result += '\\') += c;
    else if (byte < 32 || byte == 127) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", byte);
      result += escape;
    } else
      result += c;
  }
  return result + "\"";
}

} // namespace softgl::cli
