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

/// A strip of a block's lanes, for loops over lanes. The compiler shall not see how many there are: it would
/// unroll the loops instead of vectorising them.
struct StripOfLanes {
  int32_t lanes;
};

/// The differences of s and t across the 2x2 quads of a strip's lanes.
struct QuadDifferences {
  alignas(64) float ds_dx[kStripLanes], ds_dy[kStripLanes], dt_dx[kStripLanes], dt_dy[kStripLanes];

  QuadDifferences(const StripOfLanes& e, const BlockCoordinates& c, const TextureUnitConstants& t,
                  int strip) {
    if (t.shape != TextureShape::Cube) {
      SOFTGL_FOR_LANES(e, i) {
        ds_dx[i] = c.ds_dx[strip + i], ds_dy[i] = c.ds_dy[strip + i];
        dt_dx[i] = c.dt_dx[strip + i], dt_dy[i] = c.dt_dy[strip + i];
      }
      return;
    }
    SOFTGL_FOR_LANES(e, i) {
      const int first =
          first_of_quad(strip + i); // OSMesa takes those on the faces, though they may be several
      ds_dx[i] = c.s[first + 1] - c.s[first], ds_dy[i] = c.s[first + 8] - c.s[first];
      dt_dx[i] = c.t[first + 1] - c.t[first], dt_dy[i] = c.t[first + 8] - c.t[first];
    }
  }
};

/// The levels whose texels are as long as the ellipse's shorter axis, whatever the greatest anisotropy is.
static inline void find_ellipse_levels(const StripOfLanes& e, const TextureUnitConstants& t,
                                       const QuadDifferences& d, int32_t* __restrict level) {
  if (t.mip == TextureMip::None || t.constant_lod) {
    const int32_t l = t.mip == TextureMip::None ? 0 : clamp_int(int32_t(t.min_lod), 0, t.last_level);
    SOFTGL_FOR_LANES(e, i) level[i] = l;
    return;
  }
  const float w = float(t.level[0].width), h = float(t.level[0].height), bias = t.lod_bias;
  const float low = t.min_lod, high = t.max_lod;
  const int32_t below = -int32_t(t.has_min_lod), above = -int32_t(t.has_max_lod), last = t.last_level;
  SOFTGL_FOR_LANES(e, i) {
    const float sx = d.ds_dx[i] * w, sy = d.ds_dy[i] * w, tx = d.dt_dx[i] * h, ty = d.dt_dy[i] * h;
    float lod = half_log2(minimum(sx * sx + tx * tx, sy * sy + ty * ty)) + bias;
    lod = select(above & ~mask_of(lod < high), high, lod);
    lod = select(below & ~mask_of(lod > low), low, lod);
    level[i] = clamp_int(int32_t(lod), 0, last);
  }
}

/// Ceiling as an integer; what does not fit an int32_t becomes INT32_MIN.
static inline __attribute__((always_inline)) int32_t ceiling_to_int(float a) {
  return int32_t(0u - uint32_t(floor_to_int(-a)));
}

/// Ellipses in larger boxes are filtered without anisotropy, lest a pixel takes forever.
constexpr int32_t kMostEllipseBox = 1 << 16;

/// The ellipses of a strip's lanes on their levels: boxes of columns x rows texels from (u0, v0) on around
/// centers, and the form A u^2 + B u v + C v^2, which is kEllipseWeights - 1 around an ellipse. No rows:
/// none.
struct Ellipses {
  alignas(64) float A[kStripLanes], B[kStripLanes], C[kStripLanes];
  alignas(64) float center_u[kStripLanes], center_v[kStripLanes];
  alignas(64) int32_t u0[kStripLanes], v0[kStripLanes], columns[kStripLanes], rows[kStripLanes];

