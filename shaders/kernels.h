// The one entry of this folder: per family of kernels a struct of function pointers, filled once per
// instruction set.
#pragma once

#include <stdint.h>

#include "shaders/common/shaded_vertex.h"
#include "shaders/common/surface.h"
#include "shaders/fragment/fragment_block.h"
#include "shaders/vertex/vertex_program.h"

namespace softgl {

struct LineSpan;   // raster_lines.h
struct RasterDraw; // raster_draw.h
struct RasterPrimitive;
struct SmallFragments;
struct SmallTriangle;
struct TileTarget;
struct TriangleInput; // raster_triangles.h
struct TriangleOutput;

/// Eye space to shaded vertices (vertex_kernels.cpp).
struct VertexKernels {
  const char* isa;
  /// Vertices [first, first + count) to `out` (layout.slots each) and `mask`. With `leave_clipped`, where all
  /// of them lie outside of one clipping plane, only `mask` is set. Gives the bits of such planes, or else 0.
  uint16_t (*shade)(const VertexJob& job, uint32_t first, uint32_t count, ShadedVertices::Slot* out,
                    uint16_t* mask, bool leave_clipped);
};

/// Window space to pixels (raster_kernels.cpp).
struct RasterKernels {
  const char* isa;
  /// Culls and classifies a batch and shades its fragments if it is tiny.
  void (*prepare_triangles)(const RasterDraw& draw, const TriangleInput& in, TriangleOutput& out,
                            FragmentBlock& scratch);
  /// Sets up the large triangles of a prepared batch into *record[i].
  void (*setup_triangles)(const RasterDraw& draw, const TriangleInput& in, const TriangleOutput& batch,
                          RasterPrimitive* const* record);
  /// Depths and colors of the fragments of points, in the words of finished fragments. Of a draw without
  /// stages.
  void (*shade_points)(const RasterDraw& draw, const ShadedVertices::Slot* const* corner, int32_t count,
                       uint32_t* depth, uint32_t* color);
  /// The same of lines: line after line, along each of them.
  void (*shade_lines)(const RasterDraw& draw, const LineSpan* line, int32_t count, uint32_t* depth,
                      uint32_t* color);
  /// Draws primitives or small triangles, or merges finished fragments, into one tile in order.
  void (*tile_primitives)(const TileTarget& tile, const RasterDraw& draw,
                          const RasterPrimitive* const* primitive, int32_t count, FragmentBlock& scratch);
  void (*tile_triangles)(const TileTarget& tile, const RasterDraw& draw, const SmallTriangle* triangle,
                         int32_t count, FragmentBlock& scratch);
  void (*tile_fragments)(const TileTarget& tile, const RasterDraw& draw, const SmallFragments& fragments,
                         int32_t count);
  // Stages of fragment programs.
  FragmentStage light; // colors from normals, eye positions and materials
  FragmentStage color_sum, color_sum_clamped, fog_linear, fog_exp, fog_exp2;
  FragmentStage clamp_color, clamp_depth;
  FragmentStage alpha_test_8, alpha_test_float; // `unit` is the comparison
  FragmentStage image[5];                       // by PixelElement; in front of all others
  FragmentStage point_coverage, line_coverage, polygon_coverage;
};

/// Texture sampling and environment (texture_kernels.cpp).
struct TextureKernels {
  const char* isa;
  // Sampling leaves the texel in the unit's coordinates (s, t, r, ds_dx = r, g, b, a); the environments read
  // it there.
  FragmentStage choose_face;    // of cube maps, before sampling
  FragmentStage sample_fixed;   // 8 bits per component, REPEAT or CLAMP_TO_EDGE
  FragmentStage modulate_fixed; // the same and GL_MODULATE; leaves no texel
  FragmentStage sample_float;   // everything else
  FragmentStage sample_anisotropic;
  FragmentStage drop_shadowed; // behind sampling: fragments that the alpha test drops for this unit's texel
  FragmentStage replace, modulate;
  FragmentStage combine; // all units' environments in one, and the color sum
};

} // namespace softgl
