// Small triangles: finished fragments.
#pragma once

#include "fragment_interpolate.inl"
#include "raster_classify.inl"
#include "raster_coverage.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// The planes of one of kWidth triangles, in all lanes.
struct TrianglePlanes {
  const StoredPlanes& stored;
  int triangle;

  SOFTGL_MEMBER PlaneV at(int index) const {
    const auto& p = stored.plane[index];
    return {splat(p[0][triangle]), splat(p[1][triangle]), splat(p[2][triangle])};
  }
  SOFTGL_MEMBER PlaneV z() const { return at(kPlaneZ); }
  SOFTGL_MEMBER PlaneV w() const { return at(kPlaneW); }
  SOFTGL_MEMBER FloatV offset(const RasterConstants&) const { return splat(stored.offset[triangle]); }
  SOFTGL_MEMBER IntV back() const { return splat(stored.back[triangle]); }
  SOFTGL_MEMBER void select(const Varying&) {}
  SOFTGL_MEMBER PlaneV plane(const Varying& v, int component) const { return at(v.plane + component); }
};

/// Where the set bits of a byte are, in order, and how many there are.
struct BitPlaces {
  uint8_t place[256][8], count[256];
};
static constexpr BitPlaces make_bit_places() {
  BitPlaces t{};
  for (int byte = 0; byte < 256; ++byte)
    for (int bit = 0; bit < 8; ++bit)
      if (byte >> bit & 1) t.place[byte][t.count[byte]++] = uint8_t(bit);
  return t;
}
static constexpr BitPlaces kBitPlaces = make_bit_places();

/// Where the set bits of an 8x8 block are to `place`, which has room for 8 more: `first` + 16 * row + column. Gives how many
/// there are. All rows are looked at: how many a triangle has is hard to predict.
SOFTGL_INLINE int places_of(uint64_t mask, uint32_t first, uint8_t* place) {
  int n = 0;
  const uint64_t firsts = first * 0x0101010101010101u;
#pragma GCC unroll 8
  for (uint64_t row = 0; row < 8; ++row) {
    const uint64_t byte = mask >> (8 * row) & 255;
    uint64_t columns;
    memcpy(&columns, kBitPlaces.place[byte], 8);
    columns += firsts + row * 0x1010101010101010u;
    memcpy(place + n, &columns, 8);
    n += kBitPlaces.count[byte];
  }
  return n;
}

