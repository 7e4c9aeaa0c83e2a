// Text over the picture: help and messages.
#pragma once

#include <string>
#include <vector>

#include "image/picture.h"

namespace softgl::cli {

// RGBA: light letters on dark, see-through ground. A line with a tab has two columns; another one that is too
// long for the width, but at least 100 pixels, goes on in the next line. Where the box would be larger than
// asked for, its letters are about half as large.
Picture draw_text_box(const std::vector<std::string>& lines, int most_width, int most_height);

} // namespace softgl::cli
