// Linear filtering across the edges of a cube map's faces (GL_ARB_seamless_cube_map).
#pragma once

#include "shaders/texture/texture_cube.inl"
#include "shaders/texture/texture_fetch.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// A component of (s, t, r) on which a face's coordinate grows or falls.
struct FaceAxis {
  int8_t component, sign;
};
/// The axes of a face's coordinates (GL 1.5, table 3.21).
struct FaceAxes {
  FaceAxis across, down;
};
constexpr FaceAxes kFaceAxes[6] = {{{2, -1}, {1, -1}}, {{2, 1}, {1, -1}}, {{0, 1}, {2, 1}},
                                   {{0, 1}, {2, -1}},  {{0, 1}, {1, -1}}, {{0, -1}, {1, -1}}};

struct CubeTexel {
  int32_t face, x, y;
};

/// The texel of an n x n face; of one beside it that of the neighboring face; of one beyond a corner, which
/// there is not, one near it.
static inline CubeTexel across_edges(CubeTexel texel, int32_t n) {
  const bool beside_x = texel.x < 0 || texel.x >= n, beside_y = texel.y < 0 || texel.y >= n;
  if (!beside_x && !beside_y) return texel;
  const FaceAxes& from = kFaceAxes[texel.face];
  const int major = texel.face >> 1, outward = texel.face & 1 ? -1 : 1;
  if (beside_x && beside_y) texel.y = clamp_int(texel.y, 0, n - 1);
  // The texel's center, in half texels from the center of the cube, on the face that the edge leads to: it is
  // in its outermost row.
  const FaceAxis over = beside_x ? from.across : from.down, along = beside_x ? from.down : from.across;
  const int32_t outside = beside_x ? texel.x : texel.y, inside = beside_x ? texel.y : texel.x;
  const int next_outward = (outside < 0 ? -1 : 1) * over.sign;
  int32_t center[3];
  center[major] = outward * (n - 1);
  center[over.component] = next_outward * n;
  center[along.component] = along.sign * (2 * inside + 1 - n);
  const int32_t face = over.component * 2 + (next_outward < 0);
  const auto coordinate = [&](const FaceAxis& axis) {
    return (axis.sign * center[axis.component] + n - 1) / 2;
  };
  return {face, coordinate(kFaceAxes[face].across), coordinate(kFaceAxes[face].down)};
}

/// The two texels along an axis, beside the face where they are, and the weight of the second.
static inline void seamless_axis(const FragmentBlock& block, const float* __restrict coordinate,
                                 const int32_t* __restrict sizes, FloatAxis& out) {
  SOFTGL_FOR_LANES(block, i) {
    const float u = maximum(coordinate[i], 0.0f) * float(sizes[i]) - 0.5f;
    out.first[i] = floor_to_int(u);
    out.second[i] = out.first[i] + 1;
    out.weight[i] = u - floor_of(u);
  }
}

/// Component k of texel n (00, 10, 01, 11 in x and y) of each lane.
struct FourTexels {
  alignas(64) float v[4][4][kLanes];
};

typedef int32_t AliasedTexel __attribute__((may_alias));

/// Texel (x, y) of four bytes.
static inline const AliasedTexel* texel_word(const TextureLevel& level, int32_t face, int32_t x, int32_t y) {
  return reinterpret_cast<const AliasedTexel*>(level.face[face]) + size_t(y) * size_t(level.row) + size_t(x);
}

