// Blending, logic operation and masks of one pixel whose color is not four bytes as they are (ColorEncoding),
// in the arithmetic of OSMesa 22.3.6, which has short cuts of its own where a color has but one component.
#pragma once

#include "shaders/common/color_encoding.h"
#include "shaders/common/lane_math.h"
#include "shaders/common/simd.h"
#include "shaders/common/srgb.h"
#include "shaders/fragment/fragment_program.h"

namespace softgl {
namespace SOFTGL_ISA {

SOFTGL_INLINE int32_t nearest_integer(float v) { return _mm_cvtss_si32(_mm_set_ss(v)); }

namespace { // so that no member is visible outside

/// Numbers of [0, 1]: integers of which the greatest one is 1.
template <int kBits> struct UnsignedArithmetic {
  using T = int64_t;
  static constexpr bool kFloat = false, kSigned = false;
  static constexpr T kOne = (1 << kBits) - 1;
  static T stored(float v) { return nearest_integer(saturate(v) * float(kOne)); }
  static T limited(T v) { return v < 0 ? 0 : v > kOne ? kOne : v; }
  static T product(T a, T b) {
    const T p = a * b;
    return (p + (p >> kBits) + (1 << (kBits - 1))) >> kBits;
  }
  static T wide_product(T a, T b) { return product(a, b); }
  static T room(T alpha) { return kOne - alpha; }
  static T mix(T weight, T from, T to) {
    const T scaled = weight + (weight >> (kBits - 1));
    return (from + ((scaled * (to - from) + (kBits == 8 ? 128 : 0)) >> kBits)) & kOne;
  }
  static T logic(T v) { return v & kOne; }
};

/// Numbers of [-1, 1].
template <int kBits> struct SignedArithmetic {
  using T = int64_t;
  static constexpr bool kFloat = false, kSigned = true;
  static constexpr T kOne = (1 << (kBits - 1)) - 1;
  /// Bytes become -128 where a color is less than -1 (GL_EXT_texture_snorm reads it as -1, too).
  static T stored(float v) {
    const float least = kBits == 8 ? -128.0f / float(kOne) : -1.0f;
    return nearest_integer(minimum(maximum(v, least), 1.0f) * float(kOne));
  }
  static T limited(T v) { return v < -kOne - 1 ? -kOne - 1 : v > kOne ? kOne : v; }
  /// Products have twice as many bits, and wrap around.
  static T doubled(T v) { return T(uint64_t(v) << (64 - 2 * kBits)) >> (64 - 2 * kBits); }
  static T wide_product(T a, T b) {
    T p = a * b;
    p = doubled(p + (p >> (kBits - 1)));
    return doubled(p + (p < 0 ? -(1 << (kBits - 2)) : 1 << (kBits - 2))) >> (kBits - 1);
  }
  static T product(T a, T b) { return limited(wide_product(a, b)); }
  static T room(T alpha) { return kOne - (alpha > 0 ? alpha : 0); }
  static T mix(T weight, T from, T to) { return limited(from + wide_product(weight, to - from)); }
  static T logic(T v) { return T(uint64_t(v) << (64 - kBits)) >> (64 - kBits); }
};

struct FloatArithmetic {
  using T = float;
  static constexpr bool kFloat = true, kSigned = true;
  static constexpr T kOne = 1;
  static T limited(T v) { return v; }
  static T product(T a, T b) { return a * b; }
  static T wide_product(T a, T b) { return a * b; }
  static T room(T alpha) { return 1 - alpha; }
  static T mix(T weight, T from, T to) { return weight * (to - from) + from; }
};

} // namespace

/// The factor of component c (3 = alpha).
template <class A, class T = typename A::T>
SOFTGL_INLINE T factor_of_component(BlendFactor f, int c, const T* s, const T* d, const T* constant) {
  const T one = A::kOne;
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
  case BlendFactor::SourceAlphaSaturate: {
    const T room = A::room(d[3]);
    return c == 3 ? one : s[3] < room ? s[3] : room;
  }
  case BlendFactor::ConstantColor: return constant[c];
  case BlendFactor::OneMinusConstantColor: return one - constant[c];
  case BlendFactor::ConstantAlpha: return constant[3];
  case BlendFactor::OneMinusConstantAlpha: return one - constant[3];
  }
  return 0;
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
  FactorPair rgb, alpha;
  BlendEquation equation[2];
  bool has_alpha, alone, few; // alone: one component is kept; few: one or two
  bool alike;                 // OSMesa takes a common factor out of floats

