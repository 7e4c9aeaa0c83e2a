// Tiles of a texture's image between its texels and the plane that is drawn to.
#pragma once

#include <cstdint>

#include "surface/render_plane.h"

namespace softgl {

struct TextureImage;

// Of pixels with several samples, sample number `sample`.

/// Sets the plane's tile from the texels of slice `z`. Stencil values that the
/// image does not have stay what they are.
void load_tile(RenderPlane& plane, const TextureImage& image, int z, uint32_t tile, int sample);
/// Sets the texels of slice `z` from the plane's tile, if it has changed.
void store_tile(RenderPlane& plane, TextureImage& image, int z, uint32_t tile, int sample);

} // namespace softgl
