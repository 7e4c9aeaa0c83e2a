// The lighting of fragments (GL_WIN_phong_shading): the kernel that lights vertices, with fragments as its
// lanes.
#pragma once

#include <string.h>

#include "shaders/common/lighting.inl"
#include "shaders/fragment/fragment_program.h"

namespace softgl {
namespace SOFTGL_ISA {

/// Colors from the block's normals, eye positions and materials. They are clamped to [0,1] as those of
/// vertices are (GL 1.5, 2.14.6), so that nothing behind sees what is not a number.
static void stage_light(FragmentBlock& block, const FragmentConstants& constants, int) {
  const LightingConstants& k = *constants.lighting;
  LightingBlock& b = block.lighting;
  const int n = b.lanes = block.lanes;
  if (k.light_count) {
    unit_lanes(b.normal, b.normal, n);
    if (k.local_viewer) unit_lanes(b.eye, b.eye_unit, n);
  }
  light_block(b, k, material_lanes(k, [&](int slot) {
                return slot == kColor ? block.color : block.material[slot - kMaterial0];
              }));

  const int32_t* back = block.back;
  auto finish = [&](const float* front_color, const float* back_color, float* out) {
    if (k.two_sided) {
      SOFTGL_FOR_LANES(i, n) out[i] = saturate(select(back[i], back_color[i], front_color[i]));
    } else {
      SOFTGL_FOR_LANES(i, n) out[i] = saturate(front_color[i]);
    }
  };
  for (int c = 0; c < 4; ++c) finish(b.color[0][c], b.color[1][c], block.color[c]);
  if (k.separate_specular)
    for (int c = 0; c < 3; ++c) finish(b.secondary[0][c], b.secondary[1][c], block.secondary[c]);
}

} // namespace SOFTGL_ISA
} // namespace softgl
