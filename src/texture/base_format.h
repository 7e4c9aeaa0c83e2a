// What a base internal format keeps of a color, and where it is in a texel (GL 1.5, tables 3.15 and 6.1).
#pragma once

#include <cstdint>
#include <cstring>
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
/// The same of four bytes in a word, for which the compiler has vectors.
inline uint32_t spread_bytes(GLenum base, uint32_t v) {
  constexpr uint32_t kAlpha = 0xff000000;
  const uint32_t first = v & 255, gray = first | first << 8 | first << 16;
  switch (base) {
  case GL_ALPHA: return v & kAlpha;
  case GL_LUMINANCE: return gray | kAlpha;
  case GL_LUMINANCE_ALPHA: return gray | (v & kAlpha);
  case GL_INTENSITY: return gray | first << 24;
  case GL_RGB: return v | kAlpha;
  case GL_RED: return first | kAlpha;
  case GL_RG: return (v & 0xffff) | kAlpha;
  default: return v;
  }
}
inline uint32_t gather_bytes(GLenum base, uint32_t v) {
  constexpr uint32_t kAlpha = 0xff000000;
  switch (base) {
  case GL_LUMINANCE:
  case GL_INTENSITY: return (v & 255) | kAlpha;
  case GL_LUMINANCE_ALPHA: return v & (kAlpha | 255);
  case GL_RGB:
  case GL_RED:
  case GL_RG: return v | kAlpha;
  default: return v;
  }
}

/// word[i] = f(word[i]) of colors of four bytes.
template <class F> void change_words(uint8_t (*v)[4], int count, F f) {
  for (int i = 0; i < count; ++i) {
    uint32_t word;
    std::memcpy(&word, v[i], 4);
    word = f(word);
    std::memcpy(v[i], &word, 4);
  }
}

/// spread() and gather() of a row.
template <class T> void spread_row(GLenum base, T (*v)[4], int count, T absent_one) {
  for_base(base, [&](auto constant) {
    if constexpr (std::is_same_v<T, uint8_t>)
      change_words(v, count, [](uint32_t word) { return spread_bytes(decltype(constant)::value, word); });
    else
      for (int i = 0; i < count; ++i) spread<T>(constant, v[i], absent_one);
  });
}
template <class T> void gather_row(GLenum base, T (*v)[4], int count, T absent_one) {
  for_base(base, [&](auto constant) {
    if constexpr (std::is_same_v<T, uint8_t>)
      change_words(v, count, [](uint32_t word) { return gather_bytes(decltype(constant)::value, word); });
    else
      for (int i = 0; i < count; ++i) gather<T>(constant, v[i], absent_one);
  });
}

} // namespace softgl
