// The specification as a machine: plays a script in double and gives the picture that must come out.
#pragma once

#include "expect/primitive.h"

namespace softgl::suite {

/// Throws std::logic_error for a script that uses what the machine does not know.
Expectation expected_picture(const Script& script, int width, int height, const Precision& precision);

} // namespace softgl::suite
