// Blending, logic operation and masks of strips of pixels whose colors are not four bytes as they are
// (ColorEncoding), in the arithmetic of OSMesa 22.3.6, which has short cuts of its own where a color has but
// one component.
#pragma once

#include "shaders/common/srgb.h"
#include "shaders/fragment/fragment_merge.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Vectors of a strip's lanes.
constexpr int kStripVectors = kStripLanes / kWidth;

namespace { // so that no member is visible outside

/// Numbers of [0, 1]: integers of 16 bits, of which the greatest one is 1.
struct UnsignedArithmetic {
  using T = IntV;
  static constexpr bool kFloat = false, kSigned = false;
  static constexpr int32_t kOne = 0xffff;
  SOFTGL_MEMBER static T one() { return splat(kOne); }
  SOFTGL_MEMBER static T stored(FloatV v) { return round_to_int(unit_range(v) * float(kOne)); }
  SOFTGL_MEMBER static T limited(T v) { return min_(max_(v, T{}), one()); }
  SOFTGL_MEMBER static T product(T a, T b) {
    const UintV p = (UintV)multiply(a, b);
    return (T)((p + (p >> 16) + 0x8000u) >> 16);
  }
  SOFTGL_MEMBER static T wide_product(T a, T b) { return product(a, b); }
  SOFTGL_MEMBER static T room(T alpha) { return kOne - alpha; }
  /// Of the product, which may not fit, the 16 bits are right that count.
  SOFTGL_MEMBER static T mix(T weight, T from, T to) {
    return (from + (T)((UintV)multiply(weight + (weight >> 15), to - from) >> 16)) & kOne;
  }
};

/// Numbers of [-1, 1].
template <int kBits> struct SignedArithmetic {
  using T = IntV;
  static constexpr bool kFloat = false, kSigned = true;
  static constexpr int32_t kOne = (1 << (kBits - 1)) - 1;
  SOFTGL_MEMBER static T one() { return splat(kOne); }
  /// Bytes become -128 where a color is less than -1 (GL_EXT_texture_snorm reads it as -1, too).
  SOFTGL_MEMBER static T stored(FloatV v) {
    const float least = kBits == 8 ? -128.0f / float(kOne) : -1.0f;
    return round_to_int(min_(max_(v, splat(least)), splat(1.0f)) * float(kOne));
  }
  SOFTGL_MEMBER static T limited(T v) { return min_(max_(v, splat(-kOne - 1)), one()); }
  /// Products have twice as many bits, and wrap around.
  SOFTGL_MEMBER static T doubled(UintV v) { return (T)(v << (32 - 2 * kBits)) >> (32 - 2 * kBits); }
  SOFTGL_MEMBER static T wide_product(T a, T b) {
    const T exact = multiply(a, b), p = doubled((UintV)exact + (UintV)(exact >> (kBits - 1)));
    const T half = choose(p < 0, splat(-(1 << (kBits - 2))), splat(1 << (kBits - 2)));
    return doubled((UintV)p + (UintV)half) >> (kBits - 1);
  }
  SOFTGL_MEMBER static T product(T a, T b) { return limited(wide_product(a, b)); }
  SOFTGL_MEMBER static T room(T alpha) { return kOne - max_(alpha, T{}); }
  SOFTGL_MEMBER static T mix(T weight, T from, T to) {
    return limited(from + wide_product(weight, to - from));
  }
};

struct FloatArithmetic {
  using T = FloatV;
  static constexpr bool kFloat = true, kSigned = true;
  SOFTGL_MEMBER static T one() { return splat(1.0f); }
  SOFTGL_MEMBER static T stored(FloatV v) { return v; }
  SOFTGL_MEMBER static T limited(T v) { return v; }
  SOFTGL_MEMBER static T product(T a, T b) { return a * b; }
  SOFTGL_MEMBER static T room(T alpha) { return 1.0f - alpha; }
  SOFTGL_MEMBER static T mix(T weight, T from, T to) { return weight * (to - from) + from; }
};

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
    if (b.alike && pair.source == pair.destination)
      return each([&](int g) __attribute__((always_inline)) {
        return combine_products(equation, s[g], d[g]) * sf[g];
      });
    each([&](int g) __attribute__((always_inline)) {
      return combine_products(equation, s[g] * sf[g], d[g] * df[g]);
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

/// drawn_number() of vectors.
template <int kWide> SOFTGL_INLINE IntV drawn_numbers(IntV v, int bits) {
  if (bits == kWide) return v;
  const int rest = kWide - bits;
  IntV n;
  if (bits == 4 && kWide == 8) {
    const IntV more = v + 8;
    n = ((more << 8) - (more << 4) + more) >> 12; // by 17
  } else if (rest <= bits) {
    n = v >> rest;
  } else {
    const IntV upper = v >> bits;
    n = ((upper << bits) - upper + (1 << (rest - 1))) >> rest;
  }
  IntV filled = n << rest;
  for (int m = bits; m < kWide; m *= 2) filled |= filled >> m;
  return filled;
}

#if defined(__F16C__)
/// Halves towards zero, but for numbers that are none.
SOFTGL_INLINE FloatV cut_to_halves(FloatV v) {
  constexpr int kTowardsZero = _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC;
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  return (FloatV)_mm512_cvtph_ps(_mm512_cvtps_ph((__m512)v, kTowardsZero));
#else
  return (FloatV)_mm256_cvtph_ps(_mm256_cvtps_ph((__m256)v, kTowardsZero));
#endif
}
#endif

/// drawn_float() of vectors.
SOFTGL_INLINE FloatV drawn_floats(FloatV v, int bits) {
  if (bits == 32) return v;
#if defined(__F16C__)
  if (bits == 16) {
    const IntV none = ((IntV)v & INT32_MIN) | 0x7fc00000;
    return choose((IntV)(v == v), cut_to_halves(v), (FloatV)none);
  }
#endif
  const int mantissa = bits == 16 ? 10 : bits - 5;
  const int32_t mask = ~int32_t((1u << (23 - mantissa)) - 1), infinity = 0x7f800000;
  const IntV word = (IntV)v, magnitude = word & 0x7fffffff, most = splat(0x47000000 | (0x7fffff & mask));
  const float steps = float(1u << (14 + mantissa));
  const IntV small = (IntV)(to_float(truncate((FloatV)magnitude * steps)) * (1.0f / steps));
  IntV n = choose(magnitude < 0x38800000, small, min_(magnitude & mask, most));
  n = choose(magnitude == infinity, magnitude, n);
  n = bits == 16 ? n | (word & INT32_MIN) : n & ~(word >> 31);
  const IntV none = bits == 16 ? (word & INT32_MIN) | 0x7fc00000 : splat(0x7fc00000);
  return (FloatV)choose(magnitude > infinity, none, n);
}

namespace { // so that no member is visible outside

/// Merges strips on surfaces whose colors are not four bytes as they are, and not of Rgb565.
struct EncodedMerger {
  const Merger& merger;
  const FragmentKey& key = merger.key;
  const FragmentConstants& constants = *merger.program.constants;
  const ColorEncoding& encoding = constants.encoding;
  const Blending blending{merger.program};

  /// Lanes of `block` from `first` on, with the pixels from `pixel` on. `words`: their colors as RGBA8 words.
  SOFTGL_MEMBER void strip(const FragmentBlock& block, int first, const uint32_t* words, const uint32_t* live,
                           void* color, size_t pixel) const {
    switch (ColorFormat(key.color_format)) {
    case ColorFormat::Rgba8: {
      uint32_t* target = static_cast<uint32_t*>(color) + pixel;
      if (encoding.srgb)
        srgb_bytes(block, first, live, target);
      else
        bytes(words, live, target);
      return;
    }
    case ColorFormat::Rgba16: {
      uint32_t* target = static_cast<uint32_t*>(color) + 2 * pixel;
      if (encoding.numbers == ColorNumbers::Unsigned)
        halves<UnsignedArithmetic>(block, first, live, target);
      else if (encoding.bits[0] == 8 || encoding.bits[3] == 8)
        halves<SignedArithmetic<8>>(block, first, live, target);
      else
        halves<SignedArithmetic<16>>(block, first, live, target);
      return;
    }
    case ColorFormat::RgbaFloat: return floats(block, first, live, static_cast<float*>(color) + 4 * pixel);
    case ColorFormat::Rgb565: return;
    }
  }

private:
  SOFTGL_MEMBER bool keeps(int c) const { return key.color_mask >> c & 1; }

  /// Nothing is left of what is there.
  SOFTGL_MEMBER bool replaces_all(const uint32_t* live) const {
    if (key.blend || key.logic_op || key.color_mask != 15) return false;
    IntV all = splat(-1);
    for (int i = 0; i < kStripLanes; i += kWidth) all &= load(live + i);
    return !any(~all);
  }

  /// The blended components that are kept of `strip`, in place of the source.
  template <class A, class T = typename A::T>
  SOFTGL_MEMBER void blend(StripColors<A>& strip, const float* constant) const {
    T out[4][kStripVectors];
    if constexpr (A::kSigned && !A::kFloat)
      if (!blending.has_alpha && blending.few)
        for (T& alpha : strip.source[3]) alpha = max_(alpha, splat(-A::kOne));
    for (int c = 0; c < 4; ++c)
      if (keeps(c)) blend_component<A>(blending, c, strip, constant, out[c]);
    for (int c = 0; c < 4; ++c)
      for (int g = 0; g < kStripVectors; ++g)
        if (keeps(c)) strip.source[c][g] = out[c][g];
  }

  void bytes(const uint32_t* words, const uint32_t* live, uint32_t* target) const {
    // The component that is alone, if so.
    const int only = encoding.bits[3] ? 3 : encoding.bits[0] ? 0 : encoding.bits[1] ? 1 : 2;
    const FactorPair& pair = only == 3 ? blending.alpha : blending.rgb;
    const bool mixed = key.blend && blending.alone && blending.equation[only == 3] == BlendEquation::Add;
    const bool first = mixed && is_inverse(pair.source, pair.destination),
               second = mixed && !first && is_inverse(pair.destination, pair.source);
    for (int i = 0; i < kStripLanes; i += kWidth) {
      const IntV there = load(target + i), source = load(words + i);
      IntV drawn;
      if (first)
        drawn = mix_words(pair.source, there, source, source, there);
      else if (second)
        drawn = mix_words(pair.destination, source, there, source, there);
      else
        drawn = merger.blended(source, there);
      IntV kept = IntV{};
      for (int c = 0; c < 4; ++c)
        if (keeps(c))
          kept |= drawn_numbers<8>((IntV)((UintV)drawn >> (8 * c)) & 255, encoding.bits[c]) << (8 * c);
      store(target + i, choose(load(live + i) & merger.mask, kept, there));
    }
  }

  /// Bytes between those of `from` and `to`: the weight is a factor.
  SOFTGL_MEMBER IntV mix_words(BlendFactor weight, IntV from, IntV to, IntV source, IntV target) const {
    const Halves w = factor_of(weight, split(source), split(target), constants.blend_color_8),
                 a = split(from), b = split(to);
    auto mixed = [](ShortV weight, ShortV low, ShortV high) __attribute__((always_inline)) {
      const ShortV scaled = weight + (weight >> 7); // up to 256
      return ((low << 8) + scaled * (high - low) + 128) >> 8;
    };
    return join({mixed(w.rb, a.rb, b.rb), mixed(w.ga, a.ga, b.ga)});
  }

  /// Bytes of sRGB are blended as linear floats (GL_EXT_framebuffer_sRGB).
  void srgb_bytes(const FragmentBlock& block, int first, const uint32_t* live, uint32_t* target) const {
    StripColors<FloatArithmetic> strip;
    float constant[4];
    alignas(64) float number[kStripLanes];
    for (int c = 0; c < 4; ++c) {
      constant[c] = saturate(constants.blend_color[c]);
      for (int g = 0; g < kStripVectors; ++g) {
        const IntV byte = (IntV)((UintV)load(target + g * kWidth) >> (8 * c)) & 255;
        strip.source[c][g] = unit_range(load(block.color[c] + first + g * kWidth));
        strip.target[c][g] = to_float(byte) * (1.0f / 255.0f);
        store(number + g * kWidth, to_float(byte));
      }
      if (c == 3) break;
      for (float& v : number) v = srgb_to_linear(v);
      for (int g = 0; g < kStripVectors; ++g) strip.target[c][g] = load(number + g * kWidth);
    }
    if (key.blend) blend<FloatArithmetic>(strip, constant);
    IntV drawn[kStripVectors] = {};
    for (int c = 0; c < 4; ++c) {
      for (int g = 0; g < kStripVectors; ++g) store(number + g * kWidth, unit_range(strip.source[c][g]));
      for (float& v : number) v = c == 3 ? v * 255.0f : linear_to_srgb(v);
      for (int g = 0; g < kStripVectors; ++g) drawn[g] |= round_to_int(load(number + g * kWidth)) << (8 * c);
    }
    for (int g = 0; g < kStripVectors; ++g)
      store(target + g * kWidth,
            choose(load(live + g * kWidth) & merger.mask, drawn[g], load(target + g * kWidth)));
  }

  template <class A>
  void halves(const FragmentBlock& block, int first, const uint32_t* live, uint32_t* target) const {
    StripColors<A> strip;
    const bool whole = replaces_all(live);
    for (int g = 0; g < kStripVectors; ++g) {
      IntV low = IntV{}, high = IntV{};
      if (!whole) load_alternating(target + 2 * g * kWidth, low, high);
      const IntV word[2] = {low, high};
      for (int c = 0; c < 4; ++c) {
        strip.source[c][g] = A::stored(load(block.color[c] + first + g * kWidth));
        const IntV upper = c & 1 ? word[c / 2] : word[c / 2] << 16;
        strip.target[c][g] = A::kSigned ? upper >> 16 : (IntV)((UintV)upper >> 16);
      }
    }
    if (key.logic_op) {
      for (int c = 0; c < 4; ++c)
        for (int g = 0; g < kStripVectors; ++g)
          strip.source[c][g] =
              logic_words(unsigned(key.blend_source_rgb), strip.source[c][g], strip.target[c][g]);
      if constexpr (!A::kSigned)
        for (int c = 0; c < 4; ++c)
          for (int g = 0; g < kStripVectors; ++g) strip.source[c][g] &= A::kOne;
    } else if (key.blend) {
      blend<A>(strip, constants.blend_color);
    }
    for (int c = 0; c < 4; ++c)
      for (int g = 0; g < kStripVectors; ++g) {
        IntV& v = strip.source[c][g];
        if (!keeps(c))
          v = strip.target[c][g];
        else if constexpr (!A::kSigned)
          v = drawn_numbers<16>(v, encoding.bits[c]);
      }
    for (int g = 0; g < kStripVectors; ++g) {
      const IntV lives = load(live + g * kWidth);
      auto pair = [&](int c) __attribute__((always_inline)) {
        const IntV low = choose(lives, strip.source[c][g], strip.target[c][g]),
                   high = choose(lives, strip.source[c + 1][g], strip.target[c + 1][g]);
        return (low & 0xffff) | (high << 16);
      };
      store_alternating(target + 2 * g * kWidth, pair(0), pair(2));
    }
  }

  /// Logic operations leave floats alone.
  void floats(const FragmentBlock& block, int first, const uint32_t* live, float* target) const {
    StripColors<FloatArithmetic> strip;
    const bool whole = replaces_all(live);
    for (int g = 0; g < kStripVectors; ++g) {
      FloatV there[4] = {};
      if (!whole) load_pixels(target + 4 * g * kWidth, there);
      for (int c = 0; c < 4; ++c) {
        strip.source[c][g] = load(block.color[c] + first + g * kWidth);
        strip.target[c][g] = there[c];
      }
    }
    if (key.blend) blend<FloatArithmetic>(strip, constants.blend_color);
    for (int g = 0; g < kStripVectors; ++g) {
      const IntV lives = load(live + g * kWidth);
      FloatV out[4];
      for (int c = 0; c < 4; ++c) {
        out[c] = strip.target[c][g];
        if (keeps(c)) out[c] = choose(lives, drawn_floats(strip.source[c][g], encoding.bits[c]), out[c]);
      }
      store_pixels(target + 4 * g * kWidth, out);
    }
  }
};

} // namespace

} // namespace SOFTGL_ISA
} // namespace softgl
