// The pixel transfer that the state asks for (GL 1.5, 3.6.3).
#pragma once

#include "context/context.h"
#include "texture/pixel_transfer.h"

namespace softgl {

inline PixelTransfer pixel_transfer(const Context& c) { return {c.state.pixel_mode, c.state.pixel_maps}; }

} // namespace softgl
