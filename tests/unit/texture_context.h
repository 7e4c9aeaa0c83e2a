// A context for tests of textures.
#pragma once

#include <catch2/catch.hpp>
#include <vector>

#include "support/gl.h"

namespace softgl::test {

/// A context with a 16x16 RGBA surface.
struct TextureContext {
  const Gl& gl;
  void* context;
  std::vector<unsigned char> buffer = std::vector<unsigned char>(16 * 16 * 4);
  explicit TextureContext(const Gl& library)
      : gl(library), context(library.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, 0, nullptr)) {
    bind();
  }
  ~TextureContext() { gl.OSMesaDestroyContext(context); }
  TextureContext(const TextureContext&) = delete;
  void bind() { REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 16, 16)); }
};

} // namespace softgl::test
