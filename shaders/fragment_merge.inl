// The end of a fragment: stencil, depth, blending, logic operation, masks. Works on arrays of up to 64 fragments, no two of
// the same pixel, whose destination pixels have been gathered.
#pragma once

#include "fragment_blend.inl"
#include "fragment_stages.inl"
#include "raster_setup.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Source fragments and the pixels under them. Colours of Rgba8 and Rgb565 surfaces are RGBA8 words here.
struct alignas(64) MergeBlock {
  int32_t lanes; // a multiple of 16
  uint32_t live[kLanes];
  uint32_t depth[kLanes], color[kLanes]; // source
  uint32_t depth_stencil[kLanes], target[kLanes]; // destination, in and out
};

/// Depths have at most 24 bits, so signed comparison serves.
SOFTGL_INLINE IntV compare_words(Compare function, IntV value, IntV other) {
  switch (function) {
  case Compare::Never: return IntV{};
  case Compare::Less: return value < other;
  case Compare::Equal: return value == other;
  case Compare::LessEqual: return value <= other;
  case Compare::Greater: return value > other;
  case Compare::NotEqual: return value != other;
  case Compare::GreaterEqual: return value >= other;
  case Compare::Always: break;
  }
  return splat(-1);
}

/// GL 1.5, 4.1.5: the stencil values where `where` is set.
SOFTGL_INLINE IntV stencil_result(StencilOperation operation, const FragmentConstants& k, IntV where, IntV s) {
  IntV n = s;
  switch (operation) {
  case StencilOperation::Keep: return s;
  case StencilOperation::Zero: n = IntV{}; break;
  case StencilOperation::Replace: n = splat(int32_t(k.stencil_reference)); break;
  case StencilOperation::Increment: n = min_(s + 1, splat(255)); break;
  case StencilOperation::Decrement: n = max_(s - 1, IntV{}); break;
  case StencilOperation::Invert: n = ~s & 255; break;
  case StencilOperation::IncrementWrap: n = (s + 1) & 255; break;
  case StencilOperation::DecrementWrap: n = (s - 1) & 255; break;
  }
  return choose(where & int32_t(k.stencil_write_mask), n, s);
}

/// Stencil and depth test with their writes; live lanes are left in m.live.
static void merge_depth_stencil(const FragmentProgram& program, MergeBlock& m) {
  const FragmentKey& key = program.key;
  const FragmentConstants& k = *program.constants;
  const Compare depth_function = Compare(key.depth_function);
  if (depth_function == Compare::Always && !key.depth_write && !key.stencil) return;
  for (int i = 0; i < m.lanes; i += kWidth) {
    IntV words = load(m.depth_stencil + i), live = load(m.live + i);
    const IntV depth = words & 0xffffff, z = load(m.depth + i);
    if (key.stencil) {
      IntV s = (IntV)((UintV)words >> 24);
      const IntV passes = live & compare_words(Compare(key.stencil_function), splat(int32_t(k.stencil_reference & k.stencil_value_mask)), s & int32_t(k.stencil_value_mask));
      s = stencil_result(StencilOperation(key.stencil_fail), k, live & ~passes, s);
      live = passes & compare_words(depth_function, z, depth);
      s = stencil_result(StencilOperation(key.stencil_depth_fail), k, passes & ~live, s);
      s = stencil_result(StencilOperation(key.stencil_pass), k, live, s);
      words = depth | (s << 24);
    } else {
      live &= compare_words(depth_function, z, depth);
    }
    if (key.depth_write) words = choose(live & 0xffffff, z, words);
    store(m.depth_stencil + i, words);
    store(m.live + i, live);
  }
}

SOFTGL_INLINE uint32_t word_mask(const FragmentKey& key) {
  uint32_t mask = 0;
  for (int c = 0; c < 4; ++c)
    if (key.color_mask >> c & 1) mask |= 0xffu << (8 * c);
  return mask;
}

/// Everything for surfaces of 8 bits or less: m.color in, m.target and m.depth_stencil out.
static void merge_8(const FragmentProgram& program, MergeBlock& m) {
  const FragmentKey& key = program.key;
  merge_depth_stencil(program, m);
  if (key.color_mask == 0) return;
  const bool over = is_over(key);
  const IntV mask = splat(int32_t(word_mask(key)));
  for (int i = 0; i < m.lanes; i += kWidth) {
    IntV source = load(m.color + i);
    const IntV target = load(m.target + i);
    if (over) source = blend_over(source, target);
    else if (key.logic_op) source = logic_words(unsigned(key.blend_source_rgb), source, target);
    else if (key.blend) source = blend_words(key, *program.constants, source, target);
    store(m.target + i, choose(load(m.live + i) & mask, source, target));
  }
}

