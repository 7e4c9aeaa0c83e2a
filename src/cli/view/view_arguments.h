// The window's state and the command line say the same.
#pragma once

#include "options/command_line.h"
#include "view/view_state.h"

namespace softgl::cli {

// The state that the options of a picture mean, for these models. Throws ProgramError (kUsageError) for
// options that no window has.
ViewState state_of(const ParsedOptions& parsed, const std::vector<std::string>& models);

// The arguments of `softgl` that make the picture of the state, without an output. Numbers are rounded to
// what can be seen.
std::vector<std::string> to_arguments(const ViewState& state);

// The words as a shell takes them.
std::string command_line(const std::vector<std::string>& arguments);

} // namespace softgl::cli
