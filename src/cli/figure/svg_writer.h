// A drawing as SVG. Pictures are part of the text, as PNG.
#pragma once

#include <string>
#include <string_view>

#include "figure/drawing.h"
#include "image/image_writer.h"

namespace softgl::cli {

// Text between tags and in attributes.
std::string escaped(std::string_view text);

// The element <svg>; `file` makes it a file of its own, in that language ("de").
std::string svg_element(const Drawing& drawing, const std::string& description, PngEffort effort);
std::string svg_file(const Drawing& drawing, const std::string& description, const char* language,
                     PngEffort effort);

} // namespace softgl::cli
