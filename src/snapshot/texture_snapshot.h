// From State to the texture stages of a fragment program.
#pragma once

#include "base/arena.h"
#include "shaders/fragment/fragment_program.h"

namespace softgl {

struct Context;

/// Adds the sampling and environment stages of all enabled, complete units to `program`, marks the units in
/// program.key.texture_units and points constants.texture[unit] at their constants, which lie in `arena`.
/// Where they make the color sum, too, program.key.color_sum is 0 afterwards. The frame keeps the images.
void append_texture_stages(Context& context, Arena& arena, FragmentProgram& program,
                           FragmentConstants& constants);

} // namespace softgl
