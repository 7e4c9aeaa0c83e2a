// The stages behind texturing.
#pragma once

#include "shaders/fragment/fragment_program.h"

namespace softgl {

/// Adds color sum, fog and alpha test, as program.key asks for them.
void append_fragment_stages(FragmentProgram& program);

/// The same program for antialiased primitives (GL 1.5, 3.11): coverage stands in front of the alpha test.
FragmentProgram with_coverage(const FragmentProgram& program, Coverage coverage);

} // namespace softgl
