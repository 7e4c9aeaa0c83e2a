// Work on a whole surface that all threads share.
#pragma once

#include "surface/accumulation.h"
#include "surface/framebuffer.h"

namespace softgl {

/// Tells the planes what waits to be written to them (TileWords); the resolver alone reads a surface without.
void write_tiles(Framebuffer& framebuffer);

/// Does an operation of the accumulation buffer, which must have memory; if it has to do with colors, nothing
/// may wait to be written to the planes.
void accumulate(Framebuffer& framebuffer, const Accumulation& accumulation);

/// Writes the surface to the caller's buffer.
void resolve(const Surface& surface, const ClientBuffer& client);

} // namespace softgl
