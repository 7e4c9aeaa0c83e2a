// The table of the texture kernels of one instruction set.
#include "shaders/common/isa.h"
#include "shaders/kernels.h"
#include "shaders/texture/texture_anisotropic.inl"
#include "shaders/texture/texture_environment.inl"
#include "shaders/texture/texture_fixed.inl"
#include "shaders/texture/texture_float.inl"

namespace softgl {
namespace SOFTGL_ISA {

static void sample_fixed_stage(FragmentBlock& block, const FragmentConstants& constants, int unit) {
  alignas(64) uint32_t texel[kLanes];
  sample_fixed(block, block.unit[unit], *constants.texture[unit], texel);
  const UnitTexels out(block, unit);
  const float scale = 1.0f / 255.0f;
  SOFTGL_FOR_LANES(block, i) {
    const uint32_t v = texel[i];
    out.v[0][i] = float(int32_t(v & 255)) * scale;
    out.v[1][i] = float(int32_t(v >> 8 & 255)) * scale;
    out.v[2][i] = float(int32_t(v >> 16 & 255)) * scale;
    out.v[3][i] = float(int32_t(v >> 24)) * scale;
  }
}

/// Sampling and MODULATE in one pass.
static void modulate_fixed_stage(FragmentBlock& block, const FragmentConstants& constants, int unit) {
  alignas(64) uint32_t texel[kLanes];
  sample_fixed(block, block.unit[unit], *constants.texture[unit], texel);
  const float scale = 1.0f / 255.0f;
  float *r = block.color[0], *g = block.color[1], *b = block.color[2], *a = block.color[3];
  SOFTGL_FOR_LANES(block, i) {
    const uint32_t v = texel[i];
    r[i] = (float(int32_t(v & 255)) * scale) * r[i];
    g[i] = (float(int32_t(v >> 8 & 255)) * scale) * g[i];
    b[i] = (float(int32_t(v >> 16 & 255)) * scale) * b[i];
    a[i] = (float(int32_t(v >> 24)) * scale) * a[i];
  }
}

/// Leaves filtered texels where the environments read them.
static void put_texels(FragmentBlock& block, const TextureUnitConstants& t, int unit, FloatTexels& texel) {
  if (is_depth(t.texel)) {
    for (int k = 3; k >= 0; --k) { // the depths are in the first
      const int32_t takes = -(t.depth_components >> k & 1);
      SOFTGL_FOR_LANES(block, i) texel.v[k][i] = select(takes, texel.v[0][i], k == 3 ? 1.0f : 0.0f);
    }
  }
  const UnitTexels out(block, unit);
  for (int k = 0; k < 4; ++k) SOFTGL_FOR_LANES(block, i) out.v[k][i] = texel.v[k][i];
}

static void sample_float_stage(FragmentBlock& block, const FragmentConstants& constants, int unit) {
  FloatTexels texel;
  sample_float(block, block.unit[unit], *constants.texture[unit], texel);
  put_texels(block, *constants.texture[unit], unit, texel);
}

static void sample_anisotropic_stage(FragmentBlock& block, const FragmentConstants& constants, int unit) {
  FloatTexels texel;
  sample_anisotropic(block, block.unit[unit], *constants.texture[unit], texel);
  put_texels(block, *constants.texture[unit], unit, texel);
}

static void drop_shadowed_stage(FragmentBlock& block, const FragmentConstants&, int unit) {
  const float* __restrict alpha = UnitTexels(block, unit).v[3];
  SOFTGL_FOR_LANES(block, i) block.live[i] &= uint32_t(mask_of(alpha[i] != 0.0f));
}

extern const TextureKernels texture_kernels;
const TextureKernels texture_kernels = {
    .isa = SOFTGL_STRING(SOFTGL_ISA),
    .choose_face = choose_face,
    .sample_fixed = sample_fixed_stage,
    .modulate_fixed = modulate_fixed_stage,
    .sample_float = sample_float_stage,
    .sample_anisotropic = sample_anisotropic_stage,
    .drop_shadowed = drop_shadowed_stage,
    .replace = environment_replace,
    .modulate = environment_modulate,
    .combine = environment_combine,
};

} // namespace SOFTGL_ISA
} // namespace softgl
