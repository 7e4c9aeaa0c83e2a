// Numbers as text for a command line, with a point in every language.
#pragma once

#include <array>
#include <string>

namespace softgl::cli {

// With at most so many digits behind the point, and no zeros at the end.
std::string fixed_text(double value, int digits);
std::string triple_text(const std::array<double, 3>& values, int digits); // x,y,z
std::string significant_text(double value, int digits);
// The shortest text that is this float again.
std::string shortest_text(float value);

} // namespace softgl::cli
