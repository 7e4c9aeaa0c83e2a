#include "context/shading.h"

#include <cstdlib>
#include <string_view>

namespace softgl {

bool smooth_is_phong_by_environment() {
  const char* shading = std::getenv("SOFTGL_SHADING");
  return shading && std::string_view(shading) == "phong";
}

} // namespace softgl
