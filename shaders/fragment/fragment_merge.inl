// The end of a fragment: stencil, depth, blending, logic operation, masks. Works on vectors of fragments, no
// two of the same pixel, whose destination pixels lie side by side: in the tile, or gathered from it.
#pragma once

#include "shaders/fragment/fragment_blend.inl"
#include "shaders/fragment/fragment_stages.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Source fragments and the gathered pixels under them. Colors of Rgba8 and Rgb565 surfaces are RGBA8 words
/// here.
struct alignas(64) MergeBlock {
  int32_t lanes; // a multiple of 16
  uint32_t live[kLanes];
  uint32_t depth[kLanes], color[kLanes];          // source
  uint32_t depth_stencil[kLanes], target[kLanes]; // destination, in and out
};

/// Depths have at most 24 bits, or those of floats that are not negative: so signed comparison serves.
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
SOFTGL_INLINE IntV stencil_result(StencilOperation operation, const FragmentConstants& k, IntV where,
                                  IntV s) {
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

/// How many lanes are all ones (the others are zero).
SOFTGL_INLINE uint32_t count_lanes(IntV live) { return uint32_t(__builtin_popcountll(sign_bits(live))); }

SOFTGL_INLINE uint32_t word_mask(const FragmentKey& key) {
  uint32_t mask = 0;
  for (int c = 0; c < 4; ++c)
    if (key.color_mask >> c & 1) mask |= 0xffu << (8 * c);
  return mask;
}

namespace { // so that no member is visible outside

/// What merging of kWidth fragments at a time needs to know of a program.
struct Merger {
  const FragmentProgram& program;
  const FragmentKey& key = program.key;
  const bool tests = Compare(key.depth_function) != Compare::Always || key.depth_write || key.stencil;
  const bool over = is_over(key), sum = is_sum(key),
             floats = DepthFormat(key.depth_format) == DepthFormat::Z32F;
  const IntV mask = splat(int32_t(word_mask(key)));

  /// Stencil and depth test with their writes to `place`; gives the lanes that live on.
  SOFTGL_MEMBER IntV depth_stencil(IntV live, IntV z, uint32_t* place) const {
    if (!tests) return live;
    if (floats) return float_depth_stencil(live, z, place);
    const Compare depth_function = Compare(key.depth_function);
    IntV words = load(place);
    const IntV depth = words & 0xffffff;
    if (key.stencil) {
      IntV s = (IntV)((UintV)words >> 24);
      live = test_both(live, compare_words(depth_function, z, depth), s);
      words = depth | (s << 24);
    } else {
      live &= compare_words(depth_function, z, depth);
    }
    if (key.depth_write) words = choose(live & 0xffffff, z, words);
    store(place, words);
    return live;
  }

  /// Both tests, of stencil values `s`, which change; `nearer`: the depth test passes.
  SOFTGL_MEMBER IntV test_both(IntV live, IntV nearer, IntV& s) const {
    const FragmentConstants& k = *program.constants;
    const IntV passes = live & compare_words(Compare(key.stencil_function),
                                             splat(int32_t(k.stencil_reference & k.stencil_value_mask)),
                                             s & int32_t(k.stencil_value_mask));
    s = stencil_result(StencilOperation(key.stencil_fail), k, live & ~passes, s);
    live = passes & nearer;
    s = stencil_result(StencilOperation(key.stencil_depth_fail), k, passes & ~live, s);
    s = stencil_result(StencilOperation(key.stencil_pass), k, live, s);
    return live;
  }

  /// Of a plane of floats; its stencil values lie behind them.
  SOFTGL_MEMBER IntV float_depth_stencil(IntV live, IntV z, uint32_t* place) const {
    const IntV stored = load(place), nearer = compare_words(Compare(key.depth_function), z, stored);
    if (key.stencil) {
      IntV s = load(place + kTilePixels);
      live = test_both(live, nearer, s);
      store(place + kTilePixels, s);
    } else {
      live &= nearer;
    }
    if (key.depth_write) store(place, choose(live, z, stored));
    return live;
  }

  /// RGBA8 words to `place`.
  SOFTGL_MEMBER void color(IntV live, IntV source, uint32_t* place) const {
    const IntV target = load(place);
    if (over)
      source = blend_over(source, target);
    else if (sum)
      source = add_bytes(source, target);
    else if (key.logic_op)
      source = logic_words(unsigned(key.blend_source_rgb), source, target);
    else if (key.blend)
      source = blend_words(key, *program.constants, source, target);
    store(place, choose(live & mask, source, target));
  }
};

} // namespace

/// 5-6-5 to RGBA8 and back: bits are repeated one way and cut the other (OSMesa 22.3.6). Alpha reads as 1.
SOFTGL_INLINE uint32_t expand_565(uint32_t v) {
  const uint32_t r = v >> 11 & 31, g = v >> 5 & 63, b = v & 31;
  return (r << 3 | r >> 2) | (g << 2 | g >> 4) << 8 | (b << 3 | b >> 2) << 16 | 0xff000000u;
}
SOFTGL_INLINE uint16_t cut_565(uint32_t c) {
  return uint16_t((c & 0xf8) << 8 | (c >> 5 & 0x7e0) | (c >> 19 & 0x1f));
}

/// The factor of channel c (3 = alpha) of one pixel; `one` is the number that stands for 1.
template <class T>
SOFTGL_INLINE T factor_of_channel(BlendFactor f, int c, const T* s, const T* d, const T* constant, T one) {
  switch (f) {
  case BlendFactor::Zero: return 0;
  case BlendFactor::One: return one;
  case BlendFactor::SourceColor: return s[c];
  case BlendFactor::OneMinusSourceColor: return one - s[c];
  case BlendFactor::SourceAlpha: return s[3];
  case BlendFactor::OneMinusSourceAlpha: return one - s[3];
  case BlendFactor::DestinationAlpha: return d[3];
  case BlendFactor::OneMinusDestinationAlpha: return one - d[3];
  case BlendFactor::DestinationColor: return d[c];
  case BlendFactor::OneMinusDestinationColor: return one - d[c];
  case BlendFactor::SourceAlphaSaturate: return c == 3 ? one : s[3] < one - d[3] ? s[3] : one - d[3];
  case BlendFactor::ConstantColor: return constant[c];
  case BlendFactor::OneMinusConstantColor: return one - constant[c];
  case BlendFactor::ConstantAlpha: return constant[3];
  case BlendFactor::OneMinusConstantAlpha: return one - constant[3];
  }
  return 0;
}

SOFTGL_INLINE float combine_products(BlendEquation equation, float a, float b) {
  return equation == BlendEquation::Subtract          ? a - b
         : equation == BlendEquation::ReverseSubtract ? b - a
                                                      : a + b;
}
/// 16-bit sums saturate.
SOFTGL_INLINE int64_t combine_products(BlendEquation equation, int64_t a, int64_t b) {
  const int64_t v = equation == BlendEquation::Subtract          ? a - b
                    : equation == BlendEquation::ReverseSubtract ? b - a
                                                                 : a + b;
  return v < 0 ? 0 : v > 65535 ? 65535 : v;
}
SOFTGL_INLINE float product(float a, float b) { return a * b; }
/// a * b / 65535 as OSMesa 22.3.6 rounds it.
SOFTGL_INLINE int64_t product(int64_t a, int64_t b) {
  const int64_t p = a * b;
  return (p + (p >> 16) + 0x8000) >> 16;
}

/// Blending of one pixel of a float (T = float) or 16-bit (T = int64_t) surface.
template <class T> static void blend_wide(const FragmentProgram& program, const T* constant, T one,
                                          const T* s, const T* d, T* out) {
  const FragmentKey& key = program.key;
  const bool separate = BlendEquation(key.blend_equation) == BlendEquation::Separate;
  for (int c = 0; c < 4; ++c) {
    const auto equation =
        separate ? program.constants->blend_equation[c == 3] : BlendEquation(key.blend_equation);
    if (equation == BlendEquation::Min) {
      out[c] = s[c] < d[c] ? s[c] : d[c];
      continue;
    }
    if (equation == BlendEquation::Max) {
      out[c] = s[c] > d[c] ? s[c] : d[c];
      continue;
    }
    const auto sf = BlendFactor(c == 3 ? key.blend_source_alpha : key.blend_source_rgb);
    const auto df = BlendFactor(c == 3 ? key.blend_destination_alpha : key.blend_destination_rgb);
    out[c] = combine_products(equation, product(s[c], factor_of_channel(sf, c, s, d, constant, one)),
                              product(d[c], factor_of_channel(df, c, s, d, constant, one)));
  }
}

SOFTGL_INLINE uint16_t unorm_16(float v) {
  const float c = v > 0.0f ? (v < 1.0f ? v : 1.0f) : 0.0f;
  return uint16_t(_mm_cvtss_si32(_mm_set_ss(c * 65535.0f)));
}

SOFTGL_INLINE uint16_t logic_16(unsigned operation, uint16_t s, uint16_t d) {
  const uint16_t results[16] = {0,
                                uint16_t(s & d),
                                uint16_t(s & ~d),
                                s,
                                uint16_t(~s & d),
                                d,
                                uint16_t(s ^ d),
                                uint16_t(s | d),
                                uint16_t(~(s | d)),
                                uint16_t(~(s ^ d)),
                                uint16_t(~d),
                                uint16_t(s | ~d),
                                uint16_t(~s),
                                uint16_t(~s | d),
                                uint16_t(~(s & d)),
                                0xffff};
  return results[operation];
}

/// One pixel of a 16-bit or float surface.
static void store_wide(const FragmentProgram& program, ColorFormat format, const float source[4], void* color,
                       size_t pixel) {
  const FragmentKey& key = program.key;
  const FragmentConstants& k = *program.constants;
  if (format == ColorFormat::Rgba16) {
    uint16_t* target = static_cast<uint16_t*>(color) + 4 * pixel;
    int64_t s[4], d[4], out[4], constant[4];
    for (int c = 0; c < 4; ++c)
      out[c] = s[c] = unorm_16(source[c]), d[c] = target[c], constant[c] = unorm_16(k.blend_color[c]);
    if (key.blend) blend_wide<int64_t>(program, constant, 65535, s, d, out);
    for (int c = 0; c < 4; ++c) {
      if (!(key.color_mask >> c & 1)) continue;
      target[c] = key.logic_op ? logic_16(unsigned(key.blend_source_rgb), uint16_t(out[c]), target[c])
                               : uint16_t(out[c]);
    }
    return;
  }
  float* target = static_cast<float*>(color) + 4 * pixel;
  float out[4] = {source[0], source[1], source[2], source[3]};
  if (key.blend) blend_wide<float>(program, k.blend_color, 1.0f, source, target, out);
  for (int c = 0; c < 4; ++c)
    if (key.color_mask >> c & 1) target[c] = out[c];
}

} // namespace SOFTGL_ISA
} // namespace softgl
