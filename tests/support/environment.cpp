#include "support/environment.h"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>

namespace softgl::test {

void fix_environment() {
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 1);
  setenv("LP_NUM_THREADS", "0", 1);
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  // Its state; llvmpipe does not test.
  setenv("MESA_EXTENSION_OVERRIDE", "+GL_EXT_depth_bounds_test", 1);
  for (const char* name : {"MESA_GL_VERSION_OVERRIDE", "LP_NATIVE_VECTOR_WIDTH", "GALLIUM_NOSSE", "LP_DEBUG",
                           "LP_PERF", "MESA_DEBUG", "mesa_glthread"})
    unsetenv(name);
}

int seed_count(int usual) {
  const char* most = std::getenv("SOFTGL_TEST_SEEDS");
  return most ? std::clamp(std::atoi(most), 1, usual) : usual;
}

} // namespace softgl::test
