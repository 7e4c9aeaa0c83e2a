// The table of the raster and fragment kernels of one instruction set.
#include "shaders/common/isa.h"
#include "shaders/fragment/fragment_coverage.inl"
#include "shaders/fragment/fragment_image.inl"
#include "shaders/fragment/fragment_light.inl"
#include "shaders/kernels.h"
#include "shaders/raster/raster_lines.inl"
#include "shaders/raster/raster_points.inl"
#include "shaders/raster/raster_tile.inl"
#include "shaders/raster/raster_tiny.inl"

namespace softgl {
namespace SOFTGL_ISA {

extern const RasterKernels raster_kernels;
const RasterKernels raster_kernels = {
    .isa = SOFTGL_STRING(SOFTGL_ISA),
    .prepare_triangles = prepare_triangles,
    .setup_triangles = setup_triangles,
    .shade_points = shade_points,
    .shade_lines = shade_lines,
    .tile_primitives = tile_primitives,
    .tile_triangles = tile_triangles,
    .tile_fragments = tile_fragments,
    .light = stage_light,
    .color_sum = stage_color_sum,
    .color_sum_clamped = stage_color_sum_clamped,
    .fog_linear = stage_fog_linear,
    .fog_exp = stage_fog_exp,
    .fog_exp2 = stage_fog_exp2,
    .clamp_color = stage_clamp_color,
    .clamp_depth = stage_clamp_depth,
    .alpha_test_8 = stage_alpha_test_8,
    .alpha_test_float = stage_alpha_test_float,
    .image = {stage_image_floats, stage_image_bytes, stage_image_depth, stage_image_bit, stage_image_stencil},
    .point_coverage = stage_point_coverage,
    .line_coverage = stage_line_coverage,
    .polygon_coverage = stage_polygon_coverage,
};

} // namespace SOFTGL_ISA
} // namespace softgl
