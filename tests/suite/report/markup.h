// Text in HTML and XML.
#pragma once

#include <string>

namespace softgl::suite {

/// The text with the characters that mean something there, and control characters, replaced.
std::string escaped(const std::string& text);

} // namespace softgl::suite
