// Sampling in float: wide formats, and the wrap modes that fixed point does not cover. Operation order as in
// OSMesa 22.3.6: coordinate * size - 0.5, weight = fraction, lerp = w * (b - a) + a along x, then y, then z,
// then levels.
#pragma once

#include "shaders/texture/texture_border.inl"
#include "shaders/texture/texture_fetch.inl"
#include "shaders/texture/texture_lod.inl"
#include "shaders/texture/texture_seamless.inl"
#include "shaders/texture/texture_shadow.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// 2 * |s / 2 - round(s / 2)|: one period of mirrored repetition.
static inline __attribute__((always_inline)) float mirror(float s) {
  const float half = s * 0.5f, d = half - round_of(half);
  return absolute(d + d);
}

/// The weight of the second texel is the fraction of `u`, which counts texels; the first is the texel below.
static inline __attribute__((always_inline)) void floor_axis(FloatAxis& out, int32_t i, float u) {
  out.first[i] = floor_to_int(u);
  out.weight[i] = u - floor_of(u);
}

template <class Sizes>
static inline void float_linear_axis(const FragmentBlock& block, const TextureUnitConstants& t, int axis,
                                     const float* __restrict coordinate, Sizes sizes, FloatAxis& out) {
  const auto scale = [&](int32_t i) { return t.counts_texels ? 1.0f : float(sizes[i]); };
  switch (t.wrap[axis]) {
  case TextureWrap::RepeatPowerOfTwo:
    SOFTGL_FOR_LANES(block, i) {
      floor_axis(out, i, coordinate[i] * float(sizes[i]) - 0.5f);
      out.second[i] = int32_t(uint32_t(out.first[i]) + 1) & (sizes[i] - 1);
      out.first[i] &= sizes[i] - 1;
    }
    break;
  case TextureWrap::Repeat:
    SOFTGL_FOR_LANES(block, i) {
      const float s = coordinate[i], u = (s - floor_of(s)) * float(sizes[i]) - 0.5f;
      floor_axis(out, i, u);
      const int32_t last = sizes[i] - 1;
      const int32_t x = select(mask_of(u < 0.0f), last, clamp_int(out.first[i], 0, last));
      out.first[i] = x;
      out.second[i] = (x + 1) & ~mask_of(x == last);
    }
    break;
  case TextureWrap::ClampToEdge:
    SOFTGL_FOR_LANES(block, i) {
      const float size = float(sizes[i]);
      const float u = maximum(minimum(coordinate[i] * scale(i), size) - 0.5f, 0.0f);
      const int32_t x = int32_t(u);
      out.weight[i] = u - float(x);
      out.first[i] = x;
      out.second[i] = clamp_int(x + 1, 0, sizes[i] - 1);
    }
    break;
  case TextureWrap::Clamp:
    SOFTGL_FOR_LANES(block, i) {
      floor_axis(out, i, maximum(minimum(coordinate[i] * scale(i), float(sizes[i])), 0.0f) - 0.5f);
      out.second[i] = int32_t(uint32_t(out.first[i]) + 1);
    }
    break;
  case TextureWrap::ClampToBorder:
    SOFTGL_FOR_LANES(block, i) {
      floor_axis(out, i, coordinate[i] * scale(i) - 0.5f);
      out.second[i] = int32_t(uint32_t(out.first[i]) + 1);
    }
    break;
  default: // MirroredRepeat
    SOFTGL_FOR_LANES(block, i) {
      floor_axis(out, i, maximum(mirror(coordinate[i]), 0.0f) * float(sizes[i]) - 0.5f);
      const int32_t x = out.first[i], next = x + 1, last = sizes[i] - 1;
      out.first[i] = select(mask_of(x > 0), x, 0);
      out.second[i] = select(mask_of(next < last), next, last);
    }
  }
}

