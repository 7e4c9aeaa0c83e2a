// Colors between a plane that is drawn to and the texels of an image.
#pragma once

#include "shaders/common/surface.h"
#include "texture/texel_format.h"

namespace softgl {

/// `count` pixels of a plane, stored as `storage`, as texels of the format that is drawn to.
void pixels_to_texels(const TexelFormat& format, ColorFormat storage, const void* pixels, int count,
                      void* texels);
void texels_to_pixels(const TexelFormat& format, ColorFormat storage, const void* texels, int count,
                      void* pixels);

} // namespace softgl
