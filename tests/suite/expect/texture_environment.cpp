// Texture environments (3.8.13, tables 3.22 to 3.25).
#include <stdexcept>

#include "expect/texture_state.h"

namespace softgl::suite {
namespace {

Interval one_minus(Interval a) { return {1 - a.high, 1 - a.low}; }

// What the environments other than GL_COMBINE give to one component; 3 is alpha. `texel` is as table 3.20 has
// it.
Interval simple(const TextureEnvironment& e, GLenum base, int i, const Pixel& t, const Interval color[4]) {
  const bool alpha = i == 3;
  const Interval &f = color[i], &texel = t.c[i];
  const bool has_color = base != GL_ALPHA, has_alpha = base != GL_LUMINANCE && base != GL_RGB;
  if (alpha ? !has_alpha : !has_color) return f;
  switch (e.mode) {
  case GL_REPLACE: return texel;
  case GL_MODULATE: return f * texel;
  case GL_DECAL:
    if (base == GL_RGB) return texel;
    if (base != GL_RGBA) throw std::logic_error("GL_DECAL of what it is not defined for");
    return alpha ? f : f * one_minus(t.c[3]) + texel * t.c[3];
  case GL_BLEND:
    if (alpha && base != GL_INTENSITY) return f * texel;
    return f * one_minus(texel) + texel * e.color[i];
  case GL_ADD: return alpha && base != GL_INTENSITY ? f * texel : f + texel;
  }
  throw std::logic_error("a texture environment that the machine does not know");
}

Interval argument(const TextureEnvironment& e, bool of_alpha, int n, int i, const Pixel* texels, int unit,
                  const Interval primary[4], const Interval previous[4]) {
  const auto value = [&](int component) -> Interval {
    const GLenum source = e.source[of_alpha][n];
    switch (source) {
    case GL_TEXTURE: return texels[unit].c[component];
    case GL_CONSTANT: return e.color[component];
    case GL_PRIMARY_COLOR: return primary[component];
    case GL_PREVIOUS: return previous[component];
    }
    if (source >= GL_TEXTURE0 && source < GL_TEXTURE0 + kTextureUnits)
      return texels[source - GL_TEXTURE0].c[component];
    throw std::logic_error("a source that the machine does not know");
  };
  switch (e.operand[of_alpha][n]) {
  case GL_SRC_COLOR: return value(i);
  case GL_ONE_MINUS_SRC_COLOR: return one_minus(value(i));
  case GL_SRC_ALPHA: return value(3);
  case GL_ONE_MINUS_SRC_ALPHA: return one_minus(value(3));
  }
  throw std::logic_error("an operand that the machine does not know");
}

bool is_dot(GLenum function) { return function == GL_DOT3_RGB || function == GL_DOT3_RGBA; }

} // namespace

void apply_environment(const TextureEnvironment& e, GLenum base, const Pixel* texels, int unit,
                       const Interval primary[4], Interval color[4], const double step[4]) {
  Interval before[4];
  std::copy(color, color + 4, before);
  const auto rounded = [&](int i, Interval v) { return spec::clamped(spec::widened(v, step[i]), 0, 1); };
  if (e.mode != GL_COMBINE) {
    for (int i = 0; i < 4; i++) color[i] = rounded(i, simple(e, base, i, texels[unit], before));
    return;
  }
  for (int i = 0; i < 4; i++) {
    const bool of_alpha = i == 3 && e.combine[0] != GL_DOT3_RGBA;
    const GLenum function = e.combine[of_alpha];
    const auto a = [&](int n, int component) {
      return argument(e, of_alpha, n, component, texels, unit, primary, before);
    };
    Interval result;
    if (is_dot(function)) {
      for (int k = 0; k < 3; k++) result = result + (a(0, k) - 0.5) * (a(1, k) - 0.5);
      result = result * 4;
    } else {
      switch (function) {
      case GL_REPLACE: result = a(0, i); break;
      case GL_MODULATE: result = a(0, i) * a(1, i); break;
      case GL_ADD: result = a(0, i) + a(1, i); break;
      case GL_ADD_SIGNED: result = a(0, i) + a(1, i) - 0.5; break;
      case GL_SUBTRACT: result = a(0, i) - a(1, i); break;
      case GL_INTERPOLATE: result = a(0, i) * a(2, i) + a(1, i) * one_minus(a(2, i)); break;
      default: throw std::logic_error("a combiner that the machine does not know");
      }
    }
    // What is rounded before the scale is scaled with it.
    const double scale = e.scale[of_alpha];
    color[i] = rounded(i, spec::widened(result, step[i]) * scale);
  }
}

} // namespace softgl::suite
