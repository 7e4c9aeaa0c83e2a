#include "texture/chapter.h"

namespace softgl::suite {

std::vector<Test> texture_tests() {
  return joined({texture_image_tests, texture_compressed_tests, texture_part_tests, texture_query_tests,
                 texture_filter_tests, texture_environment_tests, texture_coordinate_tests,
                 texture_object_tests, texture_error_tests});
}

} // namespace softgl::suite
