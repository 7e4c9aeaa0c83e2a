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

/// Component k of texel n (00, 10, 01, 11 in x and y) of each lane. Where `beside` is negative a texel of the
/// lane is beside the lane's face.
static inline void fetch_seamless(const FragmentBlock& block, const BlockCoordinates& c,
                                  const TextureUnitConstants& t, const LevelImages& images,
                                  const FloatAxis& x, const FloatAxis& y, const int32_t* beside,
                                  FloatTexels out[4]) {
  const unsigned char* texels[kLanes];
  ImageOfEach elsewhere = images.view();
  elsewhere.texels = texels;
  TexelRows rows;
  TexelPlaces at;
  for (int n = 0; n < 4; ++n) {
    const int32_t *column = n & 1 ? x.second : x.first, *row = n & 2 ? y.second : y.first;
    find_rows(block, images.view(), row, nullptr, rows);
    find_texels(block, images.view(), rows, column, at);
    SOFTGL_FOR_LANES(block, i) at.inside[i] = -1;
    SOFTGL_FOR_LANES(block, i) texels[i] = images.texels[i];
    for (int32_t i = 0; i < block.lanes; i += kWidth)
      for (uint32_t lanes = sign_bits(load(beside + i) & load(block.live + i)); lanes != 0;
           lanes &= lanes - 1) {
        const int32_t lane = i + __builtin_ctz(lanes);
        const CubeTexel from = across_edges({face_of(c, lane), column[lane], row[lane]}, images.width[lane]);
        texels[lane] = images.level[lane]->face[from.face];
        at.index[lane] = uint32_t(from.y * images.row[lane] + from.x);
      }
    fetch_texels(block, t, elsewhere, at, out[n]);
  }
}

/// As sample_float_level(), of a cube map with linear filtering. Operation order as in OSMesa 22.3.6: where
/// one lane of a quad looks at a corner of the cube, its quad adds weighted texels instead of interpolating,
/// and the weight of the texel that is not there goes to the other three.
static inline void sample_seamless_level(const FragmentBlock& block, const BlockCoordinates& c,
                                         const TextureUnitConstants& t, const LevelImages& images,
                                         const int32_t* nearest, FloatTexels& out) {
  const int32_t* __restrict size = images.width;
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
  FloatTexels texels[4];
  fetch_seamless(block, c, t, images, x, y, beside, texels);
  for (int k = 0; k < 4; ++k) {
    float* __restrict result = out.v[k];
    SOFTGL_FOR_LANES(block, i) {
      const float upper = x.weight[i] * (texels[1].v[k][i] - texels[0].v[k][i]) + texels[0].v[k][i],
                  lower = x.weight[i] * (texels[3].v[k][i] - texels[2].v[k][i]) + texels[2].v[k][i];
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
      out.v[k][i] =
          weight[3] * texels[3].v[k][i] +
          (weight[2] * texels[2].v[k][i] + (weight[1] * texels[1].v[k][i] + weight[0] * texels[0].v[k][i]));
    if (t.no_alpha) out.v[3][i] = 1.0f;
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
