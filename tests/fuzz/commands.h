// Random commands with arguments that nobody should give.
#pragma once

#include <string>

#include "support/gl.h"
#include "support/random.h"

namespace softgl::test {

/// Arguments of one command: the same for every library that gets it.
struct FuzzCommand {
  const char* name;
  void (*call)(const Gl& gl, Random& random);
};

/// Points all arrays at memory that exists: an array that is enabled before it was set crashes OSMesa.
void set_up_arrays(const Gl& gl);

/// All commands of the fuzzer. They read and write only memory that exists, whatever GL makes of their
/// arguments.
const FuzzCommand& random_fuzz_command(Random& random);

} // namespace softgl::test
