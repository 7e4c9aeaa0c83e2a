// Sampling in float: wide formats, and the wrap modes that fixed point does not cover. Operation order as in
// OSMesa 22.3.6: coordinate * size - 0.5, weight = fraction, lerp = w * (b - a) + a along x, then y, then z,
// then levels.
#pragma once

#include "shaders/texture/texture_fetch.inl"
#include "shaders/texture/texture_lod.inl"
#include "shaders/texture/texture_seamless.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// 2 * |s / 2 - round(s / 2)|: one period of mirrored repetition.
static inline __attribute__((always_inline)) float mirror(float s) {
  const float half = s * 0.5f;
  const float r = __builtin_rintf(half);
  const float d = half - r;
  return absolute(d + d);
}

/// The weight of the second texel is the fraction of `u`, which counts texels; the first is the texel below.
static inline __attribute__((always_inline)) void floor_axis(FloatAxis& out, int32_t i, float u) {
  out.first[i] = floor_to_int(u);
  out.weight[i] = u - floor_of(u);
}

static inline void float_linear_axis(const FragmentBlock& block, const TextureUnitConstants& t, int axis,
                                     const float* __restrict coordinate, const int32_t* __restrict sizes,
                                     FloatAxis& out) {
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
    for (int32_t i = 0; i < block.lanes; ++i) {
      floor_axis(out, i, maximum(mirror(coordinate[i]), 0.0f) * float(sizes[i]) - 0.5f);
      const int32_t x = out.first[i], next = x + 1;
      out.first[i] = x > 0 ? x : 0;
      out.second[i] = next < sizes[i] - 1 ? next : sizes[i] - 1;
    }
  }
}

template <class Lanes>
static inline void float_nearest_axis(const Lanes& block, const TextureUnitConstants& t, int axis,
                                      const float* __restrict coordinate, const int32_t* __restrict sizes,
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
    for (int32_t i = 0; i < block.lanes; ++i)
      out[i] = clamp_int(int32_t(maximum(mirror(coordinate[i]), 0.0f) * float(sizes[i])), 0, sizes[i] - 1);
  }
}

/// r is clamped as the texels are, unless they are floats (GL_ARB_depth_buffer_float, 3.8.14).
static inline float compared_r(const TextureUnitConstants& t, float r) {
  return t.texel == TextureTexel::DepthFloat ? r : saturate(r);
}

/// r FUNC texel: 1 or 0 (3.8.14).
static inline bool depth_passes(uint8_t function, float r, float texel) {
  switch (function) {
  case 0: return false;
  case 1: return r < texel;
  case 2: return r == texel;
  case 3: return r <= texel;
  case 4: return r > texel;
  case 5: return r != texel;
  case 6: return r >= texel;
  default: return true;
  }
}

/// Depth textures without a filter: shadows. 1 where r passes the comparison with the texel, else 0.
static inline void compare_nearest_level(const FragmentBlock& block, const BlockCoordinates& c,
                                         const TextureUnitConstants& t, const TextureLevel* const* level,
                                         const int32_t* x, const int32_t* y, FloatTexels& out) {
  alignas(64) float texel[kLanes];
  alignas(64) uint32_t word[kLanes];
  alignas(64) int32_t inside[kLanes];
  for (int i = 0; i < block.lanes; ++i) {
    const TextureLevel& l = *level[i];
    inside[i] = mask_of(uint32_t(x[i]) < uint32_t(l.width)) & mask_of(uint32_t(y[i]) < uint32_t(l.height));
    const size_t row = size_t(y[i] & inside[i]) * size_t(l.row);
    word[i] = depth_word(l, 0, row + size_t(x[i] & inside[i]));
  }
  const float border = t.border[0];
  const auto decode = [&](auto depth) {
    SOFTGL_FOR_LANES(block, i) texel[i] = select(inside[i], depth(word[i]), border);
  };
  if (t.texel == TextureTexel::DepthFloat)
    decode([](uint32_t v) { return bits_float(int32_t(v)); });
  else if (t.shift[0] == 32)
    decode([](uint32_t v) { return wide_depth(v); });
  else
    decode([scale = t.scale[0]](uint32_t v) { return float(int32_t(v)) * scale; });
  const auto compare = [&](auto passes) {
    SOFTGL_FOR_LANES(block, i) {
      const float one = keep(mask_of(passes(compared_r(t, c.r[i]), texel[i])), 1.0f);
      for (int k = 0; k < 4; ++k) out.v[k][i] = one;
    }
  };
  switch (t.compare_function) {
  case 0: return compare([](float, float) { return false; });
  case 1: return compare([](float r, float d) { return r < d; });
  case 2: return compare([](float r, float d) { return r == d; });
  case 3: return compare([](float r, float d) { return r <= d; });
  case 4: return compare([](float r, float d) { return r > d; });
  case 5: return compare([](float r, float d) { return r != d; });
  case 6: return compare([](float r, float d) { return r >= d; });
  default: return compare([](float, float) { return true; });
  }
}

