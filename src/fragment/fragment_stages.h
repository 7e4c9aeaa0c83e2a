// The stages behind texturing.
#pragma once

#include "shaders/fragment/fragment_program.h"

namespace softgl {

/// Adds color sum, fog and alpha test, as program.key and its constants ask for them. `clamp`: colors are
/// clamped to [0, 1] before the alpha test. `clamp_sum`: they are so before the fog.
void append_fragment_stages(FragmentProgram& program, bool clamp = false, bool clamp_sum = false);

/// The same program for antialiased primitives (GL 1.5, 3.11): coverage stands in front of the alpha test.
FragmentProgram with_coverage(const FragmentProgram& program, Coverage coverage);

} // namespace softgl