namespace { // so that no member is visible outside

/// Shades the small triangles of a batch into finished fragments; Staged: with stages of the program.
template <bool Staged> class SmallShader {
public:
  SmallShader(const RasterDraw& draw, const TriangleInput& in, TriangleOutput& out, FragmentBlock& block)
      : draw_(draw), in_(in), out_(out), block_(block), program_(*draw.program), scale_(depth_scale(draw.program->key)) {}

  void run() {
    if (out_.cut || covered() >= kDenseBelow * __builtin_popcountll(out_.small)) by_triangle();
    else by_fragment();
    if (Staged) finish_block(end_);
    out_.run[out_.run_count].first = end_;
  }

private:
  // With fewer fragments a triangle all lanes are filled with fragments of several and the planes made for each; with
  // more the planes are made once.
  static constexpr int kDenseBelow = 3;

  SOFTGL_MEMBER uint64_t pixels_of(int t) const { return uint64_t(out_.rows4to7[t]) << 32 | out_.rows0to3[t]; }

  int covered() const {
    int n = 0;
    for (uint64_t bits = out_.small; bits; bits &= bits - 1) n += __builtin_popcountll(pixels_of(__builtin_ctzll(bits)));
    return n;
  }

  /// Begins a run unless the last one goes on.
  SOFTGL_MEMBER void begin_run(uint32_t tile, int t) {
    const uint64_t large_before = out_.large & ((uint64_t(1) << t) - 1);
    if (out_.run_count && tile == last_tile_ && large_before == last_large_) return;
    out_.run[out_.run_count++] = {tile, end_, uint8_t(t)};
    last_tile_ = tile, last_large_ = large_before;
  }

  /// Calls visit(pixels) for the pixels of a box of triangle t in each tile, with their run begun.
  template <class Visit> SOFTGL_MEMBER void each_tile(int t, uint32_t position, uint32_t tile, uint64_t pixels, Visit&& visit) {
    const uint32_t x = position & 63, y = position >> 16 & 63;
    uint64_t left = ~uint64_t(0), upper = left;
    if (x > 64 - kBlockBox) left = (0xffu >> (x - 56)) * 0x0101010101010101u;
    if (y > 64 - kBlockBox) upper >>= 8 * (y - 56);
    if (!(pixels & ~(left & upper))) {
      begin_run(tile, t);
      return visit(pixels);
    }
    const uint64_t part[4] = {pixels & left & upper, pixels & ~left & upper, pixels & left & ~upper, pixels & ~left & ~upper};
    const uint32_t next_row = tile + uint32_t(in_.tiles_x), number[4] = {tile, tile + 1, next_row, next_row + 1};
#pragma GCC unroll 1
    for (int k = 0; k < 4; ++k) {
      if (!part[k]) continue;
      begin_run(number[k], t);
      visit(part[k]);
    }
  }

  /// Fragments of one triangle in all lanes.
  void by_triangle() {
    const Target target = this->target();
    for (uint64_t left = out_.small; left;) {
      uint8_t triangle[kWidth];
      int lanes = 0;
      for (; left && lanes < kWidth; left &= left - 1) triangle[lanes++] = uint8_t(__builtin_ctzll(left));
      for (int i = lanes; i < kWidth; ++i) triangle[i] = triangle[0];
      CornerPlaces corners;
      find_corners(draw_, in_, out_, triangle, corners);
      StoredPlanes stored;
      store_planes(draw_, corners, stored);
      for (int i = 0; i < lanes; ++i) {
        TrianglePlanes planes{stored, i};
        const int t = triangle[i];
        // Fragments of all its blocks and tiles share vectors.
        uint8_t place[kSmallBox * kSmallBox + 64];
        const int32_t first = end_;
        if (out_.cut >> t & 1) list_cut_box(t, place);
        else list_block(t, out_.position[t], out_.tile[t], 0, pixels_of(t), place);
        const IntV x = splat(int32_t(out_.position[t] & 0xffff)), y = splat(int32_t(out_.position[t] >> 16));
        const int32_t end = end_;
        for (int32_t f = first; f < end; f += kWidth) {
          const IntV p = load_bytes(place + (f - first));
          shade(target, planes, f, x + (p & 15), y + (p >> 4));
        }
      }
    }
  }

  /// Lists fragments of a block: `from` is its first place.
  SOFTGL_MEMBER uint8_t* list_block(int t, uint32_t position, uint32_t tile, uint32_t from, uint64_t pixels, uint8_t* place) {
    each_tile(t, position, tile, pixels, [&](uint64_t part) __attribute__((always_inline)) {
      const int n = places_of(part, from, place);
      place += n;
      end_ += n;
    });
    return place;
  }

  /// A box of more than 8 by 8 pixels, block by block.
  void list_cut_box(int t, uint8_t* place) {
    TileEdges edges;
    edges.x0 = edges.y0 = 0, edges.x1 = out_.last_column[t] + 1, edges.y1 = out_.last_row[t] + 1;
    edges.inside = false;
    for (int k = 0; k < 3; ++k) set_edge(edges, k, out_.edge_c[k][t], out_.edge_a[k][t], out_.edge_b[k][t]);
    EdgeSteps<3> steps;
    edge_steps<3>(edges, steps);
    for (int y = 0; y < edges.y1; y += kBlockBox)
      for (int x = 0; x < edges.x1; x += kBlockBox) {
        const uint64_t pixels = block_coverage<3>(edges, steps, x, y);
        if (!pixels) continue;
        const uint32_t position = out_.position[t] + uint32_t(x + (y << 16));
        place = list_block(t, position, (position >> 22) * uint32_t(in_.tiles_x) + (position >> 6 & 1023), uint32_t(x + 16 * y), pixels, place);
      }
  }

  /// Fragments as they come, each lane of a triangle of its own.
  void by_fragment() {
    const Target target = this->target();
    constexpr int kMost = kDenseBelow * kSetupBatch + kWidth;
    alignas(64) uint32_t place[kMost]; // y in the upper half
    uint8_t triangle[kMost];
    for (uint64_t bits = out_.small; bits; bits &= bits - 1) {
      const int t = __builtin_ctzll(bits);
      const uint32_t position = out_.position[t];
      each_tile(t, position, out_.tile[t], pixels_of(t), [&](uint64_t pixels) __attribute__((always_inline)) {
        auto put = [&](int32_t at, uint32_t bit) { place[at] = position + ((bit & 56) << 13) + (bit & 7), triangle[at] = uint8_t(t); };
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
    for (int k = 0; k < kWidth; ++k) place[end_ + k] = place[0], triangle[end_ + k] = triangle[0];
    for (int32_t f = 0; f < end_; f += kWidth) {
      CornerPlaces corners;
      find_corners(draw_, in_, out_, triangle + f, corners);
      CornerPlanes planes(corners);
      const IntV p = load(place + f);
      shade(target, planes, f, p & 0xffff, p >> 16);
    }
  }

  /// What every vector of fragments needs, to be kept in a local variable: of members GCC believes that each store may
  /// change them (20 of 106 instructions).
  struct Target {
    uint16_t* pixel;
    uint32_t *depth, *color;
    float scale;
    Varying varying; // without stages: the colour
    bool opaque;
  };
  SOFTGL_MEMBER Target target() const { return {out_.pixel, out_.depth, out_.color, scale_, draw_.varying[0], draw_.opaque}; }

  /// Fragments [f, f + kWidth) at px, py.
  template <class Planes> SOFTGL_MEMBER void shade(const Target& target, Planes& planes, int32_t f, IntV px, IntV py) {
    const FloatV x = to_float(px), y = to_float(py);
    store_halves(target.pixel + f, ((py & 56) << 6) | ((px & 56) << 3) | ((py & 7) << 3) | (px & 7));
    const IntV depth = depth_bits(value_at(planes.z(), x, y) + planes.offset(*draw_.raster), target.scale);
    store(target.depth + f, depth);
    const PlaneV w = planes.w();
    const FloatV rw = splat(1.0f) / value_at(w, x, y);
    auto value = [&](const Varying& v, int k) __attribute__((always_inline)) {
      const PlaneV p = planes.plane(v, k);
      return v.flat ? p.a : value_at(p, x, y) * rw;
    };
    if constexpr (!Staged) {
      Varying color = target.varying;
      color.first = 0; // says to the compiler what it is
      planes.select(color);
      store(target.color + f, pack_color(value(color, 0), value(color, 1), value(color, 2), target.opaque ? splat(1.0f) : value(color, 3)));
      return;
    }
    if (f + kWidth > block_first_ + kLanes) finish_block(f);
    const int lane = f - block_first_;
    for (int i = 0; i < draw_.varying_count; ++i) {
      const Varying& v = draw_.varying[i];
      planes.select(v);
      for (int k = 0; k < v.components; ++k) store(lanes_of(block_, v, k) + lane, value(v, k));
    }
    if (draw_.facing) store(block_.back + lane, planes.back());
    for (int u = 0; u < kBlockTextureUnits; ++u) {
      if (draw_.unit_plane[u] < 0) continue;
      const Varying v = coordinates_of_unit(draw_, u);
      planes.select(v);
      const PlaneV q[4] = {planes.plane(v, 0), planes.plane(v, 1), planes.plane(v, 2), planes.plane(v, 3)};
      interpolate_unit(block_.unit[u], lane, coordinates_read(program_, u), plane_of_w(draw_, u, w), q, px, py);
    }
    store(block_.x + lane, px), store(block_.y + lane, py);
    store(block_.depth + lane, depth);
  }

  /// Sends fragments [block_first_, end) through the program.
  void finish_block(int32_t end) {
    const int lanes = end - block_first_;
    if (lanes == 0) return;
    block_.lanes = (lanes + kStripLanes - 1) & ~(kStripLanes - 1);
    for (int j = 0; j < kLanes; ++j) block_.live[j] = j < lanes ? ~uint32_t(0) : 0;
    // Lanes past the last fragment hold values of an earlier block or copies: finite, as far as those are.
    for (int i = 0; i < program_.step_count; ++i) program_.step[i].stage(block_, *program_.constants, program_.step[i].unit);
    for (int j = 0; j < lanes; j += kWidth) {
      store(out_.color + block_first_ + j, pack_color(load(block_.color[0] + j), load(block_.color[1] + j), load(block_.color[2] + j), load(block_.color[3] + j)));
      store(out_.live + block_first_ + j, load(block_.live + j));
    }
    block_first_ = end;
  }

  const RasterDraw& draw_;
  const TriangleInput& in_;
  TriangleOutput& out_;
  FragmentBlock& block_;
  const FragmentProgram& program_;
  const float scale_;
  int32_t end_ = 0, block_first_ = 0; // of fragments
  uint32_t last_tile_ = 0;            // of the last run
  uint64_t last_large_ = 0;           // large triangles in front of it
};

} // namespace

} // namespace SOFTGL_ISA
} // namespace softgl
