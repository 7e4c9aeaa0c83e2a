// Blending of strips of pixels whose colors are not four bytes (ColorEncoding), in the arithmetic of
// OSMesa 22.3.6, which has short cuts of its own where a color has but one component.
#pragma once

#include "shaders/fragment/fragment_numbers.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Vectors of a strip's lanes.
constexpr int kStripVectors = kStripLanes / kWidth;

namespace { // so that no member is visible outside

/// The numbers of a strip's colors, by component.
template <class A> struct StripColors {
  using T = typename A::T;
  T source[4][kStripVectors], target[4][kStripVectors];
};

} // namespace

/// The factors of component c (3 = alpha) of a strip.
template <class A, class T = typename A::T> SOFTGL_INLINE void
find_factors(BlendFactor f, int c, const StripColors<A>& strip, const float* constant, T* factor) {
  const T one = A::one();
  const T *s = strip.source[c], *d = strip.target[c], *s3 = strip.source[3], *d3 = strip.target[3];
  auto each = [&](auto value) __attribute__((always_inline)) {
    for (int g = 0; g < kStripVectors; ++g) factor[g] = value(g);
  };
  auto all = [&](T value) __attribute__((always_inline)) {
    for (int g = 0; g < kStripVectors; ++g) factor[g] = value;
  };
  auto copy = [&](const T* from) __attribute__((always_inline)) {
    for (int g = 0; g < kStripVectors; ++g) factor[g] = from[g];
  };
  auto invert = [&](const T* from) __attribute__((always_inline)) {
    for (int g = 0; g < kStripVectors; ++g) factor[g] = one - from[g];
  };
  switch (f) {
  case BlendFactor::Zero: break;
  case BlendFactor::One: return all(one);
  case BlendFactor::SourceColor: return copy(s);
  case BlendFactor::OneMinusSourceColor: return invert(s);
  case BlendFactor::SourceAlpha: return copy(s3);
  case BlendFactor::OneMinusSourceAlpha: return invert(s3);
  case BlendFactor::DestinationAlpha: return copy(d3);
  case BlendFactor::OneMinusDestinationAlpha: return invert(d3);
  case BlendFactor::DestinationColor: return copy(d);
  case BlendFactor::OneMinusDestinationColor: return invert(d);
  case BlendFactor::SourceAlphaSaturate:
    if (c == 3) return all(one);
    return each([&](int g) __attribute__((always_inline)) { return min_(s3[g], A::room(d3[g])); });
  case BlendFactor::ConstantColor: return all(A::stored(splat(constant[c])));
  case BlendFactor::OneMinusConstantColor: return all(one - A::stored(splat(constant[c])));
  case BlendFactor::ConstantAlpha: return all(A::stored(splat(constant[3])));
  case BlendFactor::OneMinusConstantAlpha: return all(one - A::stored(splat(constant[3])));
  }
  all(T{});
}

template <class T> SOFTGL_INLINE T combine_products(BlendEquation equation, T a, T b) {
  return equation == BlendEquation::Subtract          ? a - b
         : equation == BlendEquation::ReverseSubtract ? b - a
                                                      : a + b;
}

SOFTGL_INLINE bool is_one_minus(BlendFactor f) {
  return f == BlendFactor::OneMinusSourceColor || f == BlendFactor::OneMinusSourceAlpha ||
         f == BlendFactor::OneMinusDestinationAlpha || f == BlendFactor::OneMinusDestinationColor ||
         f == BlendFactor::OneMinusConstantColor || f == BlendFactor::OneMinusConstantAlpha;
}
/// b is 1 - a.
SOFTGL_INLINE bool is_inverse(BlendFactor a, BlendFactor b) {
  if (a == BlendFactor::One) return b == BlendFactor::Zero;
  if (!is_one_minus(b)) return false;
  // A factor stands in front of its complement.
  return a != BlendFactor::Zero && int(a) + 1 == int(b);
}

namespace { // so that no member is visible outside

/// The factors of one component.
struct FactorPair {
  BlendFactor source, destination;
  /// Destination alpha is 1 where there is none.
  SOFTGL_MEMBER FactorPair without_alpha() const {
    return {without_alpha(source), without_alpha(destination)};
  }
  SOFTGL_MEMBER static BlendFactor without_alpha(BlendFactor f) {
    return f == BlendFactor::DestinationAlpha           ? BlendFactor::One
           : f == BlendFactor::OneMinusDestinationAlpha ? BlendFactor::Zero
                                                        : f;
  }
};

struct Blending {
  FactorPair rgb = {}, alpha = {};
  BlendEquation equation[2] = {};
  bool has_alpha = false, alone = false, few = false; // alone: one component is kept; few: one or two
  bool alike = false;                                 // OSMesa takes a common factor out of floats

