#include "snapshot/fragment_snapshot.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/kernel_table.h"
#include "base/unit_range.h"
#include "context/color_clamping.h"
#include "context/context.h"
#include "context/viewport_transform.h"
#include "fragment/fragment_keys.h"
#include "fragment/fragment_stages.h"
#include "shaders/common/seeded_faults.h"
#include "shaders/fragment/pixel_image.h"
#include "snapshot/texture_snapshot.h"

namespace softgl {

namespace {

uint64_t compare(GLenum function) { return function - GL_NEVER; }

uint64_t stencil_operation(GLenum operation) {
  switch (operation) {
  case GL_ZERO: return uint64_t(StencilOperation::Zero);
  case GL_REPLACE: return uint64_t(StencilOperation::Replace);
  case GL_INCR: return uint64_t(StencilOperation::Increment);
  case GL_DECR: return uint64_t(StencilOperation::Decrement);
  case GL_INVERT: return uint64_t(StencilOperation::Invert);
  case GL_INCR_WRAP: return uint64_t(StencilOperation::IncrementWrap);
  case GL_DECR_WRAP: return uint64_t(StencilOperation::DecrementWrap);
  default: return uint64_t(StencilOperation::Keep);
  }
}

uint64_t blend_factor(GLenum factor) {
  switch (factor) {
  case GL_ONE: return uint64_t(BlendFactor::One);
  case GL_SRC_COLOR: return uint64_t(BlendFactor::SourceColor);
  case GL_ONE_MINUS_SRC_COLOR: return uint64_t(BlendFactor::OneMinusSourceColor);
  case GL_SRC_ALPHA: return uint64_t(BlendFactor::SourceAlpha);
  case GL_ONE_MINUS_SRC_ALPHA: return uint64_t(BlendFactor::OneMinusSourceAlpha);
  case GL_DST_ALPHA: return uint64_t(BlendFactor::DestinationAlpha);
  case GL_ONE_MINUS_DST_ALPHA: return uint64_t(BlendFactor::OneMinusDestinationAlpha);
  case GL_DST_COLOR: return uint64_t(BlendFactor::DestinationColor);
  case GL_ONE_MINUS_DST_COLOR: return uint64_t(BlendFactor::OneMinusDestinationColor);
  case GL_SRC_ALPHA_SATURATE: return uint64_t(BlendFactor::SourceAlphaSaturate);
  case GL_CONSTANT_COLOR: return uint64_t(BlendFactor::ConstantColor);
  case GL_ONE_MINUS_CONSTANT_COLOR: return uint64_t(BlendFactor::OneMinusConstantColor);
  case GL_CONSTANT_ALPHA: return uint64_t(BlendFactor::ConstantAlpha);
  case GL_ONE_MINUS_CONSTANT_ALPHA: return uint64_t(BlendFactor::OneMinusConstantAlpha);
  default: return uint64_t(BlendFactor::Zero);
  }
}

uint64_t blend_equation(GLenum equation) {
  switch (equation) {
  case GL_FUNC_SUBTRACT: return uint64_t(BlendEquation::Subtract);
  case GL_FUNC_REVERSE_SUBTRACT: return uint64_t(BlendEquation::ReverseSubtract);
  case GL_MIN: return uint64_t(BlendEquation::Min);
  case GL_MAX: return uint64_t(BlendEquation::Max);
  default: return uint64_t(BlendEquation::Add);
  }
}

uint8_t unorm8(float x) {
  const float clamped = x > 0.0f ? std::min(x, 1.0f) : 0.0f;
  return static_cast<uint8_t>(std::lrint(clamped * 255.0f));
}

bool tests_stencil(const Context& context) {
  return context.state.stencil.test && context.draw->stencil_bits > 0;
}

void set_stencil(const StencilFace& face, FragmentKey& key, FragmentConstants& k) {
  key.stencil = 1;
  key.stencil_function = compare(face.function);
  key.stencil_fail = stencil_operation(face.fail);
  key.stencil_depth_fail = stencil_operation(face.depth_fail);
  key.stencil_pass = stencil_operation(face.depth_pass);
  k.stencil_reference = static_cast<uint8_t>(std::clamp(face.reference, 0, 255));
  k.stencil_value_mask = static_cast<uint8_t>(face.value_mask);
  k.stencil_write_mask = static_cast<uint8_t>(face.write_mask);
}

void set_fog(const FogState& fog, bool clamps, FragmentKey& key, FragmentConstants& k) {
  if (!fog.enabled) return;
  for (int i = 0; i < 4; ++i) {
    const float color = fog.color[i];
    k.fog_color[i] = !clamps ? color : color > 0.0f ? std::min(color, 1.0f) : 0.0f;
  }
  switch (fog.mode) {
  case GL_LINEAR:
    key.fog_mode = uint64_t(FogMode::Linear);
    k.fog_scale = fog.end == fog.start ? 1.0f : -1.0f / (fog.end - fog.start);
    k.fog_offset = fog.end * -k.fog_scale;
    break;
  case GL_EXP:
    key.fog_mode = uint64_t(FogMode::Exp);
    k.fog_scale = static_cast<float>(fog.density * 1.44269504088896340736); // log2 e
    break;
  default:
    key.fog_mode = uint64_t(FogMode::Exp2);
    k.fog_scale = static_cast<float>(fog.density * 1.20112240878644931); // sqrt(log2 e)
  }
}

/// The depth, in [0, 1], in the depth buffer's integers.
uint32_t stored_depth(DepthFormat format, double depth) {
  if (format == DepthFormat::Z32F) return std::bit_cast<uint32_t>(float(depth));
  return static_cast<uint32_t>(std::nearbyint(depth * largest_depth(format)));
}

/// The encoding in which colors are stored now, and the key's part of it.
void set_encoding(const Context& c, FragmentKey& key, FragmentConstants& k) {
  const Surface& surface = c.draw->surface;
  k.encoding = surface.encoding;
  k.encoding.srgb = surface.encoding.srgb && c.state.color_buffer.framebuffer_srgb;
  for (int i = 0; i < 4; ++i)
    if (k.encoding.bits[i] == 0) key.color_mask &= ~(uint64_t(1) << i);
  if (surface.color_format != ColorFormat::Rgba8) return;
  bool whole = true; // bytes
  for (uint8_t bits : k.encoding.bits) whole = whole && (bits == 0 || bits == 8);
  key.encoded = k.encoding.srgb || !whole || (key.blend && kept_components(k.encoding) == 1);
}

} // namespace

const FragmentProgram* make_fragment_program(Context& context, Arena& arena, const PixelImage* image) {
  const State& s = context.state;
  const Surface& surface = context.draw->surface;
  const ColorBufferState& c = s.color_buffer;
  auto& k = *arena.make<FragmentConstants>();
  auto& program = *arena.make<FragmentProgram>();
  FragmentKey& key = program.key;
  program.constants = &k;

  key.color_format = uint64_t(surface.color_format);
  key.depth_format = uint64_t(surface.depth_format);
  key.flat = s.lighting.shade_model == GL_FLAT && !SOFTGL_FAULT(flat_is_smooth);
  const bool separate = s.lighting.enabled && s.lighting.color_control == GL_SEPARATE_SPECULAR_COLOR;
  key.color_sum = separate || (!s.lighting.enabled && s.fog.color_sum);
  key.lit = !image && lights_fragments(s.lighting, context.smooth_is_phong); // a raster position has been lit
  key.secondary = key.color_sum && !key.lit;                                 // lit fragments make their own
  set_fog(s.fog, clamps_queried_colors(context), key, k);
  // What texturing and the color sum leave is clamped in front of the fog (3.9). OSMesa 22.3.6 does not.
  const bool clamp_fog = context.specification_answers && clamps_drawn(context, c.clamp_fragment_color);

  key.alpha_function = uint64_t(Compare::Always);
  if (c.alpha_test) key.alpha_function = compare(c.alpha_function);
  k.alpha_reference = c.alpha_reference;
  k.alpha_reference_8 = unorm8(c.alpha_reference);

  key.depth_function = uint64_t(Compare::Always);
  // A plane of depth and stencil together may stand for a buffer that has only one of them.
  if (s.depth.test && context.draw->depth_bits > 0) {
    key.depth_function = compare(s.depth.function);
    key.depth_write = s.depth.mask;
  }
  if (s.depth.bounds_test && context.draw->depth_bits > 0) {
    program.bounds_depth = true;
    k.least_bound = stored_depth(surface.depth_format, s.depth.least_bound);
    k.greatest_bound = stored_depth(surface.depth_format, s.depth.greatest_bound);
  }
  if (tests_stencil(context)) set_stencil(s.stencil.front, key, k);
  if (c.blend) {
    key.blend = 1;
    const auto equation = blend_equation(c.blend_equation), alpha = blend_equation(c.blend_equation_alpha);
    key.blend_equation = equation == alpha ? equation : uint64_t(BlendEquation::Separate);
    k.blend_equation[0] = BlendEquation(equation), k.blend_equation[1] = BlendEquation(alpha);
    key.blend_source_rgb = blend_factor(c.blend_source_rgb);
    key.blend_source_alpha = blend_factor(c.blend_source_alpha);
    key.blend_destination_rgb = blend_factor(c.blend_destination_rgb);
    key.blend_destination_alpha = blend_factor(c.blend_destination_alpha);
    for (int i = 0; i < 4; ++i) {
      k.blend_color[i] = c.blend_color[i];
      k.blend_color_8[i] = unorm8(c.blend_color[i]);
    }
  }
  if (c.logic_op) {
    key.logic_op = 1;
    key.blend_source_rgb = c.logic_op_mode - GL_CLEAR;
  }
  if (draws_color(context))
    for (int i = 0; i < 4; ++i) key.color_mask |= uint64_t(c.mask[i]) << i;
  // Components that the surface does not keep stay 0, and alpha 1, so that destination alpha reads as 1.
  set_encoding(context, key, k);

  key = simplify(key); // before the textures: their stages may take the color sum over
  if (image) {
    k.image = image;
    program.writes_depth = image->kind == PixelElement::Depth;
    program.add(kernels().raster->image[int(image->kind)]);
  }
  const DepthLimits limits = depth_limits(context);
  if (limits.least > 0 || limits.greatest < largest_depth(surface.depth_format)) {
    k.least_depth = limits.least, k.greatest_depth = limits.greatest;
    program.add(kernels().raster->clamp_depth);
    program.writes_depth = true;
  }
  if (key.lit) program.add(kernels().raster->light);
  append_texture_stages(context, arena, program, k);
  append_fragment_stages(program, clamps_fragment_colors(context), clamp_fog);
  return &program;
}

DepthLimits depth_limits(const Context& context) {
  const uint32_t largest = largest_depth(context.draw->surface.depth_format);
  if (!context.state.transform.depth_clamp) return {0, largest};
  const ViewportTransform window = viewport_transform(context.state);
  const float scale = window.scale[2], offset = window.offset[2];
  const auto [low, high] =
      std::minmax({depths_from_zero(context.state) ? offset : offset - scale, offset + scale});
  const bool floats = context.draw->surface.depth_format == DepthFormat::Z32F;
  const auto integer = [&](float depth) {
    if (floats) return std::bit_cast<uint32_t>(unit_range(depth));
    return static_cast<uint32_t>(std::lrint(unit_range(depth) * static_cast<float>(largest)));
  };
  return {integer(low), integer(high)};
}

const FragmentProgram* make_back_program(const Context& context, const FragmentProgram& front, Arena& arena) {
  const StencilState& stencil = context.state.stencil;
  if (!tests_stencil(context) || stencil.seen_back() == stencil.front) return nullptr;
  auto& k = *arena.make<FragmentConstants>(*front.constants);
  auto& program = *arena.make<FragmentProgram>(front);
  set_stencil(stencil.seen_back(), program.key, k);
  program.key = simplify(program.key);
  program.constants = &k;
  return &program;
}

const SmoothPrograms* make_smooth_programs(const Context& c, const FragmentProgram& program, Arena& arena) {
  const State& s = c.state;
  if (s.multisample.enabled && c.draw->surface.samples > 1) return nullptr; // 3.3.3, 3.4.4, 3.5.7
  // The squares of point sprites are not antialiased (GL_ARB_point_sprite).
  const bool points = s.point.smooth && !s.point.sprite;
  if (!points && !s.line.smooth && !s.polygon.smooth) return nullptr;
  auto with = [&](bool smooth, Coverage coverage) {
    return smooth ? arena.make<FragmentProgram>(with_coverage(program, coverage)) : nullptr;
  };
  return arena.make<SmoothPrograms>(with(points, Coverage::Point), with(s.line.smooth, Coverage::Line),
                                    with(s.polygon.smooth, Coverage::Polygon));
}

namespace {

/// A program whose only stage fetches the elements of the image.
FragmentProgram& make_image_program(Context& context, Arena& arena, const PixelImage& image,
                                    FragmentConstants& k) {
  const Surface& surface = context.draw->surface;
  auto& program = *arena.make<FragmentProgram>();
  FragmentKey& key = program.key;
  key.color_format = uint64_t(surface.color_format);
  key.depth_format = uint64_t(surface.depth_format);
  key.alpha_function = key.depth_function = key.stencil_function = uint64_t(Compare::Always);
  k.image = &image;
  program.constants = &k;
  program.add(kernels().raster->image[int(image.kind)]);
  return program;
}

} // namespace

const FragmentProgram* make_stencil_program(Context& context, Arena& arena, const PixelImage& image,
                                            uint32_t write_mask) {
  auto& k = *arena.make<FragmentConstants>();
  FragmentProgram& program = make_image_program(context, arena, image, k);
  program.writes_depth = program.writes_stencil = true;
  program.key.stencil = 1;
  program.key.stencil_pass = uint64_t(StencilOperation::Replace);
  k.stencil_write_mask = static_cast<uint8_t>(write_mask);
  return &program;
}

const FragmentProgram* make_copy_program(Context& context, Arena& arena, const PixelImage& image) {
  auto& k = *arena.make<FragmentConstants>();
  FragmentProgram& program = make_image_program(context, arena, image, k);
  program.writes_depth = image.kind == PixelElement::Depth;
  if (program.writes_depth)
    program.key.depth_write = 1;
  else
    program.key.color_mask = 15;
  set_encoding(context, program.key, k);
  return &program;
}

} // namespace softgl