  SOFTGL_MEMBER explicit Blending(const FragmentProgram& program) {
    const FragmentKey& key = program.key;
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
};

} // namespace

/// Component c of the blended color (GL 1.5, 4.1.7).
template <class A, class T = typename A::T>
static T blended_component(const Blending& b, int c, const T* s, const T* d, const T* constant) {
  const BlendEquation equation = b.equation[c == 3];
  if (equation == BlendEquation::Min) return s[c] < d[c] ? s[c] : d[c];
  if (equation == BlendEquation::Max) return s[c] > d[c] ? s[c] : d[c];
  const FactorPair& pair = c == 3 ? b.alpha : b.rgb;
  const T f = factor_of_component<A>(pair.source, c, s, d, constant),
          g = factor_of_component<A>(pair.destination, c, s, d, constant);
  if (b.alone && equation == BlendEquation::Add) {
    if (is_inverse(pair.source, pair.destination)) return A::mix(f, d[c], s[c]);
    if (is_inverse(pair.destination, pair.source)) return A::mix(g, s[c], d[c]);
  }
  if constexpr (A::kFloat) {
    const bool first = is_inverse(pair.source, pair.destination);
    if (b.alone && (first || is_inverse(pair.destination, pair.source))) { // a difference
      const T part = (s[c] + d[c]) * (first ? f : g);
      return (equation == BlendEquation::Subtract) == first ? first ? part - d[c] : part - s[c]
             : first ? d[c] - part
                                                            : s[c] - part;
    }
    if (b.alike && pair.source == pair.destination) return combine_products(equation, s[c], d[c]) * f;
    return combine_products(equation, s[c] * f, d[c] * g);
  } else if constexpr (A::kSigned) {
    if (is_one_minus(pair.source) || is_one_minus(pair.destination)) {
      // Factors up to 2, and no limit before the end.
      const auto from = [&](T v, BlendFactor factor) {
        return is_one_minus(factor) && v < -A::kOne ? -A::kOne : v;
      };
      return A::limited(combine_products(equation, A::wide_product(from(s[c], pair.source), f),
                                         A::wide_product(from(d[c], pair.destination), g)));
    }
    // A product with 1 is not made where all components' factor is 1.
    const auto term = [&](T v, BlendFactor FactorPair::*which, T factor) {
      const bool whole = b.rgb.*which == BlendFactor::One && b.alpha.*which == BlendFactor::One;
      return whole ? v : A::product(v, factor);
    };
    return A::limited(combine_products(equation, term(s[c], &FactorPair::source, f),
                                       term(d[c], &FactorPair::destination, g)));
  } else {
    return A::limited(combine_products(equation, A::product(s[c], f), A::product(d[c], g)));
  }
}

SOFTGL_INLINE int64_t logic_number(unsigned operation, int64_t s, int64_t d) {
  const int64_t results[16] = {0,        s & d,    s & ~d, s,      ~s & d, d,      s ^ d,    s | d,
                               ~(s | d), ~(s ^ d), ~d,     s | ~d, ~s,     ~s | d, ~(s & d), -1};
  return results[operation];
}

/// Integers: `target` has four of type Stored.
template <class A, class Stored, class Reduce> static void
store_integers(const FragmentProgram& program, const float* source, Stored* target, Reduce reduce) {
  const FragmentKey& key = program.key;
  int64_t s[4], d[4], constant[4], out[4];
  for (int c = 0; c < 4; ++c) out[c] = s[c] = A::stored(source[c]), d[c] = target[c];
  if (key.logic_op) {
    for (int c = 0; c < 4; ++c) out[c] = A::logic(logic_number(unsigned(key.blend_source_rgb), s[c], d[c]));
  } else if (key.blend) {
    const Blending blending(program);
    if (A::kSigned && !blending.has_alpha && blending.few && s[3] < -A::kOne) s[3] = -A::kOne;
    for (int c = 0; c < 4; ++c) constant[c] = A::stored(program.constants->blend_color[c]);
    for (int c = 0; c < 4; ++c) out[c] = blended_component<A>(blending, c, s, d, constant);
  }
  for (int c = 0; c < 4; ++c)
    if (key.color_mask >> c & 1) target[c] = Stored(reduce(out[c], program.constants->encoding.bits[c]));
}

/// Logic operations leave floats alone.
static void merge_floats(const FragmentProgram& program, const float* s, const float* d,
                         const float* constant, float* out) {
  for (int c = 0; c < 4; ++c) out[c] = s[c];
  if (!program.key.blend || program.key.logic_op) return;
  const Blending blending(program);
  for (int c = 0; c < 4; ++c) out[c] = blended_component<FloatArithmetic>(blending, c, s, d, constant);
}

/// Bytes of sRGB are blended as linear floats (GL_EXT_framebuffer_sRGB).
static void store_srgb(const FragmentProgram& program, const float* source, uint8_t* target) {
  float s[4], d[4], constant[4], out[4];
  for (int c = 0; c < 4; ++c) {
    s[c] = saturate(source[c]), constant[c] = saturate(program.constants->blend_color[c]);
    d[c] = c == 3 ? float(target[c]) * (1.0f / 255.0f) : srgb_to_linear(float(target[c]));
  }
  merge_floats(program, s, d, constant, out);
  for (int c = 0; c < 4; ++c) {
    if (!(program.key.color_mask >> c & 1)) continue;
    const float v = saturate(out[c]);
    target[c] = uint8_t(nearest_integer(c == 3 ? v * 255.0f : linear_to_srgb(v)));
  }
}

/// One pixel of the surface. Not of Rgb565.
static void store_encoded(const FragmentProgram& program, const float* source, void* color, size_t pixel) {
  const FragmentKey& key = program.key;
  const ColorEncoding& e = program.constants->encoding;
  switch (ColorFormat(key.color_format)) {
  case ColorFormat::Rgba8: {
    uint8_t* target = static_cast<uint8_t*>(color) + 4 * pixel;
    if (e.srgb) return store_srgb(program, source, target);
    return store_integers<UnsignedArithmetic<8>>(
        program, source, target, [](int64_t v, int bits) { return drawn_number(uint32_t(v), bits, 8); });
  }
  case ColorFormat::Rgba16: {
    if (e.numbers == ColorNumbers::Unsigned)
      return store_integers<UnsignedArithmetic<16>>(
          program, source, static_cast<uint16_t*>(color) + 4 * pixel,
          [](int64_t v, int bits) { return drawn_number(uint32_t(v), bits, 16); });
    int16_t* target = static_cast<int16_t*>(color) + 4 * pixel;
    const auto same = [](int64_t v, int) { return v; };
    if (e.bits[0] == 8 || e.bits[3] == 8)
      return store_integers<SignedArithmetic<8>>(program, source, target, same);
    return store_integers<SignedArithmetic<16>>(program, source, target, same);
  }
  case ColorFormat::RgbaFloat: {
    float* target = static_cast<float*>(color) + 4 * pixel;
    float out[4];
    merge_floats(program, source, target, program.constants->blend_color, out);
    for (int c = 0; c < 4; ++c)
      if (key.color_mask >> c & 1) target[c] = drawn_float(out[c], e.bits[c]);
    return;
  }
  case ColorFormat::Rgb565: return;
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
