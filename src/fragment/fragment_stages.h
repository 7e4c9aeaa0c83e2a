// The stages behind texturing.
#pragma once

#include "shaders/fragment/fragment_program.h"

namespace softgl {

/// Adds color sum, fog and alpha test, as program.key asks for them.
void append_fragment_stages(FragmentProgram& program);

} // namespace softgl
