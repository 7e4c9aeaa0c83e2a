// One command called with random arguments by softgl and by OSMesa, in the same state.
#pragma once

#include <string>

#include "fuzz/any_command.h"

namespace softgl::test {

struct Trial {
  const AnyCommand& command;
  uint64_t seed;
};

/// Who is called at the moment: a crash is that library's.
enum class Player { Nobody, Softgl, OSMesa };

/// Calls the command up to twelve times, at once, in a list or between Begin and End, and compares errors,
/// answers and all state after each call. A command that raised an error in softgl must have left softgl's
/// state as it was. Returns a line for each difference; the trial ends with the first one. `say_calls` writes
/// every call to stdout, too.
std::string play(const Trial& trial, Player& playing, bool say_calls);

} // namespace softgl::test
