// The snapshots that the next draw may use again, in the arena of the frame being built. The table in
// snapshot/derived_state.cpp says what each is made of.
#pragma once

#include "shaders/common/shaded_vertex.h"
#include "shaders/vertex/vertex_program.h"

namespace softgl {

struct RasterConstants;
struct FragmentProgram;
struct SmoothPrograms;

struct SnapshotCache {
  // Values of the draw call.
  uint32_t present = 0; // its streams
  float color[4] = {};  // its constant color, where it feeds the material
  bool draws_points = false;
  uint32_t least_depth = 0, greatest_depth = 0; // what depths are clamped to
  // What is made of the state and of them, in this order.
  const FragmentProgram* fragment = nullptr; // as the state asks for it
  uint32_t fragment_inputs = 0;              // what vertices must carry for it
  const RasterConstants* raster = nullptr;
  bool eye_space = false;            // lights are in eye space, not in object space
  int8_t material_source[5][2] = {}; // find_material_sources()
  const TransformConstants* transform = nullptr;
  const ClipPlaneConstants* clip_planes = nullptr;
  const CoordinateConstants* coordinates[kMaxTextureUnits] = {};
  ShadedLayout layout;
  const LightingConstants* lighting = nullptr;
  const VertexProgram* vertex = nullptr;
  const FragmentProgram* fragment_of_draw = nullptr; // `fragment`; where it lights fragments, with the lights
  const SmoothPrograms* smooth = nullptr;            // of `fragment_of_draw`, for antialiased primitives
  // Of back-facing polygons, where their stencil test is another one.
  const FragmentProgram* back_fragment = nullptr;
  const SmoothPrograms* back_smooth = nullptr;
};

} // namespace softgl
