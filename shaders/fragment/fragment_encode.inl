// Strips of pixels whose colors are not four bytes as they are (ColorEncoding): blending, logic operation and
// masks.
#pragma once

#include "shaders/common/srgb.h"
#include "shaders/fragment/fragment_factors.inl"

namespace softgl {
namespace SOFTGL_ISA {

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
