// The floating-point environment in which everything that reaches a pixel is computed.
#pragma once

#include <xmmintrin.h>

namespace softgl {

/// Round to nearest, no traps, denormals flushed to zero (inputs too), as OSMesa's rasterizer threads have
/// it.
constexpr unsigned kPixelFloatEnvironment = 0x9fc0;

/// Sets that environment for a scope and gives the application its own back.
class FloatEnvironment {
public:
  FloatEnvironment() : saved_(_mm_getcsr()) { _mm_setcsr(kPixelFloatEnvironment); }
  ~FloatEnvironment() { _mm_setcsr(saved_); }
  FloatEnvironment(const FloatEnvironment&) = delete;
  FloatEnvironment& operator=(const FloatEnvironment&) = delete;

private:
  unsigned saved_;
};

} // namespace softgl
