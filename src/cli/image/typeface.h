// The typeface of labels: a TrueType font that is part of the program.
#pragma once

#include <span>

namespace softgl::cli {

// The font's file; empty where the program was built without one.
std::span<const unsigned char> typeface();

} // namespace softgl::cli
