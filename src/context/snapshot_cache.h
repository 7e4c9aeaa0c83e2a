// The snapshot blocks that the next draw may use again, in the arena of the frame being built.
#pragma once

#include "shaders/common/shaded_vertex.h"
#include "shaders/vertex/vertex_program.h"

namespace softgl {

struct RasterConstants;
struct FragmentProgram;

struct SnapshotCache {
  const TransformConstants* transform = nullptr;
  const ClipPlaneConstants* clip_planes = nullptr;
  const LightingConstants* lighting = nullptr;
  const CoordinateConstants* coordinates[8] = {};
  const VertexProgram* vertex = nullptr;
  const RasterConstants* raster = nullptr;
  const FragmentProgram* fragment = nullptr;         // as the state asks for it
  const FragmentProgram* fragment_of_draw = nullptr; // the same; where it lights fragments, with the lights
  ShadedLayout layout;
  // What the blocks were made for, beyond the dirty bits.
  uint32_t present = 0; // attribute streams
  float color[4] = {};  // the draw's constant colour, where it feeds the material
  uint32_t lighting_mode = ~0u;
  bool eye_space = false, draws_points = false;
};

} // namespace softgl
