// Sampling of textures of at most 8 bits per component with wrap modes REPEAT and CLAMP_TO_EDGE, in 8.8 fixed
// point (OSMesa 22.3.6): u = round(s * (width * 256)) - 128, texel u >> 8, weight u & 255; the filtered texel
// is an 8-bit integer again. NPOT repeat takes u from the fraction of s. Passes over the whole block:
// addresses, loads, interpolation. Measured with rows padded by one texel and two 8-byte loads a
// footprint: 2.5 to 4 times as fast as one pixel at a time.
#pragma once

#include "shaders/texture/texture_lod.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// The sizes of the level of each lane: either one level for all, or a level per lane.
template <bool one_level> struct FixedLevels;
template <> struct FixedLevels<true> {
  const TextureLevel& level;
  FixedLevels(const FragmentBlock&, const BlockCoordinates&, const TextureUnitConstants& t,
              const int32_t* levels, int add)
      : level(t.level[levels[0] + add]) {}
  int32_t width(int) const { return level.width; }
  int32_t height(int) const { return level.height; }
  int32_t depth(int) const { return level.depth; }
  int32_t row(int) const { return level.row; }
  int32_t slice(int) const { return level.slice; }
  const unsigned char* texels(int) const { return level.face[0]; }
};
template <> struct FixedLevels<false> {
  alignas(64) int32_t width_[kLanes], height_[kLanes], depth_[kLanes], row_[kLanes], slice_[kLanes];
  const unsigned char* texels_[kLanes];
  FixedLevels(const FragmentBlock& block, const BlockCoordinates& c, const TextureUnitConstants& t,
              const int32_t* levels, int add) {
    const bool cube = t.shape == TextureShape::Cube;
    for (int i = 0; i < block.lanes; ++i) {
      int32_t l = levels[i] + add;
      l = l > t.last_level ? t.last_level : l;
      const TextureLevel& level = t.level[l];
      width_[i] = level.width, height_[i] = level.height, depth_[i] = level.depth, row_[i] = level.row,
      slice_[i] = level.slice;
      texels_[i] = level.face[cube ? face_of(c, i) : 0];
    }
  }
  int32_t width(int i) const { return width_[i]; }
  int32_t height(int i) const { return height_[i]; }
  int32_t depth(int i) const { return depth_[i]; }
  int32_t row(int i) const { return row_[i]; }
  int32_t slice(int i) const { return slice_[i]; }
  const unsigned char* texels(int i) const { return texels_[i]; }
};

/// Texel number and weight (in both halves of a word) along one axis.
template <class Size> static inline __attribute__((always_inline)) void
linear_axis(const FragmentBlock& block, const TextureUnitConstants& t, int axis, const float* coordinate,
            Size size, int32_t* texel, uint32_t* weight) {
  const TextureWrap wrap = t.wrap[axis];
  alignas(64) float scaled[kLanes];
  alignas(64) int32_t u[kLanes];
  if (wrap == TextureWrap::Repeat) {
    SOFTGL_FOR_LANES(block, i) {
      const float s = coordinate[i];
      scaled[i] = ((s - floor_of(s)) * float(size(i))) * 256.0f;
    }
  } else if (t.counts_texels) {
    SOFTGL_FOR_LANES(block, i) scaled[i] = coordinate[i] * 256.0f;
  } else {
    SOFTGL_FOR_LANES(block, i) scaled[i] = coordinate[i] * float(size(i) << 8);
  }
  round_lanes(block, scaled, u);
  switch (wrap) {
  case TextureWrap::RepeatPowerOfTwo:
    SOFTGL_FOR_LANES(block, i) {
      const uint32_t v = uint32_t(u[i]) - 128, w = v & 255;
      texel[i] = (int32_t(v) >> 8) & (size(i) - 1);
      weight[i] = w | w << 16;
    }
    break;
  case TextureWrap::Repeat:
    SOFTGL_FOR_LANES(block, i) {
      const uint32_t v = uint32_t(u[i]) - 128, w = v & 255;
      const int32_t last = size(i) - 1;
      int32_t x = int32_t(v) >> 8;
      x = select(x >> 31, last, x);
      texel[i] = select(mask_of(x < last), x, last);
      weight[i] = w | w << 16;
    }
    break;
  default: // ClampToEdge: both texels are the same outside, which weight 0 expresses
    SOFTGL_FOR_LANES(block, i) {
      const uint32_t v = uint32_t(u[i]) - 128;
      const int32_t last = size(i) - 1, x = int32_t(v) >> 8;
      const uint32_t inside = uint32_t(mask_of(x >= 0) & mask_of(x < last)), w = v & 255 & inside;
      texel[i] = clamp_int(x, 0, last);
      weight[i] = w | w << 16;
    }
  }
}

