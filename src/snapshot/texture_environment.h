// Texture environments as combiners (GL 1.5, 3.8.13, tables 3.22 to 3.25).
#pragma once

#include "context/state.h"
#include "texture/combiner_chain.h"

namespace softgl {

/// `base` is the base format of the texel; `sampled` has the units that are sampled, by bit: the texels of
/// others are 0 (crossbar).
CombinerChain::Unit make_environment(const TextureUnitState& state, int unit, GLenum base, uint32_t sampled);

/// The environment is previous * texel in all components (`base` has), or the texel itself.
bool is_modulate(const CombinerChain::Unit& environment, int unit, GLenum base);
bool is_replace(const CombinerChain::Unit& environment, int unit);

} // namespace softgl
