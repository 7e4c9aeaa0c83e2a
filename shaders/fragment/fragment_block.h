// What the fragment kernels work on: up to 64 fragments of one draw, structure of arrays.
#pragma once

#include "shaders/common/lighting.h"
#include "shaders/common/limits.h"
#include "shaders/common/surface.h"
#include "shaders/common/vertex_attributes.h"

namespace softgl {

struct FragmentConstants; // fragment_constants.h

/// Texture coordinates of one unit, already divided by q, and their differences in the fragment's 2x2 quad:
/// right minus left and lower minus upper, both from the quad's top left pixel; of cube maps those of the
/// fragment's own row and column.
struct BlockCoordinates {
  float s[kLanes], t[kLanes], r[kLanes];
  float ds_dx[kLanes], dt_dx[kLanes], dr_dx[kLanes];
  float ds_dy[kLanes], dt_dy[kLanes], dr_dy[kLanes];
};

/// Numbers that tell how much of a pixel an antialiased primitive covers, at most (fragment_coverage.inl).
constexpr int kCoverageNumbers = 9;

/// Stages run over lanes [0, lanes); lanes is a multiple of 16. In blocks cut from a large triangle each
/// strip of 16 lanes is an 8x2-pixel strip of the surface; in blocks gathered from small triangles every lane
/// is on its own, so no stage may look at a neighbouring lane unless its program says so (reads_quads): then
/// lanes i, i + 1, i + 8 and i + 9 are always a 2x2 quad, though each of another place.
struct alignas(64) FragmentBlock {
  int32_t lanes;
  alignas(64) int32_t x[kLanes], y[kLanes]; // window coordinates of the pixel, y down
  uint32_t live[kLanes];  // ~0u: still to be written; 0: dead (its other values are finite but meaningless)
  uint32_t depth[kLanes]; // fragment depth in the depth buffer's integers
  float color[4][kLanes]; // running color r g b a: primary, then after texturing, color sum, fog
  float secondary[3][kLanes]; // secondary color
  float fog[kLanes];          // fog coordinate
  BlockCoordinates unit[kMaxTextureUnits];
  // Where fragments are lit: normal and eye position are in `lighting`, a vertex color that feeds the
  // material in `color`.
  LightingBlock lighting;
  float material[kMaterialSlots][4][kLanes];
  int32_t back[kLanes];                     // ~0: of a back-facing polygon; set with two-sided lighting
  float coverage[kCoverageNumbers][kLanes]; // of antialiased primitives: what their coverage is made of
};

/// A stage of a fragment program. `unit` is the texture unit for texture stages, else 0.
using FragmentStage = void (*)(FragmentBlock& block, const FragmentConstants& constants, int unit);

} // namespace softgl