/// `nearest`, if there is one: lanes whose linear filter takes the texel of the greater weight alone.
static inline void sample_float_level(const FragmentBlock& block, const BlockCoordinates& c,
                                      const TextureUnitConstants& t, const int32_t* levels, int add,
                                      bool linear, const int32_t* nearest, FloatTexels& out) {
  if (block.lanes <= 0) __builtin_unreachable(); // the arrays below are filled
  alignas(64) int32_t width[kLanes], height[kLanes], depth[kLanes];
  const TextureLevel* level[kLanes];
  SOFTGL_FOR_LANES(block, i) {
    int32_t l = levels[i] + add;
    l = l > t.last_level ? t.last_level : l;
    level[i] = &t.level[l];
    width[i] = level[i]->width, height[i] = level[i]->height, depth[i] = level[i]->depth;
  }
  const bool two = t.shape != TextureShape::OneD, three = t.shape == TextureShape::ThreeD,
             cube = t.shape == TextureShape::Cube;
  if (!linear) {
    alignas(64) int32_t x[kLanes], y[kLanes], z[kLanes];
    float_nearest_axis(block, t, 0, c.s, width, x);
    if (two) float_nearest_axis(block, t, 1, c.t, height, y);
    if (three) float_nearest_axis(block, t, 2, c.r, depth, z);
    if (t.compares && t.shape == TextureShape::TwoD)
      return compare_nearest_level(block, c, t, level, x, y, out);
    for (int i = 0; i < block.lanes; ++i) {
      float v[4];
      fetch_float(t, *level[i], cube ? face_of(c, i) : 0, x[i], two ? y[i] : 0, three ? z[i] : 0, v);
      if (t.compares)
        v[0] = v[1] = v[2] = v[3] =
            depth_passes(t.compare_function, compared_r(t, c.r[i]), v[0]) ? 1.0f : 0.0f;
      for (int k = 0; k < 4; ++k) out.v[k][i] = v[k];
    }
    return;
  }
  if (t.seamless) return sample_seamless_level(block, c, t, level, width, nearest, out);
  FloatAxis x, y, z;
  float_linear_axis(block, t, 0, c.s, width, x);
  if (two) float_linear_axis(block, t, 1, c.t, height, y);
  if (three) float_linear_axis(block, t, 2, c.r, depth, z);
  for (int i = 0; nearest && i < block.lanes; ++i)
    if (nearest[i]) x.weight[i] = x.weight[i] > 0.5f, y.weight[i] = y.weight[i] > 0.5f;
  for (int i = 0; i < block.lanes; ++i) {
    float plane[2][4];
    for (int b = 0; b < (three ? 2 : 1); ++b) {
      const int32_t slice = three ? (b ? z.second[i] : z.first[i]) : 0;
      float line[2][4];
      for (int a = 0; a < (two ? 2 : 1); ++a) {
        const int32_t row = two ? (a ? y.second[i] : y.first[i]) : 0;
        const int face = cube ? face_of(c, i) : 0;
        float v0[4], v1[4];
        fetch_float(t, *level[i], face, x.first[i], row, slice, v0);
        fetch_float(t, *level[i], face, x.second[i], row, slice, v1);
        if (t.compares) {
          // The comparisons are filtered, as masked weights.
          const float r = compared_r(t, c.r[i]), w = x.weight[i];
          const float p0 = depth_passes(t.compare_function, r, v0[0]) ? 1.0f - w : 0.0f;
          const float p1 = depth_passes(t.compare_function, r, v1[0]) ? w : 0.0f;
          for (int k = 0; k < 4; ++k) line[a][k] = p1 + p0;
        } else {
          for (int k = 0; k < 4; ++k) line[a][k] = x.weight[i] * (v1[k] - v0[k]) + v0[k];
        }
      }
      for (int k = 0; k < 4; ++k)
        plane[b][k] = two ? y.weight[i] * (line[1][k] - line[0][k]) + line[0][k] : line[0][k];
    }
    for (int k = 0; k < 4; ++k)
      out.v[k][i] = three ? z.weight[i] * (plane[1][k] - plane[0][k]) + plane[0][k] : plane[0][k];
  }
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
