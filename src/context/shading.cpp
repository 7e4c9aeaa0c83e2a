#include "context/shading.h"

#include <cstdlib>
#include <string_view>

namespace softgl {

bool smooth_is_phong_by_environment() {
  const char* shading = std::getenv("SOFTGL_SHADING");
  return shading && std::string_view(shading) == "phong";
}

bool osmesa_quadrilaterals_by_environment() {
  const char* quads = std::getenv("SOFTGL_QUADS");
  return quads && std::string_view(quads) == "osmesa";
}

bool specification_answers_by_environment() {
  const char* answers = std::getenv("SOFTGL_ANSWERS");
  return answers && std::string_view(answers) == "specification";
}

} // namespace softgl
