#include "raster/chapter.h"

namespace softgl::suite {

std::vector<Test> raster_tests() {
  return joined({raster_point_tests, raster_line_tests, raster_polygon_tests, raster_offset_tests,
                 raster_antialiasing_tests, raster_fog_tests, raster_scissor_and_alpha_tests,
                 raster_stencil_tests, raster_depth_tests, raster_query_tests, raster_blend_tests,
                 raster_mask_tests, raster_accumulation_tests, raster_error_tests});
}

} // namespace softgl::suite
