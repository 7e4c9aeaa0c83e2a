// What a base internal format keeps of a color, and where it is in a texel (GL 1.5, tables 3.15 and 6.1).
#pragma once

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

} // namespace softgl
