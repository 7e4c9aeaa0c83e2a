// Pieces of JSON text.
#pragma once

#include <string>
#include <string_view>

namespace softgl::cli {

// Nine significant digits; null for what JSON has no number for.
std::string json_number(double value);
// In quotation marks; the text is UTF-8.
std::string json_string(std::string_view text);

} // namespace softgl::cli