template <class Size> static inline __attribute__((always_inline)) void
nearest_axis(const FragmentBlock& block, const TextureUnitConstants& t, int axis, const float* coordinate,
             Size size, int32_t* texel) {
  switch (t.wrap[axis]) {
  case TextureWrap::RepeatPowerOfTwo:
    SOFTGL_FOR_LANES(block, i) texel[i] = floor_to_int(coordinate[i] * float(size(i))) & (size(i) - 1);
    break;
  case TextureWrap::Repeat:
    SOFTGL_FOR_LANES(block, i) {
      const float s = coordinate[i], f = s - floor_of(s);
      const float below_one =
          0.999999940395355224609375f; // a fraction of 1 comes from tiny negative coordinates
      texel[i] =
          clamp_int(int32_t(select(mask_of(f < below_one), f, below_one) * float(size(i))), 0, size(i) - 1);
    }
    break;
  default:
    if (t.counts_texels) {
      SOFTGL_FOR_LANES(block, i) texel[i] = clamp_int(floor_to_int(coordinate[i]), 0, size(i) - 1);
      break;
    }
    SOFTGL_FOR_LANES(block, i)
    texel[i] = clamp_int(floor_to_int(coordinate[i] * float(size(i))), 0, size(i) - 1);
  }
}

typedef uint32_t AliasedWord __attribute__((may_alias, aligned(1)));

/// The 2x2 footprints at texel numbers `first`, filtered.
template <class Levels> static inline __attribute__((always_inline)) void
sample_fixed_square(const FragmentBlock& block, const Levels& levels, const int32_t* first,
                    const uint32_t* wx, const uint32_t* wy, uint32_t* texel) {
  for (int i = 0; i < block.lanes; i += kWidth) {
    auto upper = [&](int k) __attribute__((always_inline)) {
      return levels.texels(i + k) + size_t(uint32_t(first[i + k])) * 4;
    };
    auto lower = [&](int k) __attribute__((always_inline)) {
      return upper(k) + size_t(uint32_t(levels.row(i + k))) * 4;
    };
    IntV corner[4];
    load_pairs(upper, corner[0], corner[1]);
    load_pairs(lower, corner[2], corner[3]);
    const IntV weight = load(wx + i);
    store(texel + i, lerp_bytes(load(wy + i), lerp_bytes(weight, corner[0], corner[1]),
                                lerp_bytes(weight, corner[2], corner[3])));
  }
}

/// texel += weight * (next - texel), bytewise.
static inline __attribute__((always_inline)) void
lerp_texels(const FragmentBlock& block, const uint32_t* weight, const uint32_t* next, uint32_t* texel) {
  for (int i = 0; i < block.lanes; i += kWidth)
    store(texel + i, lerp_bytes(load(weight + i), load(texel + i), load(next + i)));
}

template <class Levels>
static inline void sample_fixed_linear(const FragmentBlock& block, const BlockCoordinates& c,
                                       const TextureUnitConstants& t, const Levels& levels, uint32_t* texel) {
  alignas(64) int32_t x[kLanes], y[kLanes];
  alignas(64) uint32_t wx[kLanes], wy[kLanes];
  linear_axis(
      block, t, 0, c.s, [&](int i) { return levels.width(i); }, x, wx);
  linear_axis(
      block, t, 1, c.t, [&](int i) { return levels.height(i); }, y, wy);
  SOFTGL_FOR_LANES(block, i) x[i] += y[i] * levels.row(i);
  if (t.shape != TextureShape::ThreeD) {
    sample_fixed_square(block, levels, x, wx, wy, texel);
    return;
  }
  alignas(64) int32_t z[kLanes], first[kLanes];
  alignas(64) uint32_t wz[kLanes], next[kLanes];
  linear_axis(
      block, t, 2, c.r, [&](int i) { return levels.depth(i); }, z, wz);
  SOFTGL_FOR_LANES(block, i) first[i] = x[i] + z[i] * levels.slice(i);
  sample_fixed_square(block, levels, first, wx, wy, texel);
  SOFTGL_FOR_LANES(block, i)
  first[i] = x[i] + ((z[i] + 1) & mask_of(z[i] + 1 < levels.depth(i))) * levels.slice(i);
  sample_fixed_square(block, levels, first, wx, wy, next);
  lerp_texels(block, wz, next, texel);
}

