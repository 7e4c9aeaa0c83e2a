// Work on a whole surface that all threads share.
#pragma once

#include "surface/framebuffer.h"

namespace softgl {

/// Tells the planes what waits to be written to them (TileWords); the resolver alone reads a surface without.
void write_tiles(Framebuffer& framebuffer);

/// Writes the surface to the caller's buffer.
void resolve(const Surface& surface, const ClientBuffer& client);

} // namespace softgl
