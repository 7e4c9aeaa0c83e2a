// Cube map textures (GL 1.5, 3.8.6): the stage before sampling turns s, t, r into a face and coordinates on
// it.
#pragma once

#include "shaders/fragment/fragment_constants.h"
#include "shaders/texture/texture_constants.h"
#include "shaders/texture/texture_lanes.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Of programs that read quads: the lanes of the quad of a lane are first, +1, +8, +9.
static inline int32_t first_of_quad(int32_t lane) { return lane & ~9; }

/// What choose_face leaves in r.
static inline int32_t face_of(const BlockCoordinates& c, int32_t lane) { return int32_t(c.r[lane]); }

/// Of three values the one of the major axis; ties prefer r to t, t to s (OSMesa 22.3.6).
struct MajorAxis {
  int32_t s, r; // masks
  MajorAxis(float s_, float t_, float r_)
      : s(mask_of(absolute(s_) > absolute(t_))),
        r(mask_of(absolute(r_) >= maximum(absolute(s_), absolute(t_)))) {}
  float operator()(float of_s, float of_t, float of_r) const {
    return select(r, of_r, select(s, of_s, of_t));
  }
};

static inline float flip(int32_t sign, float v) { return bits_float(float_bits(v) ^ sign); }

/// s, t and r become a face and coordinates on it; if they are read, the differences of s, t and r become
/// those of the coordinates.
template <bool ReadsDifferences>
static inline void find_faces(const FragmentBlock& block, BlockCoordinates& c) {
  const int32_t minus = int32_t(0x80000000u);
  SOFTGL_FOR_LANES(block, i) {
    const float v[3] = {c.s[i], c.t[i], c.r[i]};
    const MajorAxis major(v[0], v[1], v[2]);
    const float axis = major(v[0], v[1], v[2]);
    const int32_t sign = float_bits(axis) & minus;
    auto across = [&](const float* a) { return major(flip(sign ^ minus, a[2]), a[0], flip(sign, a[0])); };
    auto down = [&](const float* a) { return major(-a[1], flip(sign, a[2]), -a[1]); };
    const float inverse = 1.0f / axis, half = 0.5f * inverse;
    const float sc = across(v), tc = down(v);
    if constexpr (ReadsDifferences) {
      const float dx[3] = {c.ds_dx[i], c.dt_dx[i], c.dr_dx[i]};
      const float dy[3] = {c.ds_dy[i], c.dt_dy[i], c.dr_dy[i]};
      const float growth_x = major(dx[0], dx[1], dx[2]) * inverse,
                  growth_y = major(dy[0], dy[1], dy[2]) * inverse;
      c.ds_dx[i] = (across(dx) - growth_x * sc) * half;
      c.dt_dx[i] = (down(dx) - growth_x * tc) * half;
      c.ds_dy[i] = (across(dy) - growth_y * sc) * half;
      c.dt_dy[i] = (down(dy) - growth_y * tc) * half;
    }
    const int32_t no_axis = mask_of(axis == 0.0f);
    c.s[i] = select(no_axis, 0.5f, sc * absolute(half) + 0.5f);
    c.t[i] = select(no_axis, 0.5f, tc * absolute(half) + 0.5f);
    c.r[i] = major(0, 2, 4) + keep(sign >> 31, 1.0f);
  }
}

/// Differences are those of the lane's own row and column of its quad, because the quad may lie on several
/// faces. Without mipmaps, when they only choose between two filters, the quad's first lane decides for all.
static void choose_face(FragmentBlock& block, const FragmentConstants& constants, int unit) {
  const TextureUnitConstants& t = *constants.texture[unit];
  BlockCoordinates& c = block.unit[unit];
  if (!t.reads_differences()) return find_faces<false>(block, c);
  find_faces<true>(block, c);
  if (t.mip != TextureMip::None) return;
  for (int32_t i = 0; i < block.lanes; ++i) {
    const int32_t first = first_of_quad(i);
    c.ds_dx[i] = c.ds_dx[first], c.dt_dx[i] = c.dt_dx[first];
    c.ds_dy[i] = c.ds_dy[first], c.dt_dy[i] = c.dt_dy[first];
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
