// Random commands that change state, with good and with bad arguments.
#pragma once

#include <functional>
#include <string>

#include "support/gl.h"
#include "support/random.h"

namespace softgl::test {

struct StateCommand {
  std::string text;
  std::function<void(const Gl&)> run;
};

StateCommand random_state_command(Random& random);

} // namespace softgl::test
