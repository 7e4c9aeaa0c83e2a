// Cube map textures (GL 1.5, 3.8.6): the stage before sampling turns s, t, r into a face and coordinates on
// it.
#pragma once

#include "shaders/fragment/fragment_constants.h"
#include "shaders/texture/texture_constants.h"
#include "shaders/texture/texture_lanes.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Blocks of programs with cube maps are strips of 8x2 pixels; the lanes of the quad of a lane are first, +1,
/// +8, +9.
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

/// The differences on the face come from those of s, t and r: those of the lane's own row and column of its
/// quad, because the quad may lie on several faces. Without mipmaps, when they only choose between two
/// filters, the quad's first lane decides for all.
static void choose_face(FragmentBlock& block, const FragmentConstants& constants, int unit) {
  const TextureUnitConstants& t = *constants.texture[unit];
  BlockCoordinates& c = block.unit[unit];
  const int32_t minus = int32_t(0x80000000u);
  const bool whole_quad = t.mip == TextureMip::None;
  alignas(64) float face_s[kLanes], face_t[kLanes], face[kLanes];
  for (int32_t i = 0; i < block.lanes; ++i) {
    const float v[3] = {c.s[i], c.t[i], c.r[i]};
    const MajorAxis major(v[0], v[1], v[2]);
    const float axis = major(v[0], v[1], v[2]);
    const int32_t sign = float_bits(axis) & minus;
    auto across = [&](const float* a) { return major(flip(sign ^ minus, a[2]), a[0], flip(sign, a[0])); };
    auto down = [&](const float* a) { return major(-a[1], flip(sign, a[2]), -a[1]); };
    face[i] = major(0, 2, 4) + (sign ? 1.0f : 0.0f);
    const float inverse = 1.0f / axis, half = 0.5f * inverse;
    const float sc = across(v), tc = down(v);
    face_s[i] = axis == 0.0f ? 0.5f : sc * absolute(half) + 0.5f;
    face_t[i] = axis == 0.0f ? 0.5f : tc * absolute(half) + 0.5f;
    const int32_t row = i & ~1, column = i & ~8;
    const float dx[3] = {c.s[row + 1] - c.s[row], c.t[row + 1] - c.t[row], c.r[row + 1] - c.r[row]};
    const float dy[3] = {c.s[column + 8] - c.s[column], c.t[column + 8] - c.t[column],
                         c.r[column + 8] - c.r[column]};
    const float growth_x = major(dx[0], dx[1], dx[2]) * inverse,
                growth_y = major(dy[0], dy[1], dy[2]) * inverse;
    c.ds_dx[i] = (across(dx) - growth_x * sc) * half;
    c.dt_dx[i] = (down(dx) - growth_x * tc) * half;
    c.ds_dy[i] = (across(dy) - growth_y * sc) * half;
    c.dt_dy[i] = (down(dy) - growth_y * tc) * half;
  }
  for (int32_t i = 0; i < block.lanes; ++i) {
    c.s[i] = face_s[i], c.t[i] = face_t[i], c.r[i] = face[i];
    if (!whole_quad) continue;
    const int32_t first = first_of_quad(i);
    c.ds_dx[i] = c.ds_dx[first], c.dt_dx[i] = c.dt_dx[first];
    c.ds_dy[i] = c.ds_dy[first], c.dt_dy[i] = c.dt_dy[first];
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
