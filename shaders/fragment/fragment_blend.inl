// Blending and logic operations on RGBA8 words, kWidth pixels at a time, in the 8-bit arithmetic of
// OSMesa 22.3.6. A vector of words is two vectors of 16-bit halves: red and blue, green and alpha.
#pragma once

#include "shaders/common/simd_pixels.h"
#include "shaders/fragment/fragment_program.h"

namespace softgl {
namespace SOFTGL_ISA {

struct Halves {
  ShortV rb, ga;
};

SOFTGL_INLINE Halves split(IntV words) {
  return {(ShortV)(words & 0x00ff00ff), (ShortV)((IntV)((UintV)words >> 8) & 0x00ff00ff)};
}
SOFTGL_INLINE IntV join(const Halves& h) { return (IntV)h.rb | ((IntV)h.ga << 8); }

/// a * b / 255 as OSMesa rounds it.
SOFTGL_INLINE ShortV multiply_8(ShortV a, ShortV b) {
  const ShortV p = a * b;
  return (p + (p >> 8) + 128) >> 8;
}
/// Halves are below 32768, so signed comparison serves.
SOFTGL_INLINE ShortV lesser(ShortV a, ShortV b) {
#if defined(__AVX2__) && !defined(__AVX512F__)
  return (ShortV)_mm256_min_epi16((__m256i)a, (__m256i)b);
#else
  const ShortV m = (ShortV)(a < b);
  return (a & m) | (b & ~m);
#endif
}

/// The alpha of every word in both halves.
SOFTGL_INLINE ShortV alpha_of(const Halves& h) {
  const IntV a = (IntV)((UintV)(IntV)h.ga >> 16);
  return (ShortV)(a | (a << 16));
}

SOFTGL_INLINE Halves factor_of(BlendFactor factor, const Halves& s, const Halves& d,
                               const uint8_t* constant) {
  const ShortV full = ShortV{} + uint16_t(255);
  auto both = [](ShortV v) { return Halves{v, v}; };
  auto inverse = [&](const Halves& h) { return Halves{full - h.rb, full - h.ga}; };
  const Halves color = {(ShortV)splat(int32_t(constant[0] | constant[2] << 16)),
                        (ShortV)splat(int32_t(constant[1] | constant[3] << 16))};
  const ShortV constant_alpha = ShortV{} + uint16_t(constant[3]);
  switch (factor) {
  case BlendFactor::Zero: return both(ShortV{});
  case BlendFactor::One: return both(full);
  case BlendFactor::SourceColor: return s;
  case BlendFactor::OneMinusSourceColor: return inverse(s);
  case BlendFactor::SourceAlpha: return both(alpha_of(s));
  case BlendFactor::OneMinusSourceAlpha: return both(full - alpha_of(s));
  case BlendFactor::DestinationAlpha: return both(alpha_of(d));
  case BlendFactor::OneMinusDestinationAlpha: return both(full - alpha_of(d));
  case BlendFactor::DestinationColor: return d;
  case BlendFactor::OneMinusDestinationColor: return inverse(d);
  case BlendFactor::SourceAlphaSaturate: {
    const ShortV f = lesser(alpha_of(s), full - alpha_of(d));
    return {f, (ShortV)(((IntV)f & 0xffff) | (255 << 16))};
  }
  case BlendFactor::ConstantColor: return color;
  case BlendFactor::OneMinusConstantColor: return inverse(color);
  case BlendFactor::ConstantAlpha: return both(constant_alpha);
  case BlendFactor::OneMinusConstantAlpha: return both(full - constant_alpha);
  }
  return both(ShortV{});
}

/// The halves of rgb with alpha taken from others.
SOFTGL_INLINE Halves with_alpha(const Halves& rgb, const Halves& alpha) {
  return {rgb.rb, (ShortV)(((IntV)rgb.ga & 0xffff) | ((IntV)alpha.ga & int32_t(0xffff0000)))};
}

/// Words times their factors. A product with 1 is the byte itself.
SOFTGL_INLINE IntV multiply_words(BlendFactor rgb, BlendFactor alpha, const Halves& v, IntV words,
                                  const Halves& s, const Halves& d, const uint8_t* constant) {
  if (rgb == alpha && rgb == BlendFactor::One) return words;
  if (rgb == alpha && rgb == BlendFactor::Zero) return IntV{};
  Halves f = factor_of(rgb, s, d, constant);
  if (alpha != rgb) f = with_alpha(f, factor_of(alpha, s, d, constant));
  return join({multiply_8(v.rb, f.rb), multiply_8(v.ga, f.ga)});
}

/// `s` and `d` are multiplied already, unless the equation has no factors.
SOFTGL_INLINE IntV combine_words(BlendEquation equation, IntV s, IntV d) {
  switch (equation) {
  case BlendEquation::Min: return min_bytes(s, d);
  case BlendEquation::Max: return max_bytes(s, d);
  case BlendEquation::Subtract: return subtract_bytes(s, d);
  case BlendEquation::ReverseSubtract: return subtract_bytes(d, s);
  case BlendEquation::Add:
  case BlendEquation::Separate: break; // the latter is none
  }
  return add_bytes(s, d);
}

/// Blends as the key says.
static IntV blend_words(const FragmentKey& key, const FragmentConstants& k, IntV source, IntV target) {
  const Halves s = split(source), d = split(target);
  const auto equation = BlendEquation(key.blend_equation);
  const bool separate = equation == BlendEquation::Separate;
  const BlendEquation rgb = separate ? k.blend_equation[0] : equation,
                      alpha = separate ? k.blend_equation[1] : equation;
  auto has_factors = [](BlendEquation e) __attribute__((always_inline)) {
    return e != BlendEquation::Min && e != BlendEquation::Max;
  };
  IntV sf = source, df = target;
  if (has_factors(rgb) || has_factors(alpha)) {
    sf = multiply_words(BlendFactor(key.blend_source_rgb), BlendFactor(key.blend_source_alpha), s, source, s,
                        d, k.blend_color_8);
    df = multiply_words(BlendFactor(key.blend_destination_rgb), BlendFactor(key.blend_destination_alpha), d,
                        target, s, d, k.blend_color_8);
  }
  auto blended = [&](BlendEquation e) __attribute__((always_inline)) {
    return has_factors(e) ? combine_words(e, sf, df) : combine_words(e, source, target);
  };
  if (!separate) return blended(rgb);
  return choose(splat(0xffffff), blended(rgb), blended(alpha));
}

/// SRC_ALPHA, ONE_MINUS_SRC_ALPHA with ADD, the blending that is used most.
SOFTGL_INLINE IntV blend_over(IntV source, IntV target) {
  const Halves s = split(source), d = split(target);
  const ShortV a = alpha_of(s), b = (ShortV{} + uint16_t(255)) - a;
  const ShortV top = ShortV{} + uint16_t(255);
  return join({lesser(multiply_8(s.rb, a) + multiply_8(d.rb, b), top),
               lesser(multiply_8(s.ga, a) + multiply_8(d.ga, b), top)});
}
SOFTGL_INLINE bool is_over(const FragmentKey& key) {
  const auto source = uint64_t(BlendFactor::SourceAlpha),
             destination = uint64_t(BlendFactor::OneMinusSourceAlpha);
  return key.blend && key.blend_equation == uint64_t(BlendEquation::Add) && key.blend_source_rgb == source &&
         key.blend_source_alpha == source && key.blend_destination_rgb == destination &&
         key.blend_destination_alpha == destination;
}

/// ONE, ONE with ADD: the product with 1 is the byte itself.
SOFTGL_INLINE bool is_sum(const FragmentKey& key) {
  const auto one = uint64_t(BlendFactor::One);
  return key.blend && key.blend_equation == uint64_t(BlendEquation::Add) && key.blend_source_rgb == one &&
         key.blend_source_alpha == one && key.blend_destination_rgb == one &&
         key.blend_destination_alpha == one;
}

/// GL 1.5, 4.1.9; `operation` counts from GL_CLEAR.
SOFTGL_INLINE IntV logic_words(unsigned operation, IntV s, IntV d) {
  switch (operation) {
  case 0: return IntV{};
  case 1: return s & d;
  case 2: return s & ~d;
  case 4: return ~s & d;
  case 5: return d;
  case 6: return s ^ d;
  case 7: return s | d;
  case 8: return ~(s | d);
  case 9: return ~(s ^ d);
  case 10: return ~d;
  case 11: return s | ~d;
  case 12: return ~s;
  case 13: return ~s | d;
  case 14: return ~(s & d);
  case 15: return splat(-1);
  default: return s; // GL_COPY
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
