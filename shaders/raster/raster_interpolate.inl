// Attribute values at pixels: into a FragmentBlock, from the planes of one primitive.
#pragma once

#include "shaders/raster/raster_setup.inl"

namespace softgl {
namespace SOFTGL_ISA {

SOFTGL_INLINE FloatV at(const Plane& p, FloatV x, FloatV y) {
  return splat(p.gy) * y + (splat(p.gx) * x + splat(p.a));
}

/// Which differences across 2x2 quads a unit's stages read. OfQuad: the same in all four lanes of a quad,
/// from its top left pixel. OfLane: of the lane's own row and column.
enum class Differences : uint8_t { None, OfQuad, OfLane };

/// Differences across each 2x2 quad of a strip of 8x2 pixels.
template <Differences Kind> SOFTGL_INLINE void differences_of(const float* value, float* dx, float* dy) {
  constexpr bool kOfQuad = Kind == Differences::OfQuad;
  for (int i = 0; i < 8; i += kWidth) {
    const FloatV top = load_row(value + i), bottom = load_row(value + 8 + i), corner = even_lanes(top);
    const FloatV x = odd_lanes(top) - corner;
    const FloatV y = kOfQuad ? even_lanes(bottom) - corner : bottom - top;
    store(dx + i, x), store(dy + i, y); // of both rows if there are sixteen lanes
    if constexpr (kWidth <= 8) store(dx + 8 + i, x), store(dy + 8 + i, y);
  }
  if constexpr (!kOfQuad)
    for (int i = 0; i < 16; i += kWidth)
      store(dx + i, odd_lanes(load(value + i)) - even_lanes(load(value + i)));
}

/// What is read of a unit's coordinates: s and t, or s, t and r; and their differences.
struct CoordinatesRead {
  int count;
  Differences differences;
};
SOFTGL_INLINE CoordinatesRead coordinates_read(const FragmentProgram& program, int unit) {
  return {program.r_units >> unit & 1 ? 3 : 2, !(program.lod_units >> unit & 1) ? Differences::None
                                               : program.cube_units >> unit & 1 ? Differences::OfLane
                                                                                : Differences::OfQuad};
}

/// Sets the differences of the coordinates of strips, lanes [first, end).
SOFTGL_INLINE void strip_differences(BlockCoordinates& t, int first, int end, CoordinatesRead read) {
  auto all = [&](auto quad_differences) __attribute__((always_inline)) {
    for (int i = first; i < end; i += kStripLanes) {
      quad_differences(t.s + i, t.ds_dx + i, t.ds_dy + i);
      quad_differences(t.t + i, t.dt_dx + i, t.dt_dy + i);
      if (read.count > 2) quad_differences(t.r + i, t.dr_dx + i, t.dr_dy + i);
    }
  };
  if (read.differences == Differences::OfQuad)
    all([](const float* v, float* dx, float* dy)
            __attribute__((always_inline)) { differences_of<Differences::OfQuad>(v, dx, dy); });
  if (read.differences == Differences::OfLane)
    all([](const float* v, float* dx, float* dy)
            __attribute__((always_inline)) { differences_of<Differences::OfLane>(v, dx, dy); });
}

SOFTGL_INLINE float* lanes_of(FragmentBlock& block, const Varying& v, int component) {
  return reinterpret_cast<float*>(reinterpret_cast<char*>(&block) + v.lanes) + component * kLanes;
}

template <int n> struct Count {
  constexpr operator int() const { return n; }
};

/// The planes of one primitive, the same for all lanes. What is read once serves many lanes.
struct PlanesOfPrimitive {
  const RasterPrimitive& primitive;

