// Colors as floats: a framebuffer object in the current context.
#pragma once

#include "common/growing_array.h"
#include "scene/gl_functions.h"

namespace softgl::cli {

// While it exists, GL draws to it instead of the context's own picture.
class FloatTarget {
public:
  // With `clamp` colors stay in [0, 1] as in a picture of bytes. Throws ProgramError if the GL library has no
  // such buffers or none of that size.
  FloatTarget(int width, int height, bool clamp);
  ~FloatTarget();
  FloatTarget(const FloatTarget&) = delete;
  FloatTarget& operator=(const FloatTarget&) = delete;

  // RGBA rows from the top.
  GrowingArray<float> colors() const;
  // Window depths from 0 to 1, rows from the top.
  GrowingArray<float> depths() const;

private:
  struct Functions;
  static const Functions& functions();
  GrowingArray<float> read(GLenum format, size_t channels) const;

  const Functions& gl_;
  int width_, height_;
  GLuint framebuffer_ = 0, buffers_[2] = {0, 0};
};

} // namespace softgl::cli