  Ellipses(const StripOfLanes& e, const TextureUnitConstants& t, const float* __restrict s_,
           const float* __restrict t_, const uint32_t* __restrict live, const int32_t* __restrict level,
           const QuadDifferences& d) {
    const float zero_width = float(t.zero_width), zero_height = float(t.zero_height);
    const int32_t first_level = t.first_level;
    SOFTGL_FOR_LANES(e, i) {
      // Sizes are those of level 0, divided, not cut to whole numbers.
      const float scale = bits_float((127 - first_level - level[i]) << 23);
      const float ux = d.ds_dx[i] * zero_width * scale, uy = d.ds_dy[i] * zero_width * scale,
                  vx = d.dt_dx[i] * zero_height * scale, vy = d.dt_dy[i] * zero_height * scale;
      const float a = (vx * vx + vy * vy) + 1.0f, b = (ux * vx + uy * vy) * -2.0f,
                  c = (ux * ux + uy * uy) + 1.0f;
      const float F = a * c - b * b / 4.0f;
      const float D = (0.0f - b * b) + (a * c) * 4.0f;
      const float half_width = (2.0f / D) * __builtin_sqrtf((D * c) * F),
                  half_height = (2.0f / D) * __builtin_sqrtf((a * D) * F);
      const float form = float(kEllipseWeights - 1) / F;
      A[i] = a * form, B[i] = b * form, C[i] = c * form;
      const float u = s_[i] * (zero_width * scale) + -0.5f, v = t_[i] * (zero_height * scale) + -0.5f;
      center_u[i] = u, center_v[i] = v;
      // Texels beyond 2^30, and what is no number, have no neighbors. Half a box is at most half of
      // kMostEllipseBox; the bound leaves room for rounding, and keeps the differences in 32 bits.
      const float far = 1073741824.0f, wide = float(kMostEllipseBox);
      const int32_t left = floor_to_int(u - half_width), right = ceiling_to_int(u + half_width),
                    top = floor_to_int(v - half_height), bottom = ceiling_to_int(v + half_height);
      const int32_t near = mask_of(absolute(u) + half_width < far) &
                           mask_of(absolute(v) + half_height < far) & mask_of(half_width < wide) &
                           mask_of(half_height < wide);
      const int32_t across = ((right & near) - (left & near) + 1),
                    down = ((bottom & near) - (top & near) + 1);
      const int32_t has = int32_t(live[i]) & near & mask_of(across > 0) & mask_of(down > 0) &
                          mask_of(across <= kMostEllipseBox) & mask_of(down <= kMostEllipseBox) &
                          mask_of(float(across) * float(down) <= wide);
      u0[i] = left & has, v0[i] = top & has, columns[i] = across & has, rows[i] = down & has;
    }
  }
};

/// Sums of weighted texels, and of weights.
struct EllipseSums {
  alignas(64) float v[4][kStripLanes] = {}, weight[kStripLanes] = {};
};

/// The greatest of the strip's numbers where the mask is set, or 0.
static inline int32_t greatest(const StripOfLanes& e, const int32_t* numbers, const int32_t* mask) {
  int32_t most = 0;
  SOFTGL_FOR_LANES(e, i) {
    const int32_t n = numbers[i] & mask[i];
    most = select(mask_of(n > most), n, most);
  }
  return most;
}

