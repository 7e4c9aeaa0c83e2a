// Comparison of snapshots member by member, for the check that one may be used again.
#pragma once

#include <string>

#include "shaders/fragment/fragment_program.h"
#include "shaders/raster/raster_constants.h"
#include "shaders/vertex/vertex_program.h"

namespace softgl {

/// The name of the first member that differs, such as "constants.texture[0].wrap[1]"; empty if there is none.
/// Pointers are compared by what they point to; those to texels by themselves, since images do not change
/// while a frame keeps them.
std::string snapshot_difference(const FragmentProgram* a, const FragmentProgram* b);
std::string snapshot_difference(const SmoothPrograms* a, const SmoothPrograms* b);
std::string snapshot_difference(const RasterConstants* a, const RasterConstants* b);
std::string snapshot_difference(const TransformConstants* a, const TransformConstants* b);
std::string snapshot_difference(const ClipPlaneConstants* a, const ClipPlaneConstants* b);
std::string snapshot_difference(const CoordinateConstants* const (&a)[kMaxTextureUnits],
                                const CoordinateConstants* const (&b)[kMaxTextureUnits]);
std::string snapshot_difference(const LightingConstants* a, const LightingConstants* b);
std::string snapshot_difference(const VertexProgram* a, const VertexProgram* b);
std::string snapshot_difference(const ShadedLayout& a, const ShadedLayout& b);
std::string snapshot_difference(const int8_t (&a)[5][2], const int8_t (&b)[5][2]);
std::string snapshot_difference(uint32_t a, uint32_t b);
std::string snapshot_difference(bool a, bool b);

} // namespace softgl
