#include "snapshot/texture_snapshot.h"
#include "context/texture_bindings.h"
#include "snapshot/render_targets.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/assert.h"
#include "base/fast_paths.h"
#include "base/kernel_table.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"
#include "shaders/texture/texture_constants.h"
#include "snapshot/texture_environment.h"
#include "texture/texture_object.h"

namespace softgl {

namespace {

/// The target that a unit samples: the enabled one of the highest order (3.8.15); kTextureTargets if it is
/// off.
TextureTarget enabled_target(const TextureUnitState& unit) {
  if (SOFTGL_FAULT(one_dimension_wins) && unit.enabled[kTexture1D]) return kTexture1D;
  for (TextureTarget t : {kTextureCube, kTexture3D, kTextureRectangle, kTexture2D, kTexture1D})
    if (unit.enabled[t]) return t;
  return kTextureTargets;
}

TextureWrap wrap_mode(GLenum mode, int size) {
  switch (mode) {
  case GL_CLAMP: return TextureWrap::Clamp;
  case GL_CLAMP_TO_EDGE: return TextureWrap::ClampToEdge;
  case GL_CLAMP_TO_BORDER: return TextureWrap::ClampToBorder;
  case GL_MIRRORED_REPEAT: return TextureWrap::MirroredRepeat;
  default: return std::has_single_bit(unsigned(size)) ? TextureWrap::RepeatPowerOfTwo : TextureWrap::Repeat;
  }
}

/// OSMesa keeps the bias in 1/256, of the object and of the unit each.
float quantized_bias(float bias) { return std::round(std::clamp(bias, -16.0f, 16.0f) * 256.0f) / 256.0f; }

/// OSMesa 22.3.6 magnifies up to a level of detail of 0, and clamps each bias alone.
void set_level_of_detail(const SamplingParameters& p, float unit_bias, bool specification_answers,
                         TextureUnitConstants& t) {
  t.min_linear = p.min_filter == GL_LINEAR || p.min_filter == GL_LINEAR_MIPMAP_NEAREST ||
                 p.min_filter == GL_LINEAR_MIPMAP_LINEAR;
  t.mag_linear = SOFTGL_FAULT(mag_filter_is_min) ? t.min_linear : p.mag_filter == GL_LINEAR;
  t.mip = !uses_mipmaps(p.min_filter) ? TextureMip::None
          : p.min_filter == GL_NEAREST_MIPMAP_NEAREST || p.min_filter == GL_LINEAR_MIPMAP_NEAREST
              ? TextureMip::Nearest
              : TextureMip::Linear;
  if (SOFTGL_FAULT(mipmaps_nearest) && t.mip == TextureMip::Linear) t.mip = TextureMip::Nearest;
  t.lod_bias =
      quantized_bias(p.lod_bias) + (SOFTGL_FAULT(lod_bias_ignored) ? 0.0f : quantized_bias(unit_bias));
  if (specification_answers) t.lod_bias = std::clamp(t.lod_bias, -16.0f, 16.0f);
  const bool nearest_mipmaps =
      p.min_filter == GL_NEAREST_MIPMAP_NEAREST || p.min_filter == GL_NEAREST_MIPMAP_LINEAR;
  const bool later = specification_answers && p.mag_filter == GL_LINEAR && nearest_mipmaps;
  t.magnified_lod = later ? 0.5f : 0.0f;
  t.magnified_rho = !later ? 1.0f : t.shape == TextureShape::OneD ? 1.41421356237309504880f : 2.0f;
  t.min_lod = SOFTGL_FAULT(min_lod_ignored) ? 0.0f : std::max(p.min_lod, 0.0f);
  t.max_lod = SOFTGL_FAULT(max_lod_ignored) ? 1000.0f : p.max_lod;
  t.constant_lod = t.min_lod == t.max_lod;
  t.has_min_lod = t.min_lod > 0;
  t.has_max_lod = t.max_lod < float(kMaxTextureLevels);
  t.adjusts_lod = t.lod_bias != 0 || t.has_min_lod || t.has_max_lod;
}

bool has_alpha(GLenum base_format) {
  switch (base_format) {
  case GL_ALPHA:
  case GL_LUMINANCE_ALPHA:
  case GL_INTENSITY:
  case GL_RGBA: return true;
  default: return false;
  }
}

/// The border color as a texel of the format.
void set_border(Vec4 color, const TexelFormat& format, TextureUnitConstants& t) {
  const bool floats = format.layout == TexelLayout::Float;
  const float least = format.layout == TexelLayout::Signed16 ? -1.0f : 0.0f;
  for (int i = 0; i < 4 && !(floats && format.array); ++i) { // no NaN; packed floats have no sign
    color[i] = color[i] > least ? color[i] : least;
    if (!floats) color[i] = std::min(color[i], 1.0f);
  }
  if (SOFTGL_FAULT(border_color_black)) color = Vec4(0.0f);
  const float r = color.x;
  switch (format.base) {
  case GL_RED: t.border[0] = r, t.border[1] = t.border[2] = 0, t.border[3] = 1; break;
  case GL_RG: t.border[0] = r, t.border[1] = color.y, t.border[2] = 0, t.border[3] = 1; break;
  case GL_ALPHA: t.border[0] = t.border[1] = t.border[2] = 0, t.border[3] = color.w; break;
  case GL_LUMINANCE:
  case GL_DEPTH_COMPONENT:
  case GL_DEPTH_STENCIL: t.border[0] = t.border[1] = t.border[2] = r, t.border[3] = 1; break;
  case GL_LUMINANCE_ALPHA: t.border[0] = t.border[1] = t.border[2] = r, t.border[3] = color.w; break;
  case GL_INTENSITY: t.border[0] = t.border[1] = t.border[2] = t.border[3] = r; break;
  case GL_RGB: t.border[0] = r, t.border[1] = color.y, t.border[2] = color.z, t.border[3] = 1; break;
  default:
    for (int i = 0; i < 4; ++i) t.border[i] = color[i];
  }
}

void set_texel(const TexelFormat& f, bool decode, TextureUnitConstants& t) {
  switch (f.layout) {
  case TexelLayout::Rgba8: t.texel = f.srgb && decode ? TextureTexel::Srgb8 : TextureTexel::Rgba8; break;
  case TexelLayout::Rgba16: t.texel = TextureTexel::Rgba16; break;
  case TexelLayout::Depth: t.texel = f.floats ? TextureTexel::DepthFloat : TextureTexel::Depth; break;
  case TexelLayout::Signed16: t.texel = TextureTexel::Signed16; break;
  case TexelLayout::Float: t.texel = TextureTexel::Float; break;
  }
  for (int k = 0; k < 4; ++k) {
    const int bits =
        f.layout == TexelLayout::Signed16 && f.bits[k] ? f.bits[k] - 1 : f.bits[k]; // of the magnitude
    const int whole = f.layout == TexelLayout::Rgba8 ? 8 : 1; // an absent component is stored as 255 or 1
    t.shift[k] = uint8_t(f.layout == TexelLayout::Rgba8 && bits ? 8 - bits
                         : f.layout == TexelLayout::Depth       ? bits
                                                                : 0);
    t.scale[k] = float(1.0 / double((uint64_t(1) << (bits ? bits : whole)) - 1));
  }
}

void set_levels(const TextureObject& object, CompleteLevels levels, TextureUnitConstants& t) {
  const int faces = object.target == kTextureCube ? 6 : 1;
  t.last_level = levels.count - 1;
  for (int i = 0; i < levels.count; ++i) {
    TextureLevel& level = t.level[i];
    for (int face = 0; face < faces; ++face) {
      const TextureImage& image = *object.image[face][levels.first + i];
      const int bytes = image.format->bytes();
      const TexelBox box = image.with_border();
      SOFTGL_ASSERT(image.row_bytes == size_t(box.width + 1) * size_t(bytes));
      SOFTGL_ASSERT(image.texels.size() >= image.slice_bytes * size_t(box.depth) + 8);
      level = {{level.face[0], level.face[1], level.face[2], level.face[3], level.face[4], level.face[5]},
               image.width,
               image.height,
               image.depth,
               int32_t(image.row_bytes / size_t(bytes)),
               int32_t(image.slice_bytes / size_t(bytes))};
      level.face[face] = image.at(0, 0, 0);
    }
  }
}

GLenum sampled_base(const TextureObject& object, const TexelFormat& format) {
  const GLenum base = format.layout == TexelLayout::Depth ? object.parameters.depth_mode : format.base;
  // Red, and red and green, are used as RGB (GL_ARB_texture_rg).
  return base == GL_RED || base == GL_RG ? GLenum(GL_RGB) : base;
}

/// Where OSMesa 22.3.6 looks whether a size is a power of two: level 0, if the base level is one of its
/// levels.
const TextureImage& level_zero(const TextureObject& object, int base_level) {
  const auto &zero = object.image[0][0], &base = object.image[0][base_level];
  auto continues = [&](int large, int small) { return std::max(large >> base_level, 1) == small; };
  const bool fits = zero && continues(zero->width, base->width) && continues(zero->height, base->height) &&
                    continues(zero->depth, base->depth);
  return fits ? *zero : *base;
}

/// Of images with rows of texels without comparison; else the filter stays isotropic, as it may.
void set_anisotropy(const TextureObject& object, float most, int base_level, TextureUnitConstants& t) {
  t.anisotropic =
      most >= 2 && t.shape != TextureShape::OneD && !t.counts_texels && !t.compares && !t.bordered;
  const TextureImage& zero = level_zero(object, base_level);
  t.zero_width = zero.width, t.zero_height = zero.height;
  t.first_level = &zero == object.image[0][0].get() ? base_level : 0;
}

/// OSMesa 22.3.6 filters in fixed point where it can; not blocks of FXT1, nor in the cube maps whose lanes
/// may want different filters.
bool fixed_point(const TextureUnitConstants& t, BlockFormat block) {
  auto fixed = [&](int axis) { return t.wrap[axis] <= TextureWrap::ClampToEdge; };
  if (t.seamless || t.anisotropic || t.bordered || block == BlockFormat::Fxt1Rgb ||
      block == BlockFormat::Fxt1Rgba)
    return false;
  if (t.shape == TextureShape::Cube && t.mip != TextureMip::None && t.min_linear != t.mag_linear)
    return false;
  return t.texel == TextureTexel::Rgba8 && fixed(0) && fixed(1) &&
         (t.shape != TextureShape::ThreeD || fixed(2));
}

TextureUnitConstants* make_constants(Context& c, Arena& arena, int unit, GLenum& base, bool& fixed) {
  const TextureUnitState& state = c.state.texture.unit[unit];
  const TextureTarget target = enabled_target(state);
  if (target == kTextureTargets) return nullptr;
  const auto object = bound_texture(c, unit, target);
  if (object->drawn_to) store_drawn_texels(*object);
  const SamplerObject* sampler = c.samplers[unit].get();
  const SamplingParameters& p = sampler ? sampler->parameters : object->parameters;
  const CompleteLevels levels = complete_levels(*object, p.min_filter);
  if (levels.count == 0) return nullptr; // incomplete: as if texturing were off (3.8.10)
  if (target == kTextureRectangle && (repeats(p.wrap[0]) || repeats(p.wrap[1]) || repeats(p.wrap[2])))
    return nullptr; // so is one that the sampler's wrap modes do not suit (GL_ARB_sampler_objects, 3.9.2)
  auto* t = arena.make<TextureUnitConstants>();
  const TextureImage& image = *object->image[0][levels.first];
  t->shape = target == kTexture1D     ? TextureShape::OneD
             : target == kTexture3D   ? TextureShape::ThreeD
             : target == kTextureCube ? TextureShape::Cube
                                      : TextureShape::TwoD;
  t->counts_texels = target == kTextureRectangle;
  t->bordered = image.border != ImageBorder{};
  set_levels(*object, levels, *t);
  set_texel(*image.format, p.srgb_decode == GL_DECODE_EXT, *t);
  const bool cube = target == kTextureCube;
  // OSMesa 22.3.6 clamps to the edges of a cube map's face, whatever the wrap modes say.
  const bool to_edges = cube && !c.specification_answers;
  const TextureImage& zero = level_zero(*object, levels.first);
  t->wrap[0] = wrap_mode(to_edges ? GLenum(GL_CLAMP_TO_EDGE) : p.wrap[0], zero.width);
  t->wrap[1] = wrap_mode(to_edges || target == kTexture1D ? GLenum(GL_CLAMP_TO_EDGE)
                                                          : p.wrap[SOFTGL_FAULT(wrap_t_is_s) ? 0 : 1],
                         zero.height);
  t->wrap[2] = wrap_mode(p.wrap[2], zero.depth);
  set_level_of_detail(p, state.lod_bias, c.specification_answers, *t);
  t->seamless = cube && c.state.texture.seamless_cube_map && (t->min_linear || t->mag_linear);
  if (levels.first == 0 && levels.count == 1 && p.max_lod > 0) t->mip = TextureMip::None;
  for (int i = 0; i < 4; ++i)
    t->color[i] = state.env_color[i] > 0 && !SOFTGL_FAULT(environment_color_black)
                      ? std::min(state.env_color[i], 1.0f)
                      : 0.0f; // no NaN
  base = sampled_base(*object, *image.format);
  set_border(p.border_color, *image.format, *t);
  t->no_alpha = !has_alpha(image.format->base);
  if (image.format->layout == TexelLayout::Depth) {
    // Cube maps have no coordinate left to compare with.
    t->compares = p.compare_mode == GL_COMPARE_R_TO_TEXTURE && !SOFTGL_FAULT(compare_ignored) &&
                  t->shape != TextureShape::Cube;
    t->compare_function = uint8_t(p.compare_function - GL_NEVER);
    const GLenum mode = object->parameters.depth_mode;
    t->depth_components = mode == GL_INTENSITY || SOFTGL_FAULT(depth_is_intensity) ? 15
                          : mode == GL_ALPHA                                       ? 8
                          : mode == GL_RED                                         ? 1
                                                                                   : 7;
  }
  set_anisotropy(*object, p.max_anisotropy, levels.first, *t);
  fixed = fixed_point(*t, image.format->block);
  for (auto& face : object->image)
    for (int i = 0; i < levels.count; ++i)
      if (auto& kept = face[levels.first + i]) c.frame.retain(kept, kept->texels.size());
  return t;
}

bool reads_r(const TextureUnitConstants& t) {
  return t.shape == TextureShape::ThreeD || t.shape == TextureShape::Cube || t.compares;
}

} // namespace

void append_texture_stages(Context& c, Arena& arena, FragmentProgram& program, FragmentConstants& constants) {
  TextureUnitConstants* units[kMaxTextureUnits] = {};
  GLenum base[kMaxTextureUnits] = {};
  bool fixed[kMaxTextureUnits] = {};
  uint32_t sampled = 0;
  for (int u = 0; u < kMaxTextureUnits; ++u)
    if ((units[u] = make_constants(c, arena, u, base[u], fixed[u]))) sampled |= 1u << u;
  if (sampled == 0) return;
  program.key.texture_units = uint64_t(sampled);
  const TextureKernels& kernels = *softgl::kernels().texture;
  CombinerChain chain;
  chain.units = uint8_t(sampled);
  bool simple = true; // every environment has a stage of its own
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    if (!units[u]) continue;
    chain.unit[u] = make_environment(c.state.texture.unit[u], u, base[u], sampled);
    simple &= is_modulate(chain.unit[u], u, base[u]) || is_replace(chain.unit[u], u);
    constants.texture[u] = units[u];
    if (units[u]->shape == TextureShape::Cube) {
      program.cube_units = uint8_t(program.cube_units | 1u << u);
      program.add(kernels.choose_face, u);
    }
    program.reads_quads |= units[u]->reads_quads();
    if (reads_r(*units[u])) program.r_units = uint8_t(program.r_units | 1u << u);
    if (units[u]->reads_differences()) program.lod_units = uint8_t(program.lod_units | 1u << u);
  }
  auto fused = [&](int u) {
    return simple && fixed[u] && is_modulate(chain.unit[u], u, base[u]) && takes(FastPath::FusedTextures);
  };
  for (int u = 0; u < kMaxTextureUnits; ++u)
    if (units[u] && !fused(u))
      program.add(units[u]->anisotropic ? kernels.sample_anisotropic
                  : fixed[u]            ? kernels.sample_fixed
                                        : kernels.sample_float,
                  u);
  if (!simple) {
    // The color sum has a part in the order of additions. That of lit fragments is clamped and comes later.
    chain.color_sum = program.key.color_sum && !program.key.lit;
    if (chain.color_sum) program.key.color_sum = 0;
    auto combiner = c.combiners.program(chain);
    constants.combiner = combiner.get();
    c.frame.retain(std::move(combiner), sizeof(CombinerProgram));
    program.add(kernels.combine);
    return;
  }
  // A comparison that fails leaves an alpha of 0, if nothing replaces it.
  const auto function = static_cast<Compare>(program.key.alpha_function);
  bool drops =
      function == Compare::Greater || (function == Compare::GreaterEqual && constants.alpha_reference_8 > 0);
  for (int u = kMaxTextureUnits - 1; u >= 0 && drops; --u) {
    if (!units[u]) continue;
    drops = is_modulate(chain.unit[u], u, base[u]);
    if (drops && units[u]->compares && units[u]->depth_components & 8 && takes(FastPath::EarlyAlpha))
      program.add(kernels.drop_shadowed, u);
  }
  for (int u = 0; u < kMaxTextureUnits; ++u)
    if (units[u])
      program.add(fused(u)                                 ? kernels.modulate_fixed
                  : is_modulate(chain.unit[u], u, base[u]) ? kernels.modulate
                                                           : kernels.replace,
                  u);
}

} // namespace softgl
