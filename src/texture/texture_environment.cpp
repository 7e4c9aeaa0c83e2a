#include "texture/texture_environment.h"

namespace softgl {

namespace {

CombineFunction combine_function(GLenum f) {
  switch (f) {
  case GL_REPLACE: return CombineFunction::Replace;
  case GL_ADD: return CombineFunction::Add;
  case GL_ADD_SIGNED: return CombineFunction::AddSigned;
  case GL_INTERPOLATE: return CombineFunction::Interpolate;
  case GL_SUBTRACT: return CombineFunction::Subtract;
  case GL_DOT3_RGB: return CombineFunction::Dot3Rgb;
  case GL_DOT3_RGBA: return CombineFunction::Dot3Rgba;
  default: return CombineFunction::Modulate;
  }
}

int argument_count(CombineFunction f) { return f == CombineFunction::Replace ? 1 : f == CombineFunction::Interpolate ? 3 : 2; }

// OSMesa reads the texel of a unit that is off as 0; GL leaves it undefined.
CombineSource texel_of(int unit, uint32_t sampled) {
  return sampled >> unit & 1 ? CombineSource(int(CombineSource::Texture0) + unit) : CombineSource::Zero;
}

CombineSource combine_source(GLenum source, int unit, uint32_t sampled) {
  switch (source) {
  case GL_TEXTURE: return texel_of(unit, sampled);
  case GL_CONSTANT: return CombineSource::Constant;
  case GL_PRIMARY_COLOR: return CombineSource::Primary;
  case GL_PREVIOUS: return CombineSource::Previous;
  default: return texel_of(int(source - GL_TEXTURE0) & 7, sampled);
  }
}

void set_combine(const TextureUnitState& s, int unit, uint32_t sampled, TextureUnitConstants& t) {
  t.function[0] = combine_function(s.combine_rgb);
  t.function[1] = combine_function(s.combine_alpha);
  for (int i = 0; i < 3; ++i) {
    const GLenum rgb = s.operand_rgb[i], alpha = s.operand_alpha[i];
    t.argument[0][i] = {combine_source(s.source_rgb[i], unit, sampled), rgb == GL_SRC_ALPHA || rgb == GL_ONE_MINUS_SRC_ALPHA,
                        rgb == GL_ONE_MINUS_SRC_COLOR || rgb == GL_ONE_MINUS_SRC_ALPHA};
    t.argument[1][i] = {combine_source(s.source_alpha[i], unit, sampled), 1, alpha == GL_ONE_MINUS_SRC_ALPHA};
  }
  t.combine_scale[0] = s.rgb_scale;
  t.combine_scale[1] = s.alpha_scale;
}

} // namespace

void set_environment(const TextureUnitState& s, int unit, GLenum base, uint32_t sampled, TextureUnitConstants& t) {
  for (int i = 0; i < 4; ++i) t.color[i] = s.env_color[i] > 0 ? (s.env_color[i] < 1 ? s.env_color[i] : 1.0f) : 0.0f;
  if (s.env_mode == GL_COMBINE) return set_combine(s, unit, sampled, t);
  const CombineArgument texel{texel_of(unit, sampled), 0, 0}, texel_alpha{texel.source, 1, 0};
  const CombineArgument previous{CombineSource::Previous, 0, 0}, constant{CombineSource::Constant, 0, 0};
  t.combine_scale[0] = t.combine_scale[1] = 1;
  auto set = [&](int part, CombineFunction f, CombineArgument a, CombineArgument b = {}, CombineArgument c = {}) {
    t.function[part] = f;
    t.argument[part][0] = a, t.argument[part][1] = b, t.argument[part][2] = c;
  };
  // A component that the base format lacks passes through.
  const bool rgb = base != GL_ALPHA, alpha = base != GL_RGB && base != GL_LUMINANCE;
  set(0, CombineFunction::Replace, previous);
  set(1, CombineFunction::Replace, previous);
  switch (s.env_mode) {
  case GL_REPLACE:
    if (rgb) set(0, CombineFunction::Replace, texel);
    if (alpha) set(1, CombineFunction::Replace, texel);
    break;
  case GL_DECAL: // undefined but for RGB and RGBA
    if (base == GL_RGB) set(0, CombineFunction::Replace, texel);
    if (base == GL_RGBA) set(0, CombineFunction::Interpolate, texel, previous, texel_alpha);
    break;
  case GL_BLEND:
    if (rgb) set(0, CombineFunction::Interpolate, constant, previous, texel);
    if (base == GL_INTENSITY) set(1, CombineFunction::Interpolate, constant, previous, texel);
    else if (alpha) set(1, CombineFunction::Modulate, texel, previous);
    break;
  case GL_ADD:
    if (rgb) set(0, CombineFunction::Add, texel, previous);
    if (base == GL_INTENSITY) set(1, CombineFunction::Add, texel, previous);
    else if (alpha) set(1, CombineFunction::Modulate, texel, previous);
    break;
  default: // GL_MODULATE
    if (rgb) set(0, CombineFunction::Modulate, texel, previous);
    // A missing alpha is sampled as one, and x * 1 = x: the fast kernel serves RGB and luminance too.
    set(1, CombineFunction::Modulate, texel, previous);
  }
}

bool reads_source(const TextureUnitConstants& t, CombineSource source) {
  for (int part = 0; part < 2; ++part) {
    if (part == 1 && t.function[0] == CombineFunction::Dot3Rgba) break;
    for (int i = 0; i < argument_count(t.function[part]); ++i)
      if (t.argument[part][i].source == source) return true;
  }
  return false;
}

namespace {
bool plain(const CombineArgument& a, int part, CombineSource source) { return a.source == source && !a.complement && (part == 1 || !a.alpha); }
} // namespace

bool is_modulate(const TextureUnitConstants& t, int unit) {
  const CombineSource texel = CombineSource(int(CombineSource::Texture0) + unit);
  if (t.function[0] != CombineFunction::Modulate || t.combine_scale[0] != 1 || t.combine_scale[1] != 1) return false;
  if (!plain(t.argument[0][0], 0, texel) || !plain(t.argument[0][1], 0, CombineSource::Previous)) return false;
  return t.function[1] == CombineFunction::Modulate && plain(t.argument[1][0], 1, texel) && plain(t.argument[1][1], 1, CombineSource::Previous);
}

bool is_replace(const TextureUnitConstants& t, int unit) {
  const CombineSource texel = CombineSource(int(CombineSource::Texture0) + unit);
  return t.function[0] == CombineFunction::Replace && t.function[1] == CombineFunction::Replace && t.combine_scale[0] == 1 &&
         t.combine_scale[1] == 1 && plain(t.argument[0][0], 0, texel) && plain(t.argument[1][0], 1, texel);
}

} // namespace softgl
