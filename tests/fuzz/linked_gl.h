// The library that is linked into the program, so that a fuzzer sees which of its branches an input takes.
#pragma once

#include "support/gl.h"

namespace softgl::test {

const Gl& linked_gl();

} // namespace softgl::test
