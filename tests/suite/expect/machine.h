// The specification as a machine: plays a script in double and gives the picture that must come out.
#pragma once

#include "expect/primitive.h"

namespace softgl::suite {

/// What a script says of errors and queries, by the specification.
enum class Claims { Right, Unknown, Wrong };

/// `claims` gets the worst of the script's. Throws std::logic_error for a script that uses what the machine
/// does not know.
Expectation expected_picture(const Script& script, int width, int height, const Precision& precision,
                             Claims* claims = nullptr);

} // namespace softgl::suite