/// Where `beside` is negative a texel of the lane is beside the lane's face.
static inline void fetch_seamless(const FragmentBlock& block, const BlockCoordinates& c,
                                  const TextureUnitConstants& t, const TextureLevel* const* level,
                                  const FloatAxis& x, const FloatAxis& y, const int32_t* beside,
                                  FourTexels& out) {
  const auto texel = [&](int32_t i, int n) {
    const CubeTexel own{face_of(c, i), n & 1 ? x.second[i] : x.first[i], n & 2 ? y.second[i] : y.first[i]};
    return beside[i] < 0 ? across_edges(own, level[i]->width) : own;
  };
  if (t.texel != TextureTexel::Rgba8) {
    for (int n = 0; n < 4; ++n)
      for (int32_t i = 0; i < block.lanes; ++i) {
        const CubeTexel from = texel(i, n);
        float v[4];
        fetch_float(t, *level[i], from.face, from.x, from.y, 0, v);
        for (int k = 0; k < 4; ++k) out.v[n][k][i] = v[k];
      }
    return;
  }
  alignas(64) int32_t word[4][kLanes];
  for (int32_t i = 0; i < block.lanes; ++i) {
    if (!block.live[i]) { // of a quad that has others
      for (int n = 0; n < 4; ++n) word[n][i] = 0;
      continue;
    }
    if (beside[i] < 0) {
      for (int n = 0; n < 4; ++n) {
        const CubeTexel from = texel(i, n);
        word[n][i] = *texel_word(*level[i], from.face, from.x, from.y);
      }
      continue;
    }
    const AliasedTexel* upper = texel_word(*level[i], face_of(c, i), x.first[i], y.first[i]);
    const AliasedTexel* lower = upper + level[i]->row;
    word[0][i] = upper[0], word[1][i] = upper[1], word[2][i] = lower[0], word[3][i] = lower[1];
  }
  for (int n = 0; n < 4; ++n)
    for (int k = 0; k < 4; ++k) {
      const int shift = 8 * k + t.shift[k];
      const int32_t mask = 255 >> t.shift[k];
      const float scale = t.scale[k];
      const int32_t* __restrict from = word[n];
      float* __restrict to = out.v[n][k];
      SOFTGL_FOR_LANES(block, i) to[i] = float(int32_t(uint32_t(from[i]) >> shift) & mask) * scale;
    }
}

/// As sample_float_level(), of a cube map with linear filtering. Operation order as in OSMesa 22.3.6: where
/// one lane of a quad looks at a corner of the cube, its quad adds weighted texels instead of interpolating,
/// and the weight of the texel that is not there goes to the other three.
static inline void sample_seamless_level(const FragmentBlock& block, const BlockCoordinates& c,
                                         const TextureUnitConstants& t, const TextureLevel* const* level,
                                         const int32_t* size, const int32_t* nearest, FloatTexels& out) {
  FloatAxis x, y;
  seamless_axis(block, c.s, size, x);
  seamless_axis(block, c.t, size, y);
  for (int i = 0; nearest && i < block.lanes; ++i)
    if (nearest[i]) x.weight[i] = x.weight[i] > 0.5f, y.weight[i] = y.weight[i] > 0.5f;
  alignas(64) int32_t beside[kLanes];
  int32_t corners = 0; // negative if there is one
  SOFTGL_FOR_LANES(block, i) {
    const int32_t beside_x = x.first[i] | (size[i] - 1 - x.second[i]),
                  beside_y = y.first[i] | (size[i] - 1 - y.second[i]);
    beside[i] = beside_x | beside_y;
    corners |= beside_x & beside_y;
  }
  FourTexels texels;
  fetch_seamless(block, c, t, level, x, y, beside, texels);
  const auto& v = texels.v;
  for (int k = 0; k < 4; ++k) {
    float* __restrict result = out.v[k];
    SOFTGL_FOR_LANES(block, i) {
      const float upper = x.weight[i] * (v[1][k][i] - v[0][k][i]) + v[0][k][i],
                  lower = x.weight[i] * (v[3][k][i] - v[2][k][i]) + v[2][k][i];
      result[i] = y.weight[i] * (lower - upper) + upper;
    }
  }
  if (corners >= 0) return;
  alignas(64) int32_t missing[kLanes]; // the number of the texel beyond a corner, or -1
  for (int i = 0; i < block.lanes; ++i) {
    const bool left = x.first[i] < 0, right = x.second[i] >= size[i];
    const bool top = y.first[i] < 0, bottom = y.second[i] >= size[i];
    missing[i] = left && top ? 0 : right && top ? 1 : left && bottom ? 2 : right && bottom ? 3 : -1;
  }
  for (int i = 0; i < block.lanes; ++i) {
    const int32_t* quad = missing + first_of_quad(i);
    if ((quad[0] & quad[1] & quad[8] & quad[9]) == -1) continue;
    const float wx = x.weight[i], wy = y.weight[i];
    float weight[4] = {(1.0f - wx) * (1.0f - wy), wx * (1.0f - wy), (1.0f - wx) * wy, wx * wy};
    const float share = missing[i] < 0 ? 0.0f : weight[missing[i]] * (1.0f / 3.0f);
    for (int n = 0; n < 4; ++n) weight[n] = n == missing[i] ? 0.0f : weight[n] + share;
    for (int k = 0; k < 4; ++k)
      out.v[k][i] = weight[3] * v[3][k][i] +
                    (weight[2] * v[2][k][i] + (weight[1] * v[1][k][i] + weight[0] * v[0][k][i]));
    if (t.no_alpha) out.v[3][i] = 1.0f;
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
