#include "pixels/chapter.h"

namespace softgl::suite {

std::vector<Test> pixels_tests() {
  return joined({pixel_format_tests, pixel_store_tests, pixel_draw_tests, pixel_read_tests,
                 pixel_stencil_tests, pixel_error_tests});
}

} // namespace softgl::suite
