// Calls that OSMesa answers otherwise than softgl does, each for a reason in reference/DEVIATIONS.md.
#pragma once

#include <string_view>

#include "fuzz/arguments.h"

namespace softgl::test {

/// True if the two libraries are not to be compared on this call, in the state that `gl` has. The call is
/// left out of both: their state stays the same.
bool differs_on_purpose(std::string_view command, const Arguments& arguments, const Gl& gl, bool in_list);

} // namespace softgl::test