/// Adds the texels under the ellipses, row by row. r is the third texture coordinate.
static inline void sum_ellipses(const StripOfLanes& e, const TextureUnitConstants& t, ImageOfEach images,
                                const float* r, const Ellipses& ellipses, EllipseSums& sum) {
  const bool three = t.shape == TextureShape::ThreeD;
  alignas(64) int32_t x[kLanes], y[kLanes], z[kLanes], all[kStripLanes], in_row[kStripLanes],
      takes[kStripLanes];
  alignas(64) float s[kLanes], q[kStripLanes], step[kStripLanes], v[kStripLanes], weight[kStripLanes];
  if (three) float_nearest_axis(e, t, 2, r, images.depth, z);
  SOFTGL_FOR_LANES(e, i) all[i] = -1;
  TexelRows texel_rows;
  TexelPlaces at;
  FloatTexels texel;
  const int32_t rows = greatest(e, ellipses.rows, all);
  for (int32_t row = 0; row < rows; ++row) {
    SOFTGL_FOR_LANES(e, i) {
      in_row[i] = mask_of(row < ellipses.rows[i]);
      v[i] = float(ellipses.v0[i] + row);
      const float V = v[i] - ellipses.center_v[i], U = float(ellipses.u0[i]) - ellipses.center_u[i];
      const float first_step = (U * 2.0f + 1.0f) * ellipses.A[i], first = (U * U) * ellipses.A[i];
      step[i] = V * ellipses.B[i] + first_step;
      q[i] = (ellipses.C[i] * V + ellipses.B[i] * U) * V + first;
      v[i] = v[i] / float(images.height[i]);
    }
    float_nearest_axis(e, t, 1, v, images.height, y);
    find_rows(e, images, y, three ? z : nullptr, texel_rows);
    const int32_t columns = greatest(e, ellipses.columns, in_row);
    for (int32_t column = 0; column < columns; ++column) {
      int32_t some = 0;
      SOFTGL_FOR_LANES(e, i) {
        const int32_t distance = int32_t(q[i]);
        takes[i] = in_row[i] & mask_of(column < ellipses.columns[i]) & mask_of(distance < kEllipseWeights);
        some |= takes[i];
        x[i] = clamp_int(distance, 0, kEllipseWeights - 1);
        q[i] += step[i];
        step[i] += ellipses.A[i] * 2.0f;
      }
      if (some == 0) continue;
      for (int32_t i = 0; i < e.lanes; i += kWidth) {
        const auto place = [&](int k) __attribute__((always_inline)) { return kEllipse.weight + x[i + k]; };
        store(weight + i, (FloatV)load_words(place));
      }
      SOFTGL_FOR_LANES(e, i) s[i] = float(ellipses.u0[i] + column) / float(images.width[i]);
      float_nearest_axis(e, t, 0, s, images.width, x);
      find_texels(e, images, texel_rows, x, at);
      fetch_texels(e, t, images, at, texel);
      for (int k = 0; k < 4; ++k) SOFTGL_FOR_LANES(e, i)
      sum.v[k][i] = select(takes[i], sum.v[k][i] + texel.v[k][i] * weight[i], sum.v[k][i]);
      SOFTGL_FOR_LANES(e, i) sum.weight[i] += keep(takes[i], weight[i]);
    }
  }
}

/// The filtered texels of a block; dead lanes get none.
static inline void sample_anisotropic(const FragmentBlock& block, const BlockCoordinates& c,
                                      const TextureUnitConstants& t, FloatTexels& out) {
  alignas(64) int32_t level[kLanes], empty[kLanes];
  int32_t any_empty = 0;
  for (int strip = 0; strip < block.lanes; strip += kStripLanes) {
    const StripOfLanes e{block.lanes - strip < kStripLanes ? block.lanes - strip : kStripLanes};
    const QuadDifferences differences(e, c, t, strip);
    find_ellipse_levels(e, t, differences, level + strip);
    const Ellipses ellipses(e, t, c.s + strip, c.t + strip, block.live + strip, level + strip, differences);
    LevelImages images;
    for (int i = strip; i < strip + kStripLanes; ++i)
      images.set(i - strip, t.level[level[i]], t.shape == TextureShape::Cube ? face_of(c, i) : 0);
    EllipseSums sum;
    sum_ellipses(e, t, images.view(), c.r + strip, ellipses, sum);
    for (int i = strip; i < strip + kStripLanes; ++i) {
      empty[i] = int32_t(block.live[i]) & mask_of(sum.weight[i - strip] == 0.0f);
      any_empty |= empty[i];
      for (int k = 0; k < 4; ++k)
        out.v[k][i] = keep(mask_of(block.live[i] != 0), sum.v[k][i - strip] / sum.weight[i - strip]);
    }
  }
  if (!any_empty) return;
  FloatTexels linear;
  sample_float_level(block, c, t, level, 0, true, nullptr, linear);
  choose_texels(block, empty, linear, out);
}

} // namespace SOFTGL_ISA
} // namespace softgl
