// What the vertex kernels work on: up to 64 vertices of one draw, structure of arrays.
#pragma once

#include "shaders/common/lighting.h"
#include "shaders/vertex/vertex_program.h"

namespace softgl {

struct alignas(64) VertexBlock {
  int32_t lanes; // multiple of kStripLanes; lanes behind the last vertex have inputs of zero
  alignas(64) float position[4][kLanes]; // object coordinates
  float color[4][kLanes], secondary[3][kLanes], fog[kLanes];
  float clip[4][kLanes], window[4][kLanes], point[kLanes];
  int32_t mask[kLanes];   // ClipBit
  LightingBlock lighting; // also holds the normal and the eye position for other stages
  float texcoord[kMaxTextureUnits][4][kLanes];
  float material[kMaterialSlots][4][kLanes];
};

} // namespace softgl
