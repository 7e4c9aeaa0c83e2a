// Images with a border of texels (GL 1.5, 3.8.1 and 3.8.8). Where one is sampled, its texels are numbered
// from the border on.
#pragma once

#include "shaders/texture/texture_fetch.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Texels -1 to `sizes`, the border included. GL_CLAMP_TO_BORDER is clamped to half a texel beyond the edge
/// (3.8.7).
template <class Sizes>
static inline void number_from_border(const FragmentBlock& block, Sizes sizes, int32_t* __restrict texel) {
  SOFTGL_FOR_LANES(block, i) texel[i] = clamp_int(texel[i], -1, sizes[i]) + 1;
}

/// Images whose first texel is the border's. `lanes`: 1 where all share one image.
template <class Images>
static inline void take_in_border(int32_t lanes, const TextureUnitConstants& t, Images& images) {
  const bool rows = t.shape != TextureShape::OneD, slices = t.shape == TextureShape::ThreeD;
  const bool halves = t.texel == TextureTexel::Rgba16 || t.texel == TextureTexel::Signed16;
  const int32_t bytes = t.texel == TextureTexel::Float ? 16 : halves ? 8 : 4;
  for (int32_t i = 0; i < lanes; ++i) {
    const int32_t texels = 1 + (rows ? images.row[i] : 0) + (slices ? images.slice[i] : 0);
    images.texels[i] -= size_t(texels) * size_t(bytes);
    images.width[i] += 2;
    if (rows) images.height[i] += 2;
    if (slices) images.depth[i] += 2;
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
