// Sampling in float: wide formats, and the wrap modes that fixed point does not cover. Operation order as in
// OSMesa 22.3.6: coordinate * size - 0.5, weight = fraction, lerp = w * (b - a) + a along x, then y, then z,
// then levels.
#pragma once

#include "shaders/texture/texture_lod.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Two texel numbers and the weight of the second. Numbers outside the image mean the border.
struct FloatAxis {
  alignas(64) int32_t first[kLanes], second[kLanes];
  alignas(64) float weight[kLanes];
};

/// 2 * |s / 2 - round(s / 2)|: one period of mirrored repetition.
static inline __attribute__((always_inline)) float mirror(float s) {
  const float half = s * 0.5f;
  const float r = __builtin_rintf(half);
  const float d = half - r;
  return absolute(d + d);
}

static inline void float_linear_axis(const FragmentBlock& block, const TextureUnitConstants& t, int axis,
                                     const float* coordinate, const int32_t* sizes, FloatAxis& out) {
  const TextureWrap wrap = t.wrap[axis];
  for (int i = 0; i < block.lanes; ++i) {
    const int32_t n = sizes[i];
    const float size = float(n), scale = t.counts_texels ? 1.0f : size, s = coordinate[i];
    float u;
    int32_t x, next;
    switch (wrap) {
    case TextureWrap::RepeatPowerOfTwo:
      u = s * size - 0.5f;
      x = floor_to_int(u);
      out.weight[i] = u - floor_of(u);
      out.first[i] = x & (n - 1);
      out.second[i] = int32_t(uint32_t(x) + 1) & (n - 1);
      continue;
    case TextureWrap::Repeat:
      u = (s - floor_of(s)) * size - 0.5f;
      x = floor_to_int(u);
      out.weight[i] = u - floor_of(u);
      x = u < 0.0f ? n - 1 : clamp_int(x, 0, n - 1);
      out.first[i] = x;
      out.second[i] = x == n - 1 ? 0 : x + 1;
      continue;
    case TextureWrap::ClampToEdge:
      u = s * scale;
      u = u < size ? u : size;
      u = u - 0.5f;
      u = u > 0.0f ? u : 0.0f;
      x = int32_t(u);
      out.weight[i] = u - float(x);
      out.first[i] = x;
      out.second[i] = clamp_int(x + 1, 0, n - 1);
      continue;
    case TextureWrap::Clamp:
      u = s * scale;
      u = u < size ? u : size;
      u = u > 0.0f ? u : 0.0f;
      u = u - 0.5f;
      break;
    case TextureWrap::ClampToBorder: u = s * scale - 0.5f; break;
    default: // MirroredRepeat
      u = mirror(s);
      u = (u > 0.0f ? u : 0.0f) * size - 0.5f;
      x = floor_to_int(u);
      out.weight[i] = u - floor_of(u);
      next = x + 1;
      out.first[i] = x > 0 ? x : 0;
      out.second[i] = next < n - 1 ? next : n - 1;
      continue;
    }
    x = floor_to_int(u);
    out.weight[i] = u - floor_of(u);
    out.first[i] = x;
    out.second[i] = int32_t(uint32_t(x) + 1);
  }
}

static inline void float_nearest_axis(const FragmentBlock& block, const TextureUnitConstants& t, int axis,
                                      const float* coordinate, const int32_t* sizes, int32_t* out) {
  const TextureWrap wrap = t.wrap[axis];
  const float below_one = 0.999999940395355224609375f;
  for (int i = 0; i < block.lanes; ++i) {
    const int32_t n = sizes[i];
    const float size = float(n), scale = t.counts_texels ? 1.0f : size, s = coordinate[i];
    switch (wrap) {
    case TextureWrap::RepeatPowerOfTwo: out[i] = floor_to_int(s * size) & (n - 1); break;
    case TextureWrap::Repeat: {
      const float f = s - floor_of(s);
      out[i] = clamp_int(int32_t((f < below_one ? f : below_one) * size), 0, n - 1);
      break;
    }
    case TextureWrap::ClampToEdge:
    case TextureWrap::Clamp: out[i] = clamp_int(int32_t(s * scale), 0, n - 1); break;
    case TextureWrap::ClampToBorder: out[i] = floor_to_int(s * scale); break;
    default: {
      const float m = mirror(s);
      out[i] = clamp_int(int32_t((m > 0.0f ? m : 0.0f) * size), 0, n - 1);
    }
    }
  }
}

/// One texel as floats; the border outside.
static inline void fetch_float(const TextureUnitConstants& t, const TextureLevel& level, int face, int32_t x,
                               int32_t y, int32_t z, float* rgba) {
  if (x < 0 || x >= level.width || y < 0 || y >= level.height || z < 0 || z >= level.depth) {
    for (int k = 0; k < 4; ++k) rgba[k] = t.border[k];
    return;
  }
  const size_t index = size_t(z) * size_t(level.slice) + size_t(y) * size_t(level.row) + size_t(x);
  if (t.texel == TextureTexel::Rgba8) {
    const unsigned char* p = level.face[face] + index * 4;
    for (int k = 0; k < 4; ++k) rgba[k] = float(int32_t(p[k] >> t.shift[k])) * t.scale[k];
  } else if (t.texel == TextureTexel::Rgba16) {
    typedef uint16_t AliasedHalf __attribute__((may_alias));
    const AliasedHalf* p = reinterpret_cast<const AliasedHalf*>(level.face[face] + index * 8);
    for (int k = 0; k < 4; ++k) rgba[k] = float(int32_t(p[k])) * t.scale[k];
  } else {
    typedef uint32_t AliasedDepth __attribute__((may_alias));
    const uint32_t v = *reinterpret_cast<const AliasedDepth*>(level.face[face] + index * 4);
    // 32 bits do not fit a float: OSMesa keeps the upper 23.
    const float wide = (bits_float(int32_t((v >> 9) | 0x3f800000u)) - 1.0f) * 1.00000011920930376163766f;
    const float d = t.texel == TextureTexel::DepthFloat ? bits_float(int32_t(v))
                    : t.shift[0] == 32                  ? wide
                                                        : float(int32_t(v)) * t.scale[0];
    rgba[0] = rgba[1] = rgba[2] = d;
    rgba[3] = 1;
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

struct FloatTexels {
  alignas(64) float v[4][kLanes];
};

/// `nearest`, if there is one: lanes whose linear filter takes the texel of the greater weight alone.
static inline void sample_float_level(const FragmentBlock& block, const BlockCoordinates& c,
                                      const TextureUnitConstants& t, const int32_t* levels, int add,
                                      bool linear, const int32_t* nearest, FloatTexels& out) {
  alignas(64) int32_t width[kLanes], height[kLanes], depth[kLanes];
  const TextureLevel* level[kLanes];
  for (int i = 0; i < block.lanes; ++i) {
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