template <class Levels> static inline void sample_fixed_nearest(const FragmentBlock& block,
                                                                const BlockCoordinates& c,
                                                                const TextureUnitConstants& t,
                                                                const Levels& levels, uint32_t* texel) {
  alignas(64) int32_t x[kLanes], y[kLanes];
  nearest_axis(
      block, t, 0, c.s, [&](int i) { return levels.width(i); }, x);
  nearest_axis(
      block, t, 1, c.t, [&](int i) { return levels.height(i); }, y);
  SOFTGL_FOR_LANES(block, i) x[i] += y[i] * levels.row(i);
  if (t.shape == TextureShape::ThreeD) {
    nearest_axis(
        block, t, 2, c.r, [&](int i) { return levels.depth(i); }, y);
    SOFTGL_FOR_LANES(block, i) x[i] += y[i] * levels.slice(i);
  }
  for (int i = 0; i < block.lanes; ++i)
    texel[i] = *reinterpret_cast<const AliasedWord*>(levels.texels(i) + size_t(uint32_t(x[i])) * 4);
}

/// One level (or level + 1) with one filter.
static inline void sample_fixed_level(const FragmentBlock& block, const BlockCoordinates& c,
                                      const TextureUnitConstants& t, const int32_t* level, int add,
                                      bool one_level, bool linear, uint32_t* texel) {
  if (one_level) {
    const FixedLevels<true> levels(block, c, t, level, add);
    linear ? sample_fixed_linear(block, c, t, levels, texel)
           : sample_fixed_nearest(block, c, t, levels, texel);
  } else {
    const FixedLevels<false> levels(block, c, t, level, add);
    linear ? sample_fixed_linear(block, c, t, levels, texel)
           : sample_fixed_nearest(block, c, t, levels, texel);
  }
}

/// The filtered texels of a block as packed bytes r g b a.
static inline void sample_fixed(const FragmentBlock& block, const BlockCoordinates& c,
                                const TextureUnitConstants& t, uint32_t* texel) {
  alignas(64) LaneLevels lod;
  const bool one_image = t.shape != TextureShape::Cube; // else every lane has a face
  if (t.mip == TextureMip::None && t.min_linear == t.mag_linear) {
    for (int i = 0; i < block.lanes; ++i) lod.level[i] = 0;
    sample_fixed_level(block, c, t, lod.level, 0, one_image, t.min_linear, texel);
    return;
  }
  find_levels(block, c, t, lod);
  // One level for all live lanes is the usual case. Dead lanes may be anywhere: they follow the others.
  alignas(64) uint32_t weight[kLanes];
  int first = 0;
  while (first < block.lanes - 1 && block.live[first] == 0) ++first;
  const int32_t reference = lod.level[first];
  IntV weights_ = IntV{}, magnified_ = IntV{}, minified_ = IntV{}, differs_ = IntV{};
  for (int32_t i = 0; i < block.lanes; i += kWidth) {
    const IntV live = load(block.live + i), w = truncate(load(lod.fraction + i) * 256.0f) & live,
               large = load(lod.magnified + i);
    store(weight + i, w | w << 16);
    weights_ |= w;
    magnified_ |= large & live;
    minified_ |= ~large & live;
    differs_ |= (load(lod.level + i) ^ splat(reference)) & live;
  }
  const bool weights = any(weights_), magnified = any(magnified_), minified = any(minified_),
             differs = any(differs_);
  const bool one_level = !differs && one_image;
  lod.level[0] = one_level ? reference : lod.level[0];
  const bool second = t.mip == TextureMip::Linear && weights;
  const bool mixed = t.min_linear != t.mag_linear;
  const bool minifies = !mixed || minified;
  if (minifies) {
    sample_fixed_level(block, c, t, lod.level, 0, one_level, t.min_linear, texel);
    if (second) {
      alignas(64) uint32_t next[kLanes];
      sample_fixed_level(block, c, t, lod.level, 1, one_level, t.min_linear, next);
      lerp_texels(block, weight, next, texel);
    }
  }
  if (mixed && magnified) {
    alignas(64) uint32_t other[kLanes];
    uint32_t* target = minifies ? other : texel;
    for (int i = 0; i < block.lanes; ++i) lod.level[i] = 0; // a magnified lane is at the base level
    sample_fixed_level(block, c, t, lod.level, 0, one_image, t.mag_linear, target);
    if (minifies) SOFTGL_FOR_LANES(block, i)
    texel[i] = (other[i] & uint32_t(lod.magnified[i])) | (texel[i] & ~uint32_t(lod.magnified[i]));
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
