// Tests of depths, and of stencil values that stay, before the stages of a program run.
#pragma once

#include "shaders/raster/raster_block.inl"

namespace softgl {
namespace SOFTGL_ISA {

namespace { // so that no member is visible outside

/// Tests kWidth fragments side by side, if a draw's tests are early. To be kept in a local variable.
struct EarlyTests {
  const WordComparison nearer;
  const float scale;
  const bool floats, early, stencil;
  const Compare stencil_function;
  const int32_t reference, value_mask;
  const IntV written; // bits of a word that nothing tests again

  SOFTGL_MEMBER explicit EarlyTests(const RasterDraw& draw)
      : nearer(Compare(draw.program->key.depth_function)), scale(depth_scale(draw.program->key)),
        floats(DepthFormat(draw.program->key.depth_format) == DepthFormat::Z32F), early(draw.early_depth),
        stencil(draw.program->key.stencil), stencil_function(Compare(draw.program->key.stencil_function)),
        reference(int32_t(draw.program->constants->stencil_reference &
                          draw.program->constants->stencil_value_mask)),
        value_mask(int32_t(draw.program->constants->stencil_value_mask)),
        written(splat(draw.final_depth && draw.program->key.depth_write ? 0xffffff : 0)) {}

  /// Which of the fragments `live` pass; their depths are `z`, and go to `depth`. `stored`: their words.
  /// `changed` gets bits if a depth that passes may be written later, and is not the stored one.
  SOFTGL_MEMBER IntV test(IntV live, FloatV z, uint32_t* stored, uint32_t* depth, IntV& changed) const {
    if (!early) {
      store(depth, floats ? depth_float(z) : depth_bits(z, scale));
      changed = splat(-1);
      return live;
    }
    const IntV word = depth_bits(z, scale), there = load(stored), old = there & 0xffffff;
    store(depth, word);
    IntV passes = nearer(word, old) & live;
    if (stencil)
      passes &= compare_words(stencil_function, splat(reference), (IntV)((UintV)there >> 24) & value_mask);
    store(stored, choose(passes & written, word, there));
    changed |= passes & (word ^ old);
    return passes;
  }
};

} // namespace

/// Which of the pixels `covered` of a block pass the tests, and the depths of vectors that have one of them.
/// `x` and `y`: where the first pixel has its depth; `stored`, `changes`: as of EarlyTests::test().
SOFTGL_INLINE uint64_t test_block(const RasterDraw& draw, const RasterPrimitive& p, float x, float y,
                                  uint64_t covered, uint32_t* stored, uint32_t* depth, bool& changes) {
  constexpr uint64_t kAll = (uint64_t(1) << (kWidth - 1) << 1) - 1;
  const EarlyTests tests(draw);
  const BlockPlane plane = block_plane(p.plane[kPlaneZ], x);
  const FloatV offset = splat(p.depth_offset);
  uint64_t live = 0;
  IntV changed = IntV{};
  for (int i = 0; i < 64; i += kWidth) {
    if (!(covered >> i & kAll)) continue;
    const FloatV z =
        plane.gy * row_coordinates(y, i >> 3) + plane.column[kWidth < 8 ? i / kWidth & 1 : 0] + offset;
    const IntV passes = tests.test(mask_of_bits(uint32_t(covered >> i)), z, stored + i, depth + i, changed);
    live |= uint64_t(sign_bits(passes)) << i;
  }
  changes = changes || any(changed);
  return live;
}

} // namespace SOFTGL_ISA
} // namespace softgl
