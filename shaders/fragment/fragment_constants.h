// The numbers of a fragment program: an immutable snapshot per draw.
#pragma once

#include <stdint.h>

#include "shaders/fragment/fragment_block.h"
#include "shaders/fragment/fragment_key.h"

namespace softgl {

struct CombinerProgram;      // combiner_program.h
struct LightingConstants;    // lighting.h
struct PixelImage;           // pixel_image.h
struct TextureUnitConstants; // texture_constants.h

struct FragmentConstants {
  float fog_color[4];
  float fog_scale, fog_offset; // linear: f = c * scale + offset; exp, exp2: the (scaled) density is fog_scale
  float alpha_reference;       // clamped to [0,1]
  int32_t alpha_reference_8;   // the same in 1/255, rounded
  float blend_color[4];
  uint8_t blend_color_8[4];
  ColorEncoding encoding;          // of the surface's colors; not srgb where sRGB is switched off
  BlendEquation blend_equation[2]; // of rgb and of alpha, where the key says BlendEquation::Separate
  uint8_t stencil_reference, stencil_value_mask, stencil_write_mask;
  uint32_t least_depth, greatest_depth; // of the stage that clamps depths, in the depth buffer's integers
  uint32_t least_bound, greatest_bound; // of the depth bounds test, in the depth buffer's integers
  const LightingConstants* lighting;    // null where fragments are not lit
  const TextureUnitConstants* texture[kMaxTextureUnits]; // null where a unit is off
  const CombinerProgram* combiner; // null where every environment has a stage of its own
  const PixelImage* image;         // of pixel rectangles; else null
};

} // namespace softgl
