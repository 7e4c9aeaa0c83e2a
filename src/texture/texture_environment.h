// Texture environments as combiners (GL 1.5, 3.8.13, tables 3.22 to 3.25).
#pragma once

#include "state/state.h"
#include "texture_constants.h"

namespace softgl {

/// Fills colour, functions, arguments and scales. `base` is the base format of the texel; `sampled` has the units that
/// are sampled, by bit: the texels of others are 0 (crossbar).
void set_environment(const TextureUnitState& state, int unit, GLenum base, uint32_t sampled, TextureUnitConstants& constants);

/// True if any argument that the functions use has this source.
bool reads_source(const TextureUnitConstants& constants, CombineSource source);
/// The environment is previous * texel in all components, or the texel itself.
bool is_modulate(const TextureUnitConstants& constants, int unit);
bool is_replace(const TextureUnitConstants& constants, int unit);

} // namespace softgl