template <class Lanes, class Sizes>
static inline void float_nearest_axis(const Lanes& block, const TextureUnitConstants& t, int axis,
                                      const float* __restrict coordinate, Sizes sizes,
                                      int32_t* __restrict out) {
  const float below_one = 0.999999940395355224609375f;
  const auto scale = [&](int32_t i) { return t.counts_texels ? 1.0f : float(sizes[i]); };
  switch (t.wrap[axis]) {
  case TextureWrap::RepeatPowerOfTwo:
    SOFTGL_FOR_LANES(block, i) out[i] = floor_to_int(coordinate[i] * float(sizes[i])) & (sizes[i] - 1);
    break;
  case TextureWrap::Repeat:
    SOFTGL_FOR_LANES(block, i) {
      const float f = coordinate[i] - floor_of(coordinate[i]);
      out[i] = clamp_int(int32_t(minimum(f, below_one) * float(sizes[i])), 0, sizes[i] - 1);
    }
    break;
  case TextureWrap::ClampToEdge:
  case TextureWrap::Clamp:
    SOFTGL_FOR_LANES(block, i) out[i] = clamp_int(int32_t(coordinate[i] * scale(i)), 0, sizes[i] - 1);
    break;
  case TextureWrap::ClampToBorder:
    SOFTGL_FOR_LANES(block, i) out[i] = floor_to_int(coordinate[i] * scale(i));
    break;
  default: // MirroredRepeat
    SOFTGL_FOR_LANES(block, i)
    out[i] = clamp_int(int32_t(maximum(mirror(coordinate[i]), 0.0f) * float(sizes[i])), 0, sizes[i] - 1);
  }
}

/// a += weight * (b - a).
static inline void lerp_lanes(const FragmentBlock& block, int components, const float* __restrict weight,
                              const FloatTexels& b, FloatTexels& a) {
  for (int k = 0; k < components; ++k)
    SOFTGL_FOR_LANES(block, i) a.v[k][i] = weight[i] * (b.v[k][i] - a.v[k][i]) + a.v[k][i];
}

/// The texels between which a linear filter interpolates, and what it does with them, axis by axis.
template <class Images> struct LinearFilter {
  const FragmentBlock& block;
  const BlockCoordinates& c;
  const TextureUnitConstants& t;
  Images images;
  int axes, components;
  FloatAxis axis[3];

  LinearFilter(const FragmentBlock& block_, const BlockCoordinates& c_, const TextureUnitConstants& t_,
               Images images_)
      : block(block_), c(c_), t(t_), images(images_), axes(t_.shape == TextureShape::OneD     ? 1
                                                           : t_.shape == TextureShape::ThreeD ? 3
                                                                                              : 2),
        components(t_.compares ? 1 : 4) {
    float_linear_axis(block, t, 0, c.s, images.width, axis[0]);
    if (axes > 1) float_linear_axis(block, t, 1, c.t, images.height, axis[1]);
    if (axes > 2) float_linear_axis(block, t, 2, c.r, images.depth, axis[2]);
  }

  /// Along x.
  void line(const int32_t* y, const int32_t* z, FloatTexels& out) const {
    if (block.lanes <= 0) __builtin_unreachable(); // the arrays below are filled
    FloatTexels next;
    TexelRows rows;
    TexelPlaces at;
    find_rows(block, images, y, z, rows);
    find_texels(block, images, rows, axis[0].first, at);
    if (!t.compares) {
      fetch_texels(block, t, images, at, out);
      find_texels(block, images, rows, axis[0].second, at);
      fetch_texels(block, t, images, at, next);
      lerp_lanes(block, components, axis[0].weight, next, out);
      return;
    }
    // The comparisons are filtered, as masked weights (OSMesa 22.3.6).
    compare_texels(block, c, t, images, at, out.v[0]);
    find_texels(block, images, rows, axis[0].second, at);
    compare_texels(block, c, t, images, at, next.v[0]);
    const float* __restrict weight = axis[0].weight;
    SOFTGL_FOR_LANES(block, i)
    out.v[0][i] =
        keep(mask_of(next.v[0][i] != 0), weight[i]) + keep(mask_of(out.v[0][i] != 0), 1.0f - weight[i]);
  }
  /// Along x and y.
  void plane(const int32_t* z, FloatTexels& out) const {
    line(axes > 1 ? axis[1].first : nullptr, z, out);
    if (axes == 1) return;
    FloatTexels next;
    line(axis[1].second, z, next);
    lerp_lanes(block, components, axis[1].weight, next, out);
  }
  void filter(FloatTexels& out) const {
    plane(axes > 2 ? axis[2].first : nullptr, out);
    if (axes == 3) {
      FloatTexels next;
      plane(axis[2].second, next);
      lerp_lanes(block, components, axis[2].weight, next, out);
    }
    for (int k = components; k < 4; ++k) SOFTGL_FOR_LANES(block, i) out.v[k][i] = out.v[0][i];
  }
};

