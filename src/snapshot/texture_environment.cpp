#include "snapshot/texture_environment.h"
#include "shaders/common/seeded_faults.h"

#include <utility>

namespace softgl {

namespace {

/// `products`: GL_COMBINE4_NV, whose sums are of two products.
CombineFunction combine_function(GLenum f, bool products) {
  switch (f) {
  case GL_REPLACE: return CombineFunction::Replace;
  case GL_ADD: return products ? CombineFunction::AddProducts : CombineFunction::Add;
  case GL_ADD_SIGNED: return products ? CombineFunction::AddProductsSigned : CombineFunction::AddSigned;
  case GL_INTERPOLATE: return CombineFunction::Interpolate;
  case GL_SUBTRACT: return SOFTGL_FAULT(subtract_is_add) ? CombineFunction::Add : CombineFunction::Subtract;
  case GL_MODULATE_ADD_ATI: return CombineFunction::ModulateAdd;
  case GL_MODULATE_SIGNED_ADD_ATI: return CombineFunction::ModulateSignedAdd;
  case GL_MODULATE_SUBTRACT_ATI: return CombineFunction::ModulateSubtract;
  case GL_DOT3_RGB:
  case GL_DOT3_RGB_EXT: return CombineFunction::Dot3Rgb;
  case GL_DOT3_RGBA:
  case GL_DOT3_RGBA_EXT:
    return SOFTGL_FAULT(dot3_alpha_forgotten) ? CombineFunction::Dot3Rgb : CombineFunction::Dot3Rgba;
  default: return CombineFunction::Modulate;
  }
}

int argument_count(CombineFunction f) {
  switch (f) {
  case CombineFunction::Replace: return 1;
  case CombineFunction::Interpolate:
  case CombineFunction::ModulateAdd:
  case CombineFunction::ModulateSignedAdd:
  case CombineFunction::ModulateSubtract: return 3;
  case CombineFunction::AddProducts:
  case CombineFunction::AddProductsSigned: return 4;
  default: return 2;
  }
}

// OSMesa reads the texel of a unit that is off as 0; GL leaves it undefined.
CombineSource texel_of(int unit, uint32_t sampled) {
  return sampled >> unit & 1 ? CombineSource(int(CombineSource::Texture0) + unit) : CombineSource::Zero;
}

CombineSource combine_source(GLenum source, int unit, uint32_t sampled) {
  switch (source) {
  case GL_TEXTURE: return texel_of(unit, sampled);
  case GL_CONSTANT: return CombineSource::Constant;
  case GL_PRIMARY_COLOR:
    return SOFTGL_FAULT(primary_is_previous) ? CombineSource::Previous : CombineSource::Primary;
  case GL_ZERO: return CombineSource::Zero;
  case GL_ONE: return CombineSource::One;
  case GL_PREVIOUS: return CombineSource::Previous;
  default: return texel_of(SOFTGL_FAULT(crossbar_ignored) ? unit : int(source - GL_TEXTURE0) & 7, sampled);
  }
}

CombinerChain::Unit make_combine(const TextureUnitState& s, int unit, uint32_t sampled) {
  const bool products = s.env_mode == GL_COMBINE4_NV;
  CombinerChain::Unit t{
      {combine_function(s.combine_rgb, products), combine_function(s.combine_alpha, products)},
      {},
      {uint8_t(SOFTGL_FAULT(scale_ignored) ? 1 : s.rgb_scale),
       uint8_t(SOFTGL_FAULT(scale_ignored) ? 1 : s.alpha_scale)}};
  // Those of GL_EXT_texture_env_dot3 are not scaled.
  if (s.combine_rgb == GL_DOT3_RGB_EXT || s.combine_rgb == GL_DOT3_RGBA_EXT) t.scale[0] = 1;
  if (s.combine_rgb == GL_DOT3_RGBA_EXT) t.scale[1] = 1;
  for (int i = 0; i < argument_count(t.function[0]); ++i) {
    const GLenum operand = s.operand_rgb[i];
    t.argument[0][i] = {combine_source(s.source_rgb[i], unit, sampled),
                        operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA,
                        (operand == GL_ONE_MINUS_SRC_COLOR || operand == GL_ONE_MINUS_SRC_ALPHA) &&
                            !SOFTGL_FAULT(operand_not_inverted)};
  }
  if (SOFTGL_FAULT(interpolate_turned) && t.function[0] == CombineFunction::Interpolate)
    std::swap(t.argument[0][0], t.argument[0][1]);
  for (int i = 0; i < argument_count(t.function[1]); ++i)
    t.argument[1][i] = {combine_source(s.source_alpha[i], unit, sampled), 1,
                        s.operand_alpha[i] == GL_ONE_MINUS_SRC_ALPHA};
  return t;
}

} // namespace

CombinerChain::Unit make_environment(const TextureUnitState& s, int unit, GLenum base, uint32_t sampled) {
  if (s.env_mode == GL_COMBINE || s.env_mode == GL_COMBINE4_NV) return make_combine(s, unit, sampled);
  const CombineArgument texel{texel_of(unit, sampled), 0, 0}, texel_alpha{texel.source, 1, 0};
  const CombineArgument previous{CombineSource::Previous, 0, 0}, constant{CombineSource::Constant, 0, 0};
  CombinerChain::Unit t{{}, {}, {1, 1}};
  auto set = [&](int part, CombineFunction f, CombineArgument a, CombineArgument b = {},
                 CombineArgument c = {}) {
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
    if (base == GL_RGBA && SOFTGL_FAULT(decal_opaque)) set(0, CombineFunction::Replace, texel);
    if (base == GL_RGBA && !SOFTGL_FAULT(decal_opaque))
      set(0, CombineFunction::Interpolate, texel, previous, texel_alpha);
    break;
  case GL_BLEND:
    if (rgb && SOFTGL_FAULT(blend_is_modulate)) set(0, CombineFunction::Modulate, texel, previous);
    if (rgb && !SOFTGL_FAULT(blend_is_modulate))
      set(0, CombineFunction::Interpolate, constant, previous, texel);
    if (base == GL_INTENSITY)
      set(1, CombineFunction::Interpolate, constant, previous, texel);
    else if (alpha && !SOFTGL_FAULT(alpha_of_blend_forgotten))
      set(1, CombineFunction::Modulate, texel, previous);
    break;
  case GL_ADD:
    if (rgb) set(0, CombineFunction::Add, texel, previous);
    if (base == GL_INTENSITY)
      set(1, CombineFunction::Add, texel, previous);
    else if (alpha)
      set(1, CombineFunction::Modulate, texel, previous);
    break;
  default: // GL_MODULATE
    if (rgb) set(0, CombineFunction::Modulate, texel, previous);
    if (alpha) set(1, CombineFunction::Modulate, texel, previous);
  }
  return t;
}

namespace {
bool plain(const CombineArgument& a, int part, CombineSource source) {
  return a.source == source && !a.complement && (part == 1 || !a.alpha);
}
bool scaled(const CombinerChain::Unit& t) { return t.scale[0] != 1 || t.scale[1] != 1; }
bool modulates(const CombinerChain::Unit& t, int part, CombineSource texel) {
  return t.function[part] == CombineFunction::Modulate && plain(t.argument[part][0], part, texel) &&
         plain(t.argument[part][1], part, CombineSource::Previous);
}
} // namespace

bool is_modulate(const CombinerChain::Unit& t, int unit, GLenum base) {
  const CombineSource texel = CombineSource(int(CombineSource::Texture0) + unit);
  // A missing alpha is sampled as one, and x * 1 = x: the fast kernel serves RGB and luminance too.
  const bool passes =
      t.function[1] == CombineFunction::Replace && plain(t.argument[1][0], 1, CombineSource::Previous);
  return !scaled(t) && modulates(t, 0, texel) &&
         (modulates(t, 1, texel) || ((base == GL_RGB || base == GL_LUMINANCE) && passes));
}

bool is_replace(const CombinerChain::Unit& t, int unit) {
  const CombineSource texel = CombineSource(int(CombineSource::Texture0) + unit);
  return !scaled(t) && t.function[0] == CombineFunction::Replace &&
         t.function[1] == CombineFunction::Replace && plain(t.argument[0][0], 0, texel) &&
         plain(t.argument[1][0], 1, texel);
}

} // namespace softgl
