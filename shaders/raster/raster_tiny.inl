// Batches of tiny triangles: finished fragments, before there are tiles.
#pragma once

#include "shaders/raster/raster_classify.inl"
#include "shaders/raster/raster_small.inl"

namespace softgl {
namespace SOFTGL_ISA {

namespace { // so that no member is visible outside

/// Cuts tiny triangles at the borders of tiles and shades their fragments.
class TinyBatch {
public:
  TinyBatch(const RasterDraw& draw, const TriangleInput& in, TriangleOutput& out)
      : draw_(draw), in_(in), out_(out) {}

  void run(FragmentBlock& block) {
    const bool grouped =
        in_.shares_planes && kWidth > 4 && covered() * 4 >= 5 * __builtin_popcountll(out_.small);
    out_.shared_planes = grouped;
    if (draw_.program->step_count)
      grouped ? shade<true, true>(block) : shade<true, false>(block);
    else
      grouped ? shade<false, true>(block) : shade<false, false>(block);
    out_.run[out_.run_count].first = end_;
  }

private:
  SOFTGL_MEMBER uint64_t pixels_of(int t) const {
    return uint64_t(out_.rows4to7[t]) << 32 | out_.rows0to3[t];
  }

  int covered() const {
    int n = 0;
    for (uint64_t bits = out_.small; bits; bits &= bits - 1)
      n += __builtin_popcountll(pixels_of(__builtin_ctzll(bits)));
    return n;
  }

  /// Begins a run unless the last one goes on.
  SOFTGL_MEMBER void begin_run(uint32_t tile, int t) {
    const uint64_t large_before = out_.large & ((uint64_t(1) << t) - 1);
    if (out_.run_count && tile == last_tile_ && large_before == last_large_) return;
    out_.run[out_.run_count++] = {tile, end_, uint8_t(t)};
    last_tile_ = tile, last_large_ = large_before;
  }

  /// Calls visit(pixels) for the pixels of triangle t in each tile, with their run begun.
  template <class Visit> SOFTGL_MEMBER void each_tile(int t, Visit&& visit) {
    const uint64_t pixels = pixels_of(t);
    const uint32_t tile = out_.tile[t];
    if (!out_.further[t]) {
      begin_run(tile, t);
      return visit(pixels);
    }
    const uint32_t x = out_.position[t] & 63, y = out_.position[t] >> 16 & 63;
    uint64_t left = ~uint64_t(0), upper = left;
    if (x > 64 - kTinyBox) left = (0xffu >> (x - 56)) * 0x0101010101010101u;
    if (y > 64 - kTinyBox) upper >>= 8 * (y - 56);
    const uint64_t part[4] = {pixels & left & upper, pixels & ~left & upper, pixels & left & ~upper,
                              pixels & ~left & ~upper};
    const uint32_t next_row = tile + uint32_t(in_.tiles_x),
                   number[4] = {tile, tile + 1, next_row, next_row + 1};
#pragma GCC unroll 1
    for (int k = 0; k < 4; ++k) {
      if (!part[k]) continue;
      begin_run(number[k], t);
      visit(part[k]);
    }
  }

  /// Grouped: planes are made for kWidth triangles at a time, and lanes choose from them: 3 to 5 % of
  /// immediate mode's time with three pixels a triangle. Where there are hardly more fragments than triangles
  /// they are made for each lane.
  template <bool Staged, bool Grouped> void shade(FragmentBlock& block) {
    constexpr int kMost = kMaxTinyFragments + kWidth;
    alignas(64) uint32_t place[kMost]; // y in the upper half
    uint8_t owner[kMost];              // the triangle's number, or its place in its group
    uint8_t number[kSetupBatch + kWidth];
    int32_t first[kSetupBatch + kWidth]; // fragments of the small triangles in order
    int count = 0;
    for (uint64_t bits = out_.small; bits; bits &= bits - 1) {
      const int t = __builtin_ctzll(bits);
      const uint32_t position = out_.position[t];
      const auto mine = uint8_t(Grouped ? count & (kWidth - 1) : t);
      if (Grouped) number[count] = uint8_t(t), first[count++] = end_;
      each_tile(
          t, [&](uint64_t pixels) __attribute__((always_inline)) {
            auto put = [&](int32_t at, uint32_t bit) {
              place[at] = position + ((bit & 56) << 13) + (bit & 7), owner[at] = mine;
            };
            // Most have one pixel or two, which is hard to predict: two are always written.
            for (;;) {
              const uint64_t others = pixels & (pixels - 1);
              put(end_, uint32_t(__builtin_ctzll(pixels)));
              put(end_ + 1, uint32_t(__builtin_ctzll(others | uint64_t(1) << 63)));
              end_ += 1 + (others != 0);
              pixels = others & (others - 1);
              if (!pixels) break;
            }
          });
    }
    if (end_ == 0) return;
    for (int k = 0; k < kWidth; ++k) place[end_ + k] = place[0], owner[end_ + k] = owner[0];
    SmallShader<Staged> shader(draw_, block);
    const FragmentWords words(draw_, out_.pixel, out_.depth, out_.color, out_.live);
    auto vector = [&](int32_t f, auto&& planes) __attribute__((always_inline)) {
      const IntV p = load(place + f), x = p & 0xffff, y = p >> 16;
      store_halves(words.pixel + f, ((y & 56) << 6) | ((x & 56) << 3) | ((y & 7) << 3) | (x & 7));
      shader.shade(words, planes, f, x, y);
    };
    const int32_t end = end_;
    if constexpr (Grouped) {
      for (int k = 0; k < kWidth; ++k) number[count + k] = number[0], first[count + k] = end;
      for (int group = 0; group < count; group += kWidth) {
        SmallTriangle triangle[kWidth];
        find_corners(draw_, in_, out_, number + group, triangle);
        CornerPlanes made(triangle);
        StoredPlanes planes;
        store_planes(draw_, made, planes);
        for (int32_t f = first[group]; f < first[group + kWidth]; f += kWidth)
          vector(f, ChosenPlanes{planes, load_bytes(owner + f)});
      }
    } else {
      for (int32_t f = 0; f < end; f += kWidth) {
        SmallTriangle triangle[kWidth];
        find_corners(draw_, in_, out_, owner + f, triangle);
        vector(f, CornerPlanes(triangle));
      }
    }
    shader.finish(words, end);
  }

  const RasterDraw& draw_;
  const TriangleInput& in_;
  TriangleOutput& out_;
  int32_t end_ = 0;         // of fragments
  uint32_t last_tile_ = 0;  // of the last run
  uint64_t last_large_ = 0; // large triangles in front of it
};

} // namespace

/// Sorts out the triangles of a batch, and shades them if they are tiny.
static void prepare_triangles(const RasterDraw& draw, const TriangleInput& in, TriangleOutput& out,
                              FragmentBlock& scratch) {
  SnappedBatch batch;
  classify_triangles(draw, in, batch, out);
  out.run_count = 0;
  if (draw.small ? !out.tiny : !out.small) return;
  cover_tiny(draw, batch, in.count, out);
  if (draw.small) return TinyBatch(draw, in, out).run(scratch);
  out.large |= out.small, out.small = 0, out.tiny = false;
}

} // namespace SOFTGL_ISA
} // namespace softgl
