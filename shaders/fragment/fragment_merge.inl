// The end of a fragment: stencil, depth, blending, logic operation, masks. Works on vectors of fragments, no
// two of the same pixel, whose destination pixels lie side by side: in the tile, or gathered from it.
#pragma once

#include "shaders/fragment/fragment_blend.inl"
#include "shaders/fragment/fragment_stages.inl"

namespace softgl {
namespace SOFTGL_ISA {

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

namespace { // so that no member is visible outside

/// The same for many words: without a switch, of which a processor predicts the target badly.
struct WordComparison {
  bool equality, unequal;
  IntV lead, opposite;

  explicit WordComparison(Compare f)
      : equality(f == Compare::Equal || f == Compare::NotEqual), unequal(f == Compare::NotEqual) {
    // Words are at most 0x3f800000: value - lead is less than each of them.
    const bool any = f == Compare::Always || f == Compare::Never;
    const bool equal = f == Compare::LessEqual || f == Compare::Greater;
    lead = splat(any ? 0x40000000 : equal ? 1 : 0);
    opposite = splat(f == Compare::Never || f == Compare::Greater || f == Compare::GreaterEqual ? -1 : 0);
  }
  SOFTGL_MEMBER IntV operator()(IntV value, IntV other) const {
    if (equality) return unequal ? value != other : value == other;
    return ((value - lead) < other) ^ opposite;
  }
};

} // namespace

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
  const int stencil_step = kTilePixels; // words from depths that are floats to their stencil values
  const FragmentKey& key = program.key;
  const bool tests = Compare(key.depth_function) != Compare::Always || key.depth_write || key.stencil ||
                     program.bounds_depth;
  const bool over = is_over(key), sum = is_sum(key),
             floats = DepthFormat(key.depth_format) == DepthFormat::Z32F;
  const IntV mask = splat(int32_t(word_mask(key)));
  const WordComparison nearer{Compare(key.depth_function)};

  /// Stencil and depth test with their writes to `place`; gives the lanes that live on.
  SOFTGL_MEMBER IntV depth_stencil(IntV live, IntV z, uint32_t* place) const {
    if (!tests) return live;
    if (program.writes_stencil) return store_stencils(live, z, place);
    return floats ? float_depth_stencil(live, z, place) : word_depth_stencil(live, z, place);
  }

  /// Of words with a depth and a stencil value each.
  SOFTGL_MEMBER IntV word_depth_stencil(IntV live, IntV z, uint32_t* place) const {
    IntV words = load(place);
    live = word_depth_stencil(live, z, words);
    store(place, words);
    return live;
  }
  SOFTGL_MEMBER IntV word_depth_stencil(IntV live, IntV z, IntV& words) const {
    const IntV depth = words & 0xffffff;
    if (program.bounds_depth) live &= in_bounds(depth);
    if (key.stencil) {
      IntV s = (IntV)((UintV)words >> 24);
      live = test_both(live, nearer(z, depth), s);
      words = depth | (s << 24);
    } else {
      live &= nearer(z, depth);
    }
    if (key.depth_write) words = choose(live & 0xffffff, z, words);
    return live;
  }

  SOFTGL_MEMBER IntV store_stencils(IntV live, IntV stencil, uint32_t* place) const {
    const int32_t mask = program.constants->stencil_write_mask;
    if (floats)
      store(place + stencil_step, choose(live & mask, stencil, load(place + stencil_step)));
    else
      store(place, choose(live & (mask << 24), stencil << 24, load(place)));
    return live;
  }

  SOFTGL_MEMBER IntV in_bounds(IntV stored) const {
    const FragmentConstants& k = *program.constants;
    return (stored >= splat(int32_t(k.least_bound))) & (stored <= splat(int32_t(k.greatest_bound)));
  }

  /// Both tests, of stencil values `s`, which change; `near`: the depth test passes.
  SOFTGL_MEMBER IntV test_both(IntV live, IntV near, IntV& s) const {
    const FragmentConstants& k = *program.constants;
    const IntV passes = live & compare_words(Compare(key.stencil_function),
                                             splat(int32_t(k.stencil_reference & k.stencil_value_mask)),
                                             s & int32_t(k.stencil_value_mask));
    s = stencil_result(StencilOperation(key.stencil_fail), k, live & ~passes, s);
    live = passes & near;
    s = stencil_result(StencilOperation(key.stencil_depth_fail), k, passes & ~live, s);
    s = stencil_result(StencilOperation(key.stencil_pass), k, live, s);
    return live;
  }

  /// Of a plane of floats; its stencil values lie behind them.
  SOFTGL_MEMBER IntV float_depth_stencil(IntV live, IntV z, uint32_t* place) const {
    const IntV stored = load(place), passes = nearer(z, stored);
    if (program.bounds_depth) live &= in_bounds(stored);
    if (key.stencil) {
      IntV s = load(place + stencil_step);
      live = test_both(live, passes, s);
      store(place + stencil_step, s);
    } else {
      live &= passes;
    }
    if (key.depth_write) store(place, choose(live, z, stored));
    return live;
  }

  /// RGBA8 words after blending and logic operation.
  SOFTGL_MEMBER IntV blended(IntV source, IntV target) const {
    if (over) return blend_over(source, target);
    if (sum) return add_bytes(source, target);
    if (key.logic_op) return logic_words(unsigned(key.blend_source_rgb), source, target);
    if (key.blend) return blend_words(key, *program.constants, source, target);
    return source;
  }
  /// RGBA8 words to `place`.
  SOFTGL_MEMBER void color(IntV live, IntV source, uint32_t* place) const {
    const IntV target = load(place);
    store(place, choose(live & mask, blended(source, target), target));
  }
};

} // namespace

/// 5-6-5 to RGBA8 and back: bits are repeated one way and cut the other (OSMesa 22.3.6). Alpha reads as 1.
/// `T`: uint32_t, or vectors of numbers that are not negative.
template <class T> SOFTGL_INLINE T expand_565(T v) {
  const T r = v >> 11 & 31, g = v >> 5 & 63, b = v & 31;
  return (r << 3 | r >> 2) | (g << 2 | g >> 4) << 8 | (b << 3 | b >> 2) << 16 | T(int32_t(0xff000000) - T{});
}
template <class T> SOFTGL_INLINE T cut_565(T c) {
  return (c & 0xf8) << 8 | (c >> 5 & 0x7e0) | (c >> 19 & 0x1f);
}

} // namespace SOFTGL_ISA
} // namespace softgl
