// Anisotropic filtering (GL_EXT_texture_filter_anisotropic) as in OSMesa 22.3.6: the texels under the ellipse
// that a pixel's circle becomes on one level, weighted by a Gaussian of their distance (P. Heckbert,
// Fundamentals of Texture Mapping and Image Warping, 1989, 3.5.8).
#pragma once

#include "shaders/texture/texture_float.inl"

namespace softgl {
namespace SOFTGL_ISA {

namespace { // so that no member is visible outside

constexpr int kEllipseWeights = 1024;

/// exp(-2 i / 1023) with six decimals.
struct EllipseWeights {
  float weight[kEllipseWeights] = {};
  constexpr EllipseWeights() {
    for (int i = 0; i < kEllipseWeights; ++i) {
      const float square = float(i) / float(kEllipseWeights - 1);
      const double x = -2.0 * double(square);
      double sum = 1;
      for (int n = 40; n > 0; --n) sum = 1 + x * sum / n;
      weight[i] = float(double(int32_t(double(float(sum)) * 1e6 + 0.5)) / 1e6);
    }
  }
};
constexpr EllipseWeights kEllipse;

} // namespace

/// What does not fit an int32_t becomes INT32_MIN.
static inline int32_t whole_number(float v) {
  return v >= -2147483648.0f && v < 2147483648.0f ? int32_t(v) : INT32_MIN;
}

/// The differences of s and t across the 2x2 quad of a lane.
struct QuadDifferences {
  float ds_dx, ds_dy, dt_dx, dt_dy;
};
static inline QuadDifferences quad_of(const BlockCoordinates& c, const TextureUnitConstants& t, int lane) {
  if (t.shape != TextureShape::Cube) return {c.ds_dx[lane], c.ds_dy[lane], c.dt_dx[lane], c.dt_dy[lane]};
  const int first = first_of_quad(lane); // OSMesa takes those on the faces, though they may be several
  return {c.s[first + 1] - c.s[first], c.s[first + 8] - c.s[first], c.t[first + 1] - c.t[first],
          c.t[first + 8] - c.t[first]};
}

/// The level whose texels are as long as the ellipse's shorter axis, whatever the greatest anisotropy is.
static inline int32_t ellipse_level(const TextureUnitConstants& t, const QuadDifferences& d) {
  if (t.mip == TextureMip::None) return 0;
  float lod = t.min_lod;
  if (!t.constant_lod) {
    const float w = float(t.level[0].width), h = float(t.level[0].height);
    const float sx = d.ds_dx * w, sy = d.ds_dy * w, tx = d.dt_dx * h, ty = d.dt_dy * h;
    const float x = sx * sx + tx * tx, y = sy * sy + ty * ty;
    lod = half_log2(select(mask_of(x < y), x, y)) + t.lod_bias;
    if (t.has_max_lod && !(lod < t.max_lod)) lod = t.max_lod;
    if (t.has_min_lod && !(lod > t.min_lod)) lod = t.min_lod;
  }
  return clamp_int(whole_number(lod), 0, t.last_level);
}

/// Texels on their way through a wrap mode: a block's lanes, all of one fragment.
struct EllipseTexels {
  static constexpr int kMost = kLanes;
  int32_t lanes = 0;
  alignas(64) float s[kMost], t[kMost], r[kMost], weight[kMost];
  alignas(64) int32_t width[kMost], height[kMost], depth[kMost];
  alignas(64) int32_t x[kMost], y[kMost], z[kMost];
};

/// Adds the weighted texels to `sum`, in order.
static inline void add_texels(const TextureUnitConstants& t, const TextureLevel& level, int face,
                              EllipseTexels& e, float sum[4], float& weights) {
  const int32_t count = e.lanes;
  e.lanes = (count + kStripLanes - 1) & ~(kStripLanes - 1);
  for (int i = count; i < e.lanes; ++i) e.s[i] = e.t[i] = 0;
  const bool three = t.shape == TextureShape::ThreeD;
  float_nearest_axis(e, t, 0, e.s, e.width, e.x);
  float_nearest_axis(e, t, 1, e.t, e.height, e.y);
  if (three) float_nearest_axis(e, t, 2, e.r, e.depth, e.z);
  for (int i = 0; i < count; ++i) {
    float v[4];
    fetch_float(t, level, face, e.x[i], e.y[i], three ? e.z[i] : 0, v);
    for (int k = 0; k < 4; ++k) sum[k] = sum[k] + v[k] * e.weight[i];
    weights = weights + e.weight[i];
  }
  e.lanes = 0;
}

/// Ellipses in larger boxes are filtered without anisotropy, lest a pixel takes forever.
constexpr int64_t kMostEllipseBox = 1 << 16;

/// The mean of the texels under the ellipse of a lane on level number `l`; false: there are none.
static inline bool sample_ellipse(const BlockCoordinates& c, const TextureUnitConstants& t, int lane,
                                  int32_t l, const QuadDifferences& d, EllipseTexels& e, float out[4]) {
  const TextureLevel& level = t.level[l];
  const int32_t number = t.first_level + l; // sizes are those of level 0, divided, not cut to whole numbers
  const float scale = 1.0f / float(int32_t(1) << number);
  const float zero_width = float(t.zero_width), zero_height = float(t.zero_height);
  const float ux = d.ds_dx * zero_width * scale, uy = d.ds_dy * zero_width * scale,
              vx = d.dt_dx * zero_height * scale, vy = d.dt_dy * zero_height * scale;
  // A u^2 + B u v + C v^2 = F around the ellipse.
  float A = (vx * vx + vy * vy) + 1.0f, B = (ux * vx + uy * vy) * -2.0f, C = (ux * ux + uy * uy) + 1.0f;
  const float F = A * C - B * B / 4.0f;
  const float D = (0.0f - B * B) + (A * C) * 4.0f;
  const float half_width = (2.0f / D) * __builtin_sqrtf((D * C) * F),
              half_height = (2.0f / D) * __builtin_sqrtf((A * D) * F);
  const float form = float(kEllipseWeights - 1) / F;
  A *= form, B *= form, C *= form;
  const float center_u = c.s[lane] * (zero_width * scale) + -0.5f,
              center_v = c.t[lane] * (zero_height * scale) + -0.5f;
  // Texels beyond 2^30, and what is no number, have no neighbors.
  const float far = 1073741824.0f;
  if (!(absolute(center_u) + half_width < far && absolute(center_v) + half_height < far)) return false;
  const int32_t u0 = whole_number(floor_of(center_u - half_width)),
                u1 = whole_number(-floor_of(-(center_u + half_width))),
                v0 = whole_number(floor_of(center_v - half_height)),
                v1 = whole_number(-floor_of(-(center_v + half_height)));
  const int64_t columns = int64_t(u1) - u0 + 1, rows = int64_t(v1) - v0 + 1;
  if (columns <= 0 || rows <= 0 || columns > kMostEllipseBox || rows > kMostEllipseBox ||
      columns * rows > kMostEllipseBox)
    return false;
  for (int i = 0; i < kLanes; ++i) {
    e.r[i] = c.r[lane];
    e.width[i] = level.width, e.height[i] = level.height, e.depth[i] = level.depth;
  }
  const int face = t.shape == TextureShape::Cube ? face_of(c, lane) : 0;
  const float width = float(level.width), height = float(level.height);
  const float U = float(u0) - center_u, second_step = A * 2.0f;
  const float first_step = (U * 2.0f + 1.0f) * A, first = (U * U) * A;
  float sum[4] = {}, weights = 0;
  for (int64_t row = 0; row < rows; ++row) {
    const float v = float(int32_t(v0 + row)), V = v - center_v;
    float step = V * B + first_step, q = (C * V + B * U) * V + first;
    for (int64_t column = 0; column < columns; ++column, q += step, step += second_step) {
      const int32_t distance = whole_number(q);
      if (distance >= kEllipseWeights) continue;
      const int i = e.lanes++;
      e.weight[i] = kEllipse.weight[distance > 0 ? distance : 0];
      e.s[i] = float(int32_t(u0 + column)) / width, e.t[i] = v / height;
      if (e.lanes == EllipseTexels::kMost) add_texels(t, level, face, e, sum, weights);
    }
  }
  add_texels(t, level, face, e, sum, weights);
  if (weights == 0.0f) return false;
  for (int k = 0; k < 4; ++k) out[k] = sum[k] / weights;
  return true;
}

/// The filtered texels of a block; dead lanes get none.
static inline void sample_anisotropic(const FragmentBlock& block, const BlockCoordinates& c,
                                      const TextureUnitConstants& t, FloatTexels& out) {
  alignas(64) int32_t level[kLanes], empty[kLanes];
  int32_t any_empty = 0;
  EllipseTexels texels;
  for (int i = 0; i < block.lanes; ++i) {
    level[i] = empty[i] = 0;
    for (int k = 0; k < 4; ++k) out.v[k][i] = 0;
    const QuadDifferences d = quad_of(c, t, i);
    level[i] = ellipse_level(t, d);
    if (!block.live[i]) continue;
    float v[4];
    if (sample_ellipse(c, t, i, level[i], d, texels, v)) {
      for (int k = 0; k < 4; ++k) out.v[k][i] = v[k];
    } else {
      any_empty |= empty[i] = -1;
    }
  }
  if (!any_empty) return;
  FloatTexels linear;
  sample_float_level(block, c, t, level, 0, true, nullptr, linear);
  choose_texels(block, empty, linear, out);
}

} // namespace SOFTGL_ISA
} // namespace softgl
