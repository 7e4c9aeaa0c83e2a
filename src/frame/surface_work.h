// Work on a whole surface that all threads share.
#pragma once

#include "surface/accumulation.h"
#include "surface/framebuffer.h"
#include "surface/texel_tiles.h"

namespace softgl {

/// Writes the words that wait (TileWords) to the planes. All readers of a surface need it but the resolver.
void write_tiles(RenderTarget& target);

/// All of the plane from the texels of a slice, and the texels from what has changed of the plane.
void load_plane(RenderPlane& plane, const TextureImage& image, int slice, int sample = 0);
void store_plane(RenderPlane& plane, TextureImage& image, int slice, int sample = 0);
/// True where something was drawn to the plane since it was loaded or stored.
bool has_changed(const RenderPlane& plane);

/// Does an operation of the accumulation buffer, which must have memory; if it has to do with colors, nothing
/// may wait to be written to the planes.
void accumulate(Framebuffer& framebuffer, const Accumulation& accumulation);

/// Brings the pixels up to date that are read of a window with several samples a pixel. No draws may wait.
void resolve_samples(Framebuffer& framebuffer);

/// Writes the surface to the caller's buffer.
void resolve(const Surface& surface, const ClientBuffer& client);

} // namespace softgl
