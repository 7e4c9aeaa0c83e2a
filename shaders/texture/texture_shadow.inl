// Depth textures that are compared with r: shadows (GL 1.5, 3.8.14).
#pragma once

#include "shaders/texture/texture_fetch.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// r is clamped as the texels are, unless they are floats (GL_ARB_depth_buffer_float, 3.8.14).
static inline float compared_r(const TextureUnitConstants& t, float r) {
  return t.texel == TextureTexel::DepthFloat ? r : saturate(r);
}

/// 1 where r passes the comparison with the texel or the border, else 0.
template <class Images> static inline void compare_texels(const FragmentBlock& block,
                                                          const BlockCoordinates& c,
                                                          const TextureUnitConstants& t, Images images,
                                                          const TexelPlaces& at, float* __restrict out) {
  alignas(64) float texel[kLanes];
  fetch_depths(block, t, images, at, texel);
  const auto compare = [&](auto test) {
    SOFTGL_FOR_LANES(block, i) out[i] = keep(mask_of(test(compared_r(t, c.r[i]), texel[i])), 1.0f);
  };
  switch (t.compare_function) {
  case 0: return compare([](float, float) { return false; });
  case 1: return compare([](float r, float d) { return r < d; });
  case 2: return compare([](float r, float d) { return r == d; });
  case 3: return compare([](float r, float d) { return r <= d; });
  case 4: return compare([](float r, float d) { return r > d; });
  case 5: return compare([](float r, float d) { return r != d; });
  case 6: return compare([](float r, float d) { return r >= d; });
  default: return compare([](float, float) { return true; });
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
