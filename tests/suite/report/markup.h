// Text in HTML and XML, and what the pages share.
#pragma once

#include <string>

namespace softgl::suite {

/// The text with the characters that mean something there, and control characters, replaced.
std::string escaped(const std::string& text);
/// The beginning of a page of HTML, with its style; the title is a heading, too.
std::string page_begin(const std::string& title);
/// A picture and what it is. `png` is a PNG file in base64; empty gives nothing.
std::string figure(const std::string& png, const std::string& caption);

} // namespace softgl::suite
