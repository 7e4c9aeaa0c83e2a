// Assertions, in builds with SOFTGL_CHECKS (the CMake option of that name) alone.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace softgl {

[[noreturn]] inline void assertion_failed(const char* file, int line, const char* condition) {
  std::fprintf(stderr, "softgl: %s:%d: assertion failed: %s\n", file, line, condition);
  std::abort();
}

} // namespace softgl

#if SOFTGL_CHECKS
#define SOFTGL_ASSERT(condition) \
  ((condition) ? void(0) : ::softgl::assertion_failed(__FILE__, __LINE__, #condition))
#else
#define SOFTGL_ASSERT(condition) void(true || (condition)) // compiled, not evaluated
#endif