/// 5-6-5 to RGBA8 and back: bits are repeated one way and cut the other (OSMesa 22.3.6). Alpha reads as 1.
SOFTGL_INLINE uint32_t expand_565(uint32_t v) {
  const uint32_t r = v >> 11 & 31, g = v >> 5 & 63, b = v & 31;
  return (r << 3 | r >> 2) | (g << 2 | g >> 4) << 8 | (b << 3 | b >> 2) << 16 | 0xff000000u;
}
SOFTGL_INLINE uint16_t cut_565(uint32_t c) {
  return uint16_t((c & 0xf8) << 8 | (c >> 5 & 0x7e0) | (c >> 19 & 0x1f));
}

/// Blending of one pixel in float, for 16-bit and float surfaces.
static void blend_float(const FragmentKey& key, const FragmentConstants& k, const float* s, const float* d, float* out) {
  for (int c = 0; c < 4; ++c) {
    auto factor = [&](BlendFactor f) -> float {
      switch (f) {
      case BlendFactor::Zero: return 0;
      case BlendFactor::One: return 1;
      case BlendFactor::SourceColor: return s[c];
      case BlendFactor::OneMinusSourceColor: return 1 - s[c];
      case BlendFactor::SourceAlpha: return s[3];
      case BlendFactor::OneMinusSourceAlpha: return 1 - s[3];
      case BlendFactor::DestinationAlpha: return d[3];
      case BlendFactor::OneMinusDestinationAlpha: return 1 - d[3];
      case BlendFactor::DestinationColor: return d[c];
      case BlendFactor::OneMinusDestinationColor: return 1 - d[c];
      case BlendFactor::SourceAlphaSaturate: return c == 3 ? 1 : s[3] < 1 - d[3] ? s[3] : 1 - d[3];
      case BlendFactor::ConstantColor: return k.blend_color[c];
      case BlendFactor::OneMinusConstantColor: return 1 - k.blend_color[c];
      case BlendFactor::ConstantAlpha: return k.blend_color[3];
      case BlendFactor::OneMinusConstantAlpha: return 1 - k.blend_color[3];
      }
      return 0;
    };
    const auto equation = BlendEquation(key.blend_equation);
    if (equation == BlendEquation::Min) { out[c] = s[c] < d[c] ? s[c] : d[c]; continue; }
    if (equation == BlendEquation::Max) { out[c] = s[c] > d[c] ? s[c] : d[c]; continue; }
    const float a = s[c] * factor(BlendFactor(c == 3 ? key.blend_source_alpha : key.blend_source_rgb));
    const float b = d[c] * factor(BlendFactor(c == 3 ? key.blend_destination_alpha : key.blend_destination_rgb));
    out[c] = equation == BlendEquation::Subtract ? a - b : equation == BlendEquation::ReverseSubtract ? b - a : a + b;
  }
}

SOFTGL_INLINE uint16_t unorm_16(float v) {
  const float c = v > 0.0f ? (v < 1.0f ? v : 1.0f) : 0.0f;
  return uint16_t(_mm_cvtss_si32(_mm_set_ss(c * 65535.0f)));
}

/// One pixel of a 16-bit or float surface.
static void store_wide(const FragmentProgram& program, ColorFormat format, const float source[4], void* color, size_t pixel) {
  const FragmentKey& key = program.key;
  float s[4] = {source[0], source[1], source[2], source[3]}, d[4], out[4];
  uint16_t* narrow = static_cast<uint16_t*>(color) + 4 * pixel;
  float* wide = static_cast<float*>(color) + 4 * pixel;
  if (format == ColorFormat::Rgba16) {
    for (int c = 0; c < 4; ++c) {
      s[c] = s[c] > 0.0f ? (s[c] < 1.0f ? s[c] : 1.0f) : 0.0f;
      d[c] = float(narrow[c]) * (1.0f / 65535.0f);
    }
  } else {
    for (int c = 0; c < 4; ++c) d[c] = wide[c];
  }
  if (key.blend) blend_float(key, *program.constants, s, d, out);
  else for (int c = 0; c < 4; ++c) out[c] = s[c];
  for (int c = 0; c < 4; ++c) {
    if (!(key.color_mask >> c & 1)) continue;
    if (format == ColorFormat::Rgba16) {
      uint16_t v = unorm_16(out[c]);
      if (key.logic_op) {
        const uint16_t t = narrow[c];
        const unsigned op = unsigned(key.blend_source_rgb);
        const uint16_t table[16] = {0, uint16_t(v & t), uint16_t(v & ~t), v, uint16_t(~v & t), t, uint16_t(v ^ t), uint16_t(v | t),
                                    uint16_t(~(v | t)), uint16_t(~(v ^ t)), uint16_t(~t), uint16_t(v | ~t), uint16_t(~v),
                                    uint16_t(~v | t), uint16_t(~(v & t)), 0xffff};
        v = table[op];
      }
      narrow[c] = v;
    } else {
      wide[c] = out[c];
    }
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