template <class Images, class WithBorder>
static inline void sample_nearest(const FragmentBlock& block, const BlockCoordinates& c,
                                  const TextureUnitConstants& t, Images images, WithBorder with_border,
                                  FloatTexels& out) {
  if (block.lanes <= 0) __builtin_unreachable(); // the arrays below are filled
  alignas(64) int32_t x[kLanes], y[kLanes], z[kLanes];
  const bool two = t.shape != TextureShape::OneD, three = t.shape == TextureShape::ThreeD;
  float_nearest_axis(block, t, 0, c.s, images.width, x);
  if (two) float_nearest_axis(block, t, 1, c.t, images.height, y);
  if (three) float_nearest_axis(block, t, 2, c.r, images.depth, z);
  if (t.bordered) {
    number_from_border(block, images.width, x);
    if (two) number_from_border(block, images.height, y);
    if (three) number_from_border(block, images.depth, z);
    images = with_border();
  }
  TexelRows rows;
  TexelPlaces at;
  find_rows(block, images, two ? y : nullptr, three ? z : nullptr, rows);
  find_texels(block, images, rows, x, at);
  if (!t.compares) return fetch_texels(block, t, images, at, out);
  compare_texels(block, c, t, images, at, out.v[0]);
  for (int k = 1; k < 4; ++k) SOFTGL_FOR_LANES(block, i) out.v[k][i] = out.v[0][i];
}

/// `nearest`, if there is one: lanes whose linear filter takes the texel of the greater weight alone.
template <class Images, class WithBorder>
static inline void sample_linear(const FragmentBlock& block, const BlockCoordinates& c,
                                 const TextureUnitConstants& t, Images images, WithBorder with_border,
                                 const int32_t* nearest, FloatTexels& out) {
  LinearFilter filter(block, c, t, images);
  if (t.bordered) {
    auto number = [&](int axis, auto sizes) {
      if (axis >= filter.axes) return;
      number_from_border(block, sizes, filter.axis[axis].first);
      number_from_border(block, sizes, filter.axis[axis].second);
    };
    number(0, images.width), number(1, images.height), number(2, images.depth);
    filter.images = with_border();
  }
  for (int a = 0; nearest && a < filter.axes; ++a) {
    float* __restrict weight = filter.axis[a].weight;
    SOFTGL_FOR_LANES(block, i) {
      const float whole = keep(mask_of(weight[i] > 0.5f), 1.0f);
      weight[i] = select(mask_of(nearest[i] != 0), whole, weight[i]);
    }
  }
  filter.filter(out);
}

static inline void sample_float_level(const FragmentBlock& block, const BlockCoordinates& c,
                                      const TextureUnitConstants& t, const int32_t* levels, int add,
                                      bool linear, const int32_t* nearest, FloatTexels& out) {
  if (block.lanes <= 0) __builtin_unreachable(); // the arrays below are filled
  const int32_t level = level_of_all(block, levels);
  auto sample = [&](auto images, auto with_border) __attribute__((always_inline)) {
    linear ? sample_linear(block, c, t, images, with_border, nearest, out)
           : sample_nearest(block, c, t, images, with_border, out);
  };
  if (level >= 0 && t.shape != TextureShape::Cube) {
    const OneImage image(level_number(t, level + add));
    sample(image, [&] {
      OneImage wider = image;
      take_in_border(1, t, wider);
      return wider;
    });
    return;
  }
  LevelImages images;
  find_images(block, c, t, level, levels, add, images);
  if (linear && t.seamless) return sample_seamless_level(block, c, t, images, nearest, out);
  sample(images.view(), [&] {
    take_in_border(block.lanes, t, images);
    return images.view();
  });
}

