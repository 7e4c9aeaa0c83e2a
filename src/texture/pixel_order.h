// The orders of a pixel's components in client memory, as types: loops over pixels know theirs.
#pragma once

#include <type_traits>

#include "texture/pixel_formats.h"

namespace softgl {

/// Where the four components of a color are in a pixel of client memory: 0 to 3, or kZeroComponent or
/// kOneComponent.
inline constexpr int kZeroComponent = 4, kOneComponent = 5;
template <int components_, int r, int g, int b, int a> struct PixelOrder {
  static constexpr int components = components_, from[4] = {r, g, b, a};
  /// And back: of which of the four component k of a pixel is made.
  static constexpr int source(int k) {
    for (int i = 0; i < 4; ++i)
      if (from[i] == k) return i;
    return 0;
  }
};

/// Calls f(a PixelOrder) for the order of a format's components.
template <class F> void with_order(const PixelFormat& f, F&& call) {
  switch (f.format) {
  case GL_RED: return call(PixelOrder<1, 0, kZeroComponent, kZeroComponent, kOneComponent>());
  case GL_GREEN: return call(PixelOrder<1, kZeroComponent, 0, kZeroComponent, kOneComponent>());
  case GL_BLUE: return call(PixelOrder<1, kZeroComponent, kZeroComponent, 0, kOneComponent>());
  case GL_ALPHA: return call(PixelOrder<1, kZeroComponent, kZeroComponent, kZeroComponent, 0>());
  case GL_LUMINANCE: return call(PixelOrder<1, 0, 0, 0, kOneComponent>());
  case GL_LUMINANCE_ALPHA: return call(PixelOrder<2, 0, 0, 0, 1>());
  case GL_RG: return call(PixelOrder<2, 0, 1, kZeroComponent, kOneComponent>());
  case GL_RGB: return call(PixelOrder<3, 0, 1, 2, kOneComponent>());
  case GL_BGR: return call(PixelOrder<3, 2, 1, 0, kOneComponent>());
  case GL_BGRA: return call(PixelOrder<4, 2, 1, 0, 3>());
  case GL_ABGR_EXT: return call(PixelOrder<4, 3, 2, 1, 0>());
  default: return call(PixelOrder<4, 0, 1, 2, 3>());
  }
}

/// Whether pixels have all four components in the order of colors.
inline bool has_order_of_colors(const PixelFormat& f) {
  bool result = false;
  with_order(f, [&](auto order) { result = std::is_same_v<decltype(order), PixelOrder<4, 0, 1, 2, 3>>; });
  return result;
}

/// Calls f(a PixelOrder) where the components of a packed type are whole bytes.
template <class F> void with_order_of_bytes(const PixelFormat& f, F&& call) {
  const bool reversed = f.shift[0] == 0; // the first component comes first in memory
  switch (f.format) {
  case GL_BGRA: return reversed ? call(PixelOrder<4, 2, 1, 0, 3>()) : call(PixelOrder<4, 1, 2, 3, 0>());
  case GL_ABGR_EXT: return reversed ? call(PixelOrder<4, 3, 2, 1, 0>()) : call(PixelOrder<4, 0, 1, 2, 3>());
  default: return reversed ? call(PixelOrder<4, 0, 1, 2, 3>()) : call(PixelOrder<4, 3, 2, 1, 0>());
  }
}

} // namespace softgl
