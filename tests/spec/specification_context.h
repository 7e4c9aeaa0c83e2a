// A context that answers as the specification says, or as OSMesa does (SOFTGL_SPECIFICATION_ANSWERS).
#pragma once

#include <catch2/catch.hpp>

#include <vector>

#include "support/gl.h"

namespace softgl::test {

/// Is current, with a window of kSize x kSize, as long as it lives. At its end there may be no error.
class SpecificationContext {
public:
  static constexpr int kSize = 64;
  const Gl& gl = softgl_library();

  explicit SpecificationContext(bool specification = true) {
    const int attributes[] = {0x30 /* OSMESA_DEPTH_BITS */, 24, SOFTGL_SPECIFICATION_ANSWERS, specification,
                              0};
    context_ = gl.OSMesaCreateContextAttribs(attributes, nullptr);
    REQUIRE(context_);
    REQUIRE(gl.OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSize, kSize));
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  }
  ~SpecificationContext() {
    CHECK(gl.GetError() == GL_NO_ERROR);
    gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    gl.OSMesaDestroyContext(context_);
  }
  SpecificationContext(const SpecificationContext&) = delete;

  /// Red of all pixels, bottom row first.
  std::vector<GLubyte> red() const {
    std::vector<GLubyte> pixels(kSize * kSize);
    gl.ReadPixels(0, 0, kSize, kSize, GL_RED, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  }
  int red_in_the_middle() const { return red()[kSize / 2 * kSize + kSize / 2]; }

private:
  void* context_;
  std::vector<GLubyte> buffer_ = std::vector<GLubyte>(kSize * kSize * 4);
};

} // namespace softgl::test