static inline void sample_float_levels(const FragmentBlock& block, const BlockCoordinates& c,
                                       const TextureUnitConstants& t, const LaneLevels& lod, bool two_levels,
                                       bool linear, const int32_t* nearest, FloatTexels& out) {
  sample_float_level(block, c, t, lod.level, 0, linear, nearest, out);
  if (!two_levels) return;
  FloatTexels next;
  sample_float_level(block, c, t, lod.level, 1, linear, nearest, next);
  for (int k = 0; k < 4; ++k)
    SOFTGL_FOR_LANES(block, i) out.v[k][i] = lod.fraction[i] * (next.v[k][i] - out.v[k][i]) + out.v[k][i];
}

static inline void choose_texels(const FragmentBlock& block, const int32_t* mask, const FloatTexels& chosen,
                                 FloatTexels& out) {
  for (int k = 0; k < 4; ++k)
    SOFTGL_FOR_LANES(block, i) out.v[k][i] = select(mask[i], chosen.v[k][i], out.v[k][i]);
}

/// The filtered texels of a block.
static inline void sample_float(const FragmentBlock& block, const BlockCoordinates& c,
                                const TextureUnitConstants& t, FloatTexels& out) {
  alignas(64) LaneLevels lod;
  const bool mixed = t.min_linear != t.mag_linear;
  if (t.mip == TextureMip::None && !mixed) {
    for (int i = 0; i < block.lanes; ++i) lod.level[i] = 0;
    sample_float_level(block, c, t, lod.level, 0, t.min_linear, nullptr, out);
    return;
  }
  find_levels(block, c, t, lod);
  uint32_t magnified = 0, minified = 0, between = 0;
  for (int i = 0; i < block.lanes; ++i) {
    magnified |= uint32_t(lod.magnified[i]) & block.live[i];
    minified |= ~uint32_t(lod.magnified[i]) & block.live[i];
    between |= uint32_t(float_bits(lod.fraction[i])) & block.live[i];
  }
  const bool two_levels = t.mip == TextureMip::Linear && between != 0;
  FloatTexels other;
  if (mixed && t.shape == TextureShape::Cube && t.mip != TextureMip::None) {
    // OSMesa 22.3.6: here levels differ within a quad. If one of its lanes is filtered linearly, so are all,
    // those that want the nearest texel with weights of 0 and 1.
    alignas(64) int32_t nearest[kLanes], linear_quad[kLanes];
    for (int i = 0; i < block.lanes; ++i) nearest[i] = t.min_linear ? lod.magnified[i] : ~lod.magnified[i];
    for (int i = 0; i < block.lanes; ++i) {
      const int32_t* quad = nearest + first_of_quad(i);
      linear_quad[i] = ~(quad[0] & quad[1] & quad[8] & quad[9]);
    }
    sample_float_levels(block, c, t, lod, two_levels, false, nullptr, out);
    sample_float_levels(block, c, t, lod, two_levels, true, nearest, other);
    choose_texels(block, linear_quad, other, out);
    return;
  }
  const bool minifies = !mixed || minified != 0;
  if (minifies) sample_float_levels(block, c, t, lod, two_levels, t.min_linear, nullptr, out);
  if (mixed && magnified != 0) {
    for (int i = 0; i < block.lanes; ++i) lod.level[i] = 0;
    sample_float_level(block, c, t, lod.level, 0, t.mag_linear, nullptr, minifies ? other : out);
    if (minifies) choose_texels(block, lod.magnified, other, out);
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
