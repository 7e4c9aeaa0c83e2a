// Letters on a picture: of the program's typeface, or where it was built without one, plain letters of ASCII.
#pragma once

#include <string>
#include <string_view>

#include "image/shape_filling.h"

namespace softgl::cli {

// Of one line of UTF-8. `size` is about the height of an accented capital with its descent, in pixels.
double text_width(std::string_view text, double size);

// One line of UTF-8 on an RGB picture, from (x, y) on, which is on the line that the letters stand on.
void draw_text(Picture& picture, double x, double y, double size, std::string_view text, const Color& color);

// What the plain letters make of a text: ASCII, with names for some Greek letters.
std::string ascii_only(std::string_view text);

// The text without as much of its middle as makes it wider than `most`.
std::string shortened(const std::string& text, double size, double most);

} // namespace softgl::cli