  SOFTGL_MEMBER PlaneV read(int index) const {
    const Plane& p = primitive.plane[index];
    return {splat(p.a), splat(p.gx), splat(p.gy)};
  }
  SOFTGL_MEMBER PlaneV at(const PlaneV& plane, int) const { return plane; }
  SOFTGL_MEMBER IntV back(int) const { return splat(-int32_t(primitive.back)); }
};

/// Where lanes are, and 1/w there.
struct LanePlaces {
  alignas(64) float x[kLanes], y[kLanes], w[kLanes];
};

/// Fills all inputs but coordinates for lanes [first, end), component by component.
template <class Planes> SOFTGL_INLINE void interpolate_varyings(const RasterDraw& draw, const Planes& planes,
                                                                int first, int end, const LanePlaces& lanes,
                                                                FragmentBlock& block) {
  auto fill = [&](int index, float* out, bool constant, auto components) __attribute__((always_inline)) {
    PlaneV q[components];
    for (int k = 0; k < components; ++k) q[k] = planes.read(index + k);
    for (int i = first; i < end; i += kWidth) {
      const FloatV x = load(lanes.x + i), y = load(lanes.y + i), w = load(lanes.w + i);
      for (int k = 0; k < components; ++k) {
        const PlaneV p = planes.at(q[k], i);
        store(out + k * kLanes + i, constant ? p.a : value_at(p, x, y) * w);
      }
    }
  };
  for (int n = 0; n < draw.varying_count; ++n) {
    const Varying& v = draw.varying[n];
    float* out = lanes_of(block, v, 0);
    if (v.components == 4)
      fill(v.plane, out, v.flat, Count<4>());
    else if (v.components == 3)
      fill(v.plane, out, v.flat, Count<3>());
    else
      for (int k = 0; k < v.components; ++k) fill(v.plane + k, out + k * kLanes, v.flat, Count<1>());
  }
  if (draw.facing)
    for (int i = first; i < end; i += kWidth) store(block.back + i, planes.back(i));
}

/// Coordinates of a unit for lanes [first, end).
template <class Planes>
SOFTGL_INLINE void interpolate_coordinates(const RasterDraw& draw, const Planes& planes, int unit,
                                           CoordinatesRead read, int first, int end, const LanePlaces& lanes,
                                           BlockCoordinates& t) {
  float* value[3] = {t.s, t.t, t.r};
  const bool flat = draw.flat_units >> unit & 1;
  for (int i = first; i < end; i += kWidth) {
    const FloatV x = load(lanes.x + i), y = load(lanes.y + i), w = flat ? splat(1.0f) : load(lanes.w + i);
    auto value_of = [&](int k) __attribute__((always_inline)) { // read here: there are few lanes at a time
      return value_at(planes.at(planes.read(draw.unit_plane[unit] + k), i), x, y) * w;
    };
    const FloatV rq = splat(1.0f) / value_of(3);
    for (int k = 0; k < read.count; ++k) store(value[k] + i, value_of(k) * rq);
  }
}

/// Fills the inputs of lanes [first, end), which are strips of one primitive; block.x and block.y are set.
/// `FromCorner`: planes count from the corner of the first pixel, not from its center.
template <bool FromCorner> static void interpolate_block(const RasterDraw& draw, const RasterPrimitive& p,
                                                         int first, int end, FragmentBlock& block) {
  const PlanesOfPrimitive planes{p};
  LanePlaces lanes;
  const PlaneV w_plane = planes.read(kPlaneW);
  for (int i = first; i < end; i += kWidth) {
    FloatV x = to_float(load(block.x + i)), y = to_float(load(block.y + i));
    if constexpr (FromCorner) x += 0.5f, y += 0.5f;
    store(lanes.x + i, x), store(lanes.y + i, y);
    store(lanes.w + i, p.w_is_one ? splat(1.0f) : splat(1.0f) / value_at(w_plane, x, y));
  }
  interpolate_varyings(draw, planes, first, end, lanes, block);
  for (int k = 0; k < draw.coverage_numbers; ++k)
    for (int i = first; i < end; i += kWidth)
      store(block.coverage[k] + i, splat(p.plane[coverage_plane(draw) + k].a));
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    if (draw.unit_plane[u] < 0) continue;
    const CoordinatesRead read = coordinates_read(*draw.program, u);
    interpolate_coordinates(draw, planes, u, read, first, end, lanes, block.unit[u]);
    strip_differences(block.unit[u], first, end, read);
  }
}

/// 1/w for the coordinates of a unit: 1 where they are not interpolated.
SOFTGL_INLINE PlaneV plane_of_w(const RasterDraw& draw, int unit, const PlaneV& w) {
  return draw.flat_units >> unit & 1 ? PlaneV{splat(1.0f), FloatV{}, FloatV{}} : w;
}

/// Coordinates of one unit for lanes [lane, lane + kWidth), each with its own planes; 1/w and 1/q there.
SOFTGL_INLINE void coordinates_at(BlockCoordinates& t, int lane, CoordinatesRead read, const PlaneV& w,
                                  const PlaneV q[4], FloatV x, FloatV y) {
  float* value[3] = {t.s, t.t, t.r};
  const FloatV one = splat(1.0f), w_here = one / value_at(w, x, y),
               q_here = one / (value_at(q[3], x, y) * w_here);
  for (int k = 0; k < read.count; ++k) store(value[k] + lane, (value_at(q[k], x, y) * w_here) * q_here);
}

/// The same, and their differences across the lane's 2x2 quad. `FromCorner`: as of interpolate_block().
template <bool FromCorner = false> SOFTGL_INLINE void interpolate_unit(BlockCoordinates& t, int lane,
                                                                       CoordinatesRead read, const PlaneV& w,
                                                                       const PlaneV q[4], IntV px, IntV py) {
  const auto center = [](IntV v) __attribute__((always_inline)) {
    return FromCorner ? to_float(v) + 0.5f : to_float(v);
  };
  coordinates_at(t, lane, read, w, q, center(px), center(py));
  if (read.differences == Differences::None) return;
  float* dx[3] = {t.ds_dx, t.dt_dx, t.dr_dx};
  float* dy[3] = {t.ds_dy, t.dt_dy, t.dr_dy};
  const FloatV one = splat(1.0f);
  const FloatV x0 = center(px & ~1), y0 = center(py & ~1), x1 = x0 + 1.0f, y1 = y0 + 1.0f;
  struct Place {
    FloatV x, y, w, q;
  };
  auto place = [&](FloatV x, FloatV y) __attribute__((always_inline)) {
    const FloatV w_there = one / value_at(w, x, y);
    return Place{x, y, w_there, one / (value_at(q[3], x, y) * w_there)};
  };
  auto value = [&](int k, const Place& p) __attribute__((always_inline)) {
    return (value_at(q[k], p.x, p.y) * p.w) * p.q;
  };
  if (read.differences == Differences::OfLane) {
    const IntV odd_x = (px & 1) != 0, odd_y = (py & 1) != 0;
    const Place beside = place(choose(odd_x, x0, x1), center(py)),
                below = place(center(px), choose(odd_y, y0, y1));
    const float* here[3] = {t.s, t.t, t.r};
    for (int k = 0; k < read.count; ++k) {
      const FloatV v = load(here[k] + lane), h = value(k, beside), l = value(k, below);
      store(dx[k] + lane, choose(odd_x, v, h) - choose(odd_x, h, v));
      store(dy[k] + lane, choose(odd_y, v, l) - choose(odd_y, l, v));
    }
    return;
  }
  const Place corner = place(x0, y0), right = place(x1, y0), lower = place(x0, y1);
  for (int k = 0; k < read.count; ++k) {
    const FloatV v = value(k, corner);
    store(dx[k] + lane, value(k, right) - v);
    store(dy[k] + lane, value(k, lower) - v);
  }
}

/// Fills the inputs of lanes [0, block.lanes), each of its own primitive. `Quads`: the lanes of 2x2 quads,
/// laid out as in strips, are of one primitive.
template <bool Quads> static void
interpolate_lanes(const RasterDraw& draw, const RasterPrimitive* const* primitive, FragmentBlock& block) {
  const FragmentProgram& program = *draw.program;
  // Vectors at i and i + 8 have the same primitives: their planes are brought together once.
  constexpr int kRows = Quads && kWidth <= 8 ? 2 : 1;
  for (int i = 0; i < block.lanes; i += kWidth) {
    if (kRows == 2 && i & 8) continue;
    auto plane = [&](int index) {
      FloatV v[4];
      load_transposed(
          [&](int k) __attribute__((always_inline)) { return &primitive[i + k]->plane[index].a; }, v);
      return PlaneV{v[0], v[1], v[2]};
    };
    const PlaneV w = plane(kPlaneW);
    FloatV x[kRows], y[kRows], rw[kRows];
    for (int r = 0; r < kRows; ++r) {
      x[r] = to_float(load(block.x + i + 8 * r)), y[r] = to_float(load(block.y + i + 8 * r));
      rw[r] = splat(1.0f) / value_at(w, x[r], y[r]);
    }
    auto put = [&](int index, float* out, bool constant) {
      const PlaneV p = plane(index);
      for (int r = 0; r < kRows; ++r)
        store(out + i + 8 * r, constant ? p.a : value_at(p, x[r], y[r]) * rw[r]);
    };
    for (int v = 0; v < draw.varying_count; ++v)
      for (int k = 0; k < draw.varying[v].components; ++k)
        put(draw.varying[v].plane + k, lanes_of(block, draw.varying[v], k), draw.varying[v].flat);
    for (int r = 0; r < kRows; ++r)
      for (int k = i + 8 * r; k < i + 8 * r + kWidth; ++k) {
        if (draw.facing) block.back[k] = -int32_t(primitive[k]->back);
        for (int n = 0; n < draw.coverage_numbers; ++n)
          block.coverage[n][k] = primitive[k]->plane[coverage_plane(draw) + n].a;
      }
    for (int u = 0; u < kMaxTextureUnits; ++u) {
      if (draw.unit_plane[u] < 0) continue;
      const CoordinatesRead read = coordinates_read(program, u);
      BlockCoordinates& t = block.unit[u];
      PlaneV q[4];
      for (int k = 0; k < read.count; ++k) q[k] = plane(draw.unit_plane[u] + k);
      q[3] = plane(draw.unit_plane[u] + 3);
      const PlaneV unit_w = plane_of_w(draw, u, w);
      if constexpr (Quads) {
        for (int r = 0; r < kRows; ++r) coordinates_at(t, i + 8 * r, read, unit_w, q, x[r], y[r]);
        const int strip = i & ~(kStripLanes - 1);
        strip_differences(t, strip, strip + kStripLanes, read);
      } else {
        interpolate_unit(t, i, read, unit_w, q, load(block.x + i), load(block.y + i));
      }
    }
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
