// Fragments of small triangles, shaded side by side whatever triangles they belong to.
#pragma once

#include "shaders/raster/raster_interpolate.inl"
#include "shaders/raster/raster_planes.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// The planes of kWidth triangles; each lane's are those of triangle number `triangle`.
struct ChosenPlanes {
  const StoredPlanes& stored;
  IntV triangle;

  SOFTGL_MEMBER PlaneV at(int index) const {
    const auto& p = stored.plane[index];
    return {permute(load(p[0]), triangle), permute(load(p[1]), triangle), permute(load(p[2]), triangle)};
  }
  SOFTGL_MEMBER PlaneV z() const { return at(kPlaneZ); }
  SOFTGL_MEMBER PlaneV w() const { return at(kPlaneW); }
  SOFTGL_MEMBER FloatV offset(const RasterConstants& r) const {
    return r.offset ? permute(load(stored.offset), triangle) : FloatV{};
  }
  SOFTGL_MEMBER IntV back() const { return (IntV)permute((FloatV)load(stored.back), triangle); }
  SOFTGL_MEMBER void select(const Varying&) {}
  SOFTGL_MEMBER PlaneV plane(const Varying& v, int component) const { return at(v.plane + component); }
};

/// The planes of one of them, in all lanes: where no instruction permutes lanes.
struct OnePlanes {
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

/// The planes of one triangle, the same for all lanes.
struct PlanesOfOne {
  const StoredPlanes& stored;
  int triangle;

  SOFTGL_MEMBER PlaneV read(int index) const {
    const auto& p = stored.plane[index];
    return {splat(p[0][triangle]), splat(p[1][triangle]), splat(p[2][triangle])};
  }
  SOFTGL_MEMBER PlaneV at(const PlaneV& plane, int) const { return plane; }
  SOFTGL_MEMBER FloatV offset(int) const { return splat(stored.offset[triangle]); }
  SOFTGL_MEMBER IntV back(int) const { return splat(stored.back[triangle]); }
};

/// Each lane's are those of its own triangle; what is read are the planes of all of them.
struct PlanesOfEach {
  const StoredPlanes& stored;
  const int32_t* triangle; // of each lane

  SOFTGL_MEMBER PlaneV read(int index) const {
    const auto& p = stored.plane[index];
    return {load(p[0]), load(p[1]), load(p[2])};
  }
  SOFTGL_MEMBER FloatV choose_from(FloatV v, int lane) const { return permute(v, load(triangle + lane)); }
  SOFTGL_MEMBER PlaneV at(const PlaneV& plane, int lane) const {
    return {choose_from(plane.a, lane), choose_from(plane.gx, lane), choose_from(plane.gy, lane)};
  }
  SOFTGL_MEMBER FloatV offset(int lane) const { return choose_from(load(stored.offset), lane); }
  SOFTGL_MEMBER IntV back(int lane) const { return (IntV)choose_from((FloatV)load(stored.back), lane); }
};

/// Fills the inputs of lanes [first, end), which are of small triangles, and `depth`; block.x and block.y are
/// set. Vector by vector, each asking which inputs there are, triangles of 16 to 32 pixels took 1.4 to 1.6
/// times as long. `FromCorner`: planes count from the corner of the first pixel, not from its center.
template <bool FromCorner = false, class Planes>
static void interpolate_triangles(const RasterDraw& draw, const Planes& planes, int first, int end,
                                  FragmentBlock& block, uint32_t* depth) {
  const float scale = depth_scale(draw.program->key);
  LanePlaces lanes;
  const PlaneV z_plane = planes.read(kPlaneZ), w_plane = planes.read(kPlaneW);
  for (int i = first; i < end; i += kWidth) {
    FloatV x = to_float(load(block.x + i)), y = to_float(load(block.y + i));
    if constexpr (FromCorner) x += 0.5f, y += 0.5f;
    store(lanes.x + i, x), store(lanes.y + i, y);
    const IntV z = depth_bits(value_at(planes.at(z_plane, i), x, y) + planes.offset(i), scale);
    store(block.depth + i, z), store(depth + i, z);
    store(lanes.w + i, splat(1.0f) / value_at(planes.at(w_plane, i), x, y));
  }
  interpolate_varyings(draw, planes, first, end, lanes, block);
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    if (draw.unit_plane[u] < 0) continue;
    const CoordinatesRead read = coordinates_read(*draw.program, u);
    if (read.differences == Differences::None) {
      interpolate_coordinates(draw, planes, u, read, first, end, lanes, block.unit[u]);
      continue;
    }
    for (int i = first; i < end; i += kWidth) {
      PlaneV q[4];
      for (int k = 0; k < 4; ++k)
        if (k < read.count || k == 3) q[k] = planes.at(planes.read(draw.unit_plane[u] + k), i);
      interpolate_unit<FromCorner>(block.unit[u], i, read, plane_of_w(draw, u, planes.at(w_plane, i)), q,
                                   load(block.x + i), load(block.y + i));
    }
  }
}

/// The most lanes at a time of interpolate_numbered(): vectors may reach behind the last one of a triangle.
constexpr int kNumberedLanes = kWidth > 4 ? kLanes : kLanes - kWidth + 1;