  /// Nothing where the colors are RGBA8 words.
  SOFTGL_MEMBER explicit Blending(const FragmentProgram& program) {
    const FragmentKey& key = program.key;
    if (!key.blend || (ColorFormat(key.color_format) == ColorFormat::Rgba8 && !key.encoded)) return;
    const ColorEncoding& e = program.constants->encoding;
    rgb = {BlendFactor(key.blend_source_rgb), BlendFactor(key.blend_destination_rgb)};
    alpha = {BlendFactor(key.blend_source_alpha), BlendFactor(key.blend_destination_alpha)};
    const bool separate = BlendEquation(key.blend_equation) == BlendEquation::Separate;
    for (int i = 0; i < 2; ++i)
      equation[i] = separate ? program.constants->blend_equation[i] : BlendEquation(key.blend_equation);
    has_alpha = e.bits[3] != 0;
    alone = kept_components(e) == 1, few = kept_components(e) <= 2;
    if (!has_alpha) rgb = alpha = rgb.without_alpha();
    alike = alone || (rgb.source == rgb.destination && alpha.source == alpha.destination);
  }
  /// A factor of `pair` is 0, and so it is for all components that are kept.
  SOFTGL_MEMBER bool is_zero(const FactorPair& pair, BlendFactor FactorPair::*factor) const {
    return pair.*factor == BlendFactor::Zero && (alone || rgb.*factor == alpha.*factor);
  }
};

} // namespace

/// Component c of a strip's blended colors (GL 1.5, 4.1.7).
template <class A, class T = typename A::T> static void
blend_component(const Blending& b, int c, const StripColors<A>& strip, const float* constant, T* out) {
  const BlendEquation equation = b.equation[c == 3];
  const FactorPair& pair = c == 3 ? b.alpha : b.rgb;
  const T *s = strip.source[c], *d = strip.target[c];
  auto each = [&](auto value) __attribute__((always_inline)) {
    for (int g = 0; g < kStripVectors; ++g) out[g] = value(g);
  };
  if (equation == BlendEquation::Min)
    return each([&](int g) __attribute__((always_inline)) { return min_(s[g], d[g]); });
  if (equation == BlendEquation::Max)
    return each([&](int g) __attribute__((always_inline)) { return max_(s[g], d[g]); });
  T sf[kStripVectors], df[kStripVectors];
  find_factors<A>(pair.source, c, strip, constant, sf);
  find_factors<A>(pair.destination, c, strip, constant, df);
  const bool first = is_inverse(pair.source, pair.destination), // which of the two is the other's complement
      second = !first && is_inverse(pair.destination, pair.source);
  if (b.alone && equation == BlendEquation::Add && first)
    return each([&](int g) __attribute__((always_inline)) { return A::mix(sf[g], d[g], s[g]); });
  if (b.alone && equation == BlendEquation::Add && second)
    return each([&](int g) __attribute__((always_inline)) { return A::mix(df[g], s[g], d[g]); });
  if constexpr (A::kFloat) {
    if (b.alone && (first || second)) { // a difference
      const bool minuend = (equation == BlendEquation::Subtract) == first;
      return each([&](int g) __attribute__((always_inline)) {
        const T part = (s[g] + d[g]) * (first ? sf[g] : df[g]), whole = first ? d[g] : s[g];
        return minuend ? part - whole : whole - part;
      });
    }
    // Where the factor of all components is 0 there is no product, whose zero might be negative.
    const bool no_source = b.is_zero(pair, &FactorPair::source),
               no_destination = b.is_zero(pair, &FactorPair::destination);
    if (b.alike && pair.source == pair.destination)
      return each([&](int g) __attribute__((always_inline)) {
        return no_source ? T{} : combine_products(equation, s[g], d[g]) * sf[g];
      });
    if (equation == BlendEquation::Add && (no_source || no_destination))
      return each([&](int g)
                      __attribute__((always_inline)) { return no_source ? d[g] * df[g] : s[g] * sf[g]; });
    each([&](int g) __attribute__((always_inline)) {
      return combine_products(equation, no_source ? T{} : s[g] * sf[g], no_destination ? T{} : d[g] * df[g]);
    });
  } else if constexpr (A::kSigned) {
    const bool source_inverted = is_one_minus(pair.source), inverted = is_one_minus(pair.destination);
    if (source_inverted || inverted) {
      // Factors up to 2, and no limit before the end.
      const T least = splat(-A::kOne);
      return each([&](int g) __attribute__((always_inline)) {
        const T from_s = source_inverted ? max_(s[g], least) : s[g],
                from_d = inverted ? max_(d[g], least) : d[g];
        return A::limited(
            combine_products(equation, A::wide_product(from_s, sf[g]), A::wide_product(from_d, df[g])));
      });
    }
    // A product with 1 is not made where all components' factor is 1.
    const bool whole_s = b.rgb.source == BlendFactor::One && b.alpha.source == BlendFactor::One,
               whole_d = b.rgb.destination == BlendFactor::One && b.alpha.destination == BlendFactor::One;
    each([&](int g) __attribute__((always_inline)) {
      return A::limited(combine_products(equation, whole_s ? s[g] : A::product(s[g], sf[g]),
                                         whole_d ? d[g] : A::product(d[g], df[g])));
    });
  } else {
    each([&](int g) __attribute__((always_inline)) {
      return A::limited(combine_products(equation, A::product(s[g], sf[g]), A::product(d[g], df[g])));
    });
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
