// What a base internal format keeps of a color, and where it is in a texel (GL 1.5, tables 3.15 and 6.1).
#pragma once

#include <type_traits>

#include "base/gl_types.h"

namespace softgl {

/// Red, green, blue, alpha of a group of pixels to what the base format keeps, spread over the texel (table
/// 3.15).
template <class T> void spread(GLenum base, T* v, T absent_one) {
  switch (base) {
  case GL_ALPHA: v[0] = v[1] = v[2] = 0; break;
  case GL_LUMINANCE:
    v[1] = v[2] = v[0];
    v[3] = absent_one;
    break;
  case GL_LUMINANCE_ALPHA: v[1] = v[2] = v[0]; break;
  case GL_INTENSITY: v[1] = v[2] = v[3] = v[0]; break;
  case GL_RGB: v[3] = absent_one; break;
  case GL_RED:
    v[1] = v[2] = 0;
    v[3] = absent_one;
    break;
  case GL_RG:
    v[2] = 0;
    v[3] = absent_one;
    break;
  default: break;
  }
}
/// And back: luminance and intensity are returned as red (table 6.1).
template <class T> void gather(GLenum base, T* v, T absent_one) {
  switch (base) {
  case GL_LUMINANCE:
  case GL_INTENSITY:
    v[1] = v[2] = 0;
    v[3] = absent_one;
    break;
  case GL_LUMINANCE_ALPHA: v[1] = v[2] = 0; break;
  case GL_RGB:
  case GL_RED:
  case GL_RG: v[3] = absent_one; break;
  default: break;
  }
}

/// Calls f(the base format, known to the compiler) unless the format keeps whole colors.
template <class F> void for_base(GLenum base, F&& f) {
  switch (base) {
  case GL_ALPHA: return f(std::integral_constant<GLenum, GL_ALPHA>());
  case GL_LUMINANCE: return f(std::integral_constant<GLenum, GL_LUMINANCE>());
  case GL_LUMINANCE_ALPHA: return f(std::integral_constant<GLenum, GL_LUMINANCE_ALPHA>());
  case GL_INTENSITY: return f(std::integral_constant<GLenum, GL_INTENSITY>());
  case GL_RGB: return f(std::integral_constant<GLenum, GL_RGB>());
  case GL_RED: return f(std::integral_constant<GLenum, GL_RED>());
  case GL_RG: return f(std::integral_constant<GLenum, GL_RG>());
  default: return;
  }
}
/// spread() and gather() of a row.
template <class T> void spread_row(GLenum base, T (*v)[4], int count, T absent_one) {
  const auto each = [&](auto constant) {
    for (int i = 0; i < count; ++i) spread<T>(constant, v[i], absent_one);
  };
  for_base(base, each);
}
template <class T> void gather_row(GLenum base, T (*v)[4], int count, T absent_one) {
  const auto each = [&](auto constant) {
    for (int i = 0; i < count; ++i) gather<T>(constant, v[i], absent_one);
  };
  for_base(base, each);
}

} // namespace softgl