/// The same of lanes [0, end); lane i is of triangle number_of[i], and the numbers never fall.
template <bool FromCorner = false>
SOFTGL_INLINE void interpolate_numbered(const RasterDraw& draw, const StoredPlanes& stored,
                                        const int32_t* number_of, int end, FragmentBlock& block,
                                        uint32_t* depth) {
  const auto one = [&](int first, int last) __attribute__((always_inline)) {
    interpolate_triangles<FromCorner>(draw, PlanesOfOne{stored, number_of[first]}, first, last, block, depth);
  };
  if (number_of[0] == number_of[end - 1]) return one(0, end);
  if constexpr (kWidth > 4) {
    interpolate_triangles<FromCorner>(draw, PlanesOfEach{stored, number_of}, 0, end, block, depth);
  } else {
    for (int first = 0, last = 0; first < end; first = last) {
      while (last < end && number_of[last] == number_of[first]) ++last;
      one(first, last);
    }
  }
}

namespace { // so that no member is visible outside

/// Where shaded fragments go. To be kept in a local variable: of members GCC believes that each store may
/// change them (20 of 106 instructions).
struct FragmentWords {
  uint16_t* pixel;
  uint32_t *depth, *color, *live;
  float scale;
  Varying varying; // without stages: the color
  bool opaque;

  SOFTGL_MEMBER FragmentWords(const RasterDraw& draw, uint16_t* p, uint32_t* d, uint32_t* c, uint32_t* l)
      : pixel(p), depth(d), color(c), live(l), scale(depth_scale(draw.program->key)),
        varying(draw.varying[0]), opaque(draw.opaque) {}
};

/// Shades fragments of small triangles, side by side in the order of the triangles. Staged: with stages of
/// the program.
template <bool Staged> class SmallShader {
public:
  SmallShader(const RasterDraw& draw, FragmentBlock& block)
      : draw_(draw), block_(block), program_(*draw.program), kills_(draw.program->tests_alpha()) {}

  /// Fragments [f, f + kWidth) at px, py.
  template <class Planes>
  SOFTGL_MEMBER void shade(const FragmentWords& words, Planes& planes, int32_t f, IntV px, IntV py) {
    const FloatV x = to_float(px), y = to_float(py);
    const IntV depth = depth_bits(value_at(planes.z(), x, y) + planes.offset(*draw_.raster), words.scale);
    store(words.depth + f, depth);
    const PlaneV w = planes.w();
    const FloatV rw = splat(1.0f) / value_at(w, x, y);
    auto value = [&](const Varying& v, int k) __attribute__((always_inline)) {
      const PlaneV p = planes.plane(v, k);
      return v.flat ? p.a : value_at(p, x, y) * rw;
    };
    if constexpr (!Staged) {
      Varying color = words.varying;
      color.first = 0; // says to the compiler what it is
      planes.select(color);
      const FloatV r = value(color, 0), g = value(color, 1), b = value(color, 2);
      store(words.color + f, words.opaque ? pack_opaque(r, g, b) : pack_color(r, g, b, value(color, 3)));
      return;
    }
    if (f + kWidth > first_ + kLanes) finish(words, f);
    const int lane = f - first_;
    for (int i = 0; i < draw_.varying_count; ++i) {
      const Varying& v = draw_.varying[i];
      planes.select(v);
      for (int k = 0; k < v.components; ++k) store(lanes_of(block_, v, k) + lane, value(v, k));
    }
    if (draw_.facing) store(block_.back + lane, planes.back());
    for (int u = 0; u < kMaxTextureUnits; ++u) {
      if (draw_.unit_plane[u] < 0) continue;
      const Varying v = coordinates_of_unit(draw_, u);
      planes.select(v);
      const PlaneV q[4] = {planes.plane(v, 0), planes.plane(v, 1), planes.plane(v, 2), planes.plane(v, 3)};
      interpolate_unit(block_.unit[u], lane, coordinates_read(program_, u), plane_of_w(draw_, u, w), q, px,
                       py);
    }
    store(block_.x + lane, px), store(block_.y + lane, py);
    store(block_.depth + lane, depth);
  }

  /// Sends fragments up to `end` through the program; then others may come from fragment `next` on.
  void finish(const FragmentWords& words, int32_t end) {
    const int lanes = end - first_;
    if (!Staged || lanes == 0) return;
    block_.lanes = (lanes + kStripLanes - 1) & ~(kStripLanes - 1);
    for (int j = 0; j < kLanes; ++j) block_.live[j] = j < lanes ? ~uint32_t(0) : 0;
    // Lanes past the last fragment hold values of an earlier block or copies: finite, as far as those are.
    run_stages(program_, block_);
    for (int j = 0; j < lanes; j += kWidth) {
      store(words.color + first_ + j, pack_color(load(block_.color[0] + j), load(block_.color[1] + j),
                                                 load(block_.color[2] + j), load(block_.color[3] + j)));
      if (kills_) store(words.live + first_ + j, load(block_.live + j));
    }
    first_ = end;
  }

private:
  const RasterDraw& draw_;
  FragmentBlock& block_;
  const FragmentProgram& program_;
  const bool kills_;  // fragments' `live` is asked for
  int32_t first_ = 0; // fragment in lane 0 of the block
};

} // namespace

} // namespace SOFTGL_ISA
} // namespace softgl
