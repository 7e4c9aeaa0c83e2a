// A GL context that draws to memory of the program.
#pragma once

#include <cstdint>
#include <memory>

#include "scene/gl_functions.h"

namespace softgl::cli {

// Drawing that finish() has not completed is lost with the context.
class GlContext {
public:
  // Makes a context current that draws to `pixels`: RGBA rows from the top, which outlive it. Throws
  // ProgramError if GL draws no picture of that size, std::bad_alloc if memory ends.
  GlContext(uint8_t* pixels, int width, int height, int depth_bits, int stencil_bits = 0);

  // Makes the context current again and lets it draw to other memory, as the constructor does.
  void attach(uint8_t* pixels, int width, int height) const;

  // Completes all drawing. Throws std::bad_alloc if GL ran out of memory since the context was made,
  // ProgramError for any other error.
  static void finish();

private:
  struct Destroy {
    void operator()(osmesa_context* context) const;
  };
  std::unique_ptr<osmesa_context, Destroy> context_;
};

} // namespace softgl::cli
