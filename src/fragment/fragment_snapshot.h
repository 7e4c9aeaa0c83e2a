// From State to the fragment program of a draw.
#pragma once

#include "base/arena.h"
#include "fragment_program.h"

namespace softgl {

struct Context;

/// The program that the context's state asks for, in `arena`. `key` tells which inputs the vertices must carry:
/// secondary colour, fog coordinate and the texture coordinates of the units in texture_units.
const FragmentProgram* make_fragment_program(Context& context, Arena& arena);

} // namespace softgl
