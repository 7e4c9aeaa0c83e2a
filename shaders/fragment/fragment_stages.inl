// Stages behind texturing: color sum, fog, alpha test.
#pragma once

#include "shaders/common/exp_log.inl"
#include "shaders/fragment/fragment_pack.inl"
#include "shaders/fragment/fragment_program.h"

namespace softgl {
namespace SOFTGL_ISA {

/// Runs the stages of a block. With an alpha test they end early where no lane lives on; then what they leave
/// in the block means nothing.
SOFTGL_INLINE void run_stages(const FragmentProgram& program, FragmentBlock& block) {
  const bool drops = Compare(program.key.alpha_function) != Compare::Always;
  for (int i = 0; i < program.step_count; ++i) {
    program.step[i].stage(block, *program.constants, program.step[i].unit);
    if (!drops) continue;
    IntV live = IntV{};
    for (int lane = 0; lane < block.lanes; lane += kWidth) live |= load(block.live + lane);
    if (!any(live)) return;
  }
}

/// GL 1.5, 3.9. Not clamped here, as in OSMesa 22.3.6: only the fogged color is.
static void stage_color_sum(FragmentBlock& block, const FragmentConstants&, int) {
  const int lanes = block.lanes;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < lanes; ++i) block.color[c][i] = block.color[c][i] + block.secondary[c][i];
}

/// The sum of lit fragments, clamped as GL 1.5, 3.9 says.
static void stage_color_sum_clamped(FragmentBlock& block, const FragmentConstants&, int) {
  const int lanes = block.lanes;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < lanes; ++i) block.color[c][i] = saturate(block.color[c][i] + block.secondary[c][i]);
}

/// GL 1.5, 3.10: f in [0,1] mixes the color with the fog color; alpha stays.
SOFTGL_INLINE void mix_fog(FragmentBlock& block, const FragmentConstants& constants, const float* factor) {
  const int lanes = block.lanes;
  for (int c = 0; c < 3; ++c) {
    const float fog = constants.fog_color[c];
    for (int i = 0; i < lanes; ++i) {
      const float f = factor[i];
      block.color[c][i] = fog * (1.0f - f) + block.color[c][i] * f;
    }
  }
}

static void stage_fog_linear(FragmentBlock& block, const FragmentConstants& constants, int) {
  alignas(64) float f[kLanes];
  const int lanes = block.lanes;
  const float scale = constants.fog_scale, offset = constants.fog_offset;
  for (int i = 0; i < lanes; ++i) f[i] = saturate(block.fog[i] * scale + offset);
  mix_fog(block, constants, f);
}

static void stage_fog_exp(FragmentBlock& block, const FragmentConstants& constants, int) {
  alignas(64) float f[kLanes];
  const int lanes = block.lanes;
  const float scale = constants.fog_scale;
  for (int i = 0; i < lanes; ++i) f[i] = saturate(exp2_lane(-(block.fog[i] * scale)));
  mix_fog(block, constants, f);
}

static void stage_fog_exp2(FragmentBlock& block, const FragmentConstants& constants, int) {
  alignas(64) float f[kLanes];
  const int lanes = block.lanes;
  const float scale = constants.fog_scale;
  for (int i = 0; i < lanes; ++i) {
    const float t = block.fog[i] * scale;
    f[i] = saturate(exp2_lane(-(t * t)));
  }
  mix_fog(block, constants, f);
}

/// GL_CLAMP_FRAGMENT_COLOR (GL_ARB_color_buffer_float).
static void stage_clamp_color(FragmentBlock& block, const FragmentConstants&, int) {
  const int lanes = block.lanes;
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < lanes; ++i) block.color[c][i] = saturate(block.color[c][i]);
}

/// GL_ARB_depth_clamp: depths stay within those of glDepthRange.
static void stage_clamp_depth(FragmentBlock& block, const FragmentConstants& constants, int) {
  const int lanes = block.lanes;
  const auto least = int32_t(constants.least_depth), greatest = int32_t(constants.greatest_depth);
  for (int i = 0; i < lanes; ++i) {
    const auto depth = int32_t(block.depth[i]);
    const int32_t raised = select(mask_of(depth < least), least, depth);
    block.depth[i] = uint32_t(select(mask_of(raised > greatest), greatest, raised));
  }
}

/// Compares in place: live[i] stays where value[i] `function` reference holds.
template <class T>
SOFTGL_INLINE void keep_if(Compare function, uint32_t* live, const T* value, T reference, int lanes) {
  switch (function) {
  case Compare::Never:
    for (int i = 0; i < lanes; ++i) live[i] = 0;
    break;
  case Compare::Less:
    for (int i = 0; i < lanes; ++i) live[i] &= uint32_t(mask_of(value[i] < reference));
    break;
  case Compare::Equal:
    for (int i = 0; i < lanes; ++i) live[i] &= uint32_t(mask_of(value[i] == reference));
    break;
  case Compare::LessEqual:
    for (int i = 0; i < lanes; ++i) live[i] &= uint32_t(mask_of(value[i] <= reference));
    break;
  case Compare::Greater:
    for (int i = 0; i < lanes; ++i) live[i] &= uint32_t(mask_of(value[i] > reference));
    break;
  case Compare::NotEqual:
    for (int i = 0; i < lanes; ++i) live[i] &= uint32_t(mask_of(value[i] != reference));
    break;
  case Compare::GreaterEqual:
    for (int i = 0; i < lanes; ++i) live[i] &= uint32_t(mask_of(value[i] >= reference));
    break;
  case Compare::Always: break;
  }
}

/// GL 1.5, 4.1.4. OSMesa 22.3.6 compares the alpha that an 8-bit buffer would store; floats for other
/// buffers.
static void stage_alpha_test_8(FragmentBlock& block, const FragmentConstants& constants, int unit) {
  alignas(64) int32_t alpha[kLanes];
  for (int i = 0; i < block.lanes; i += kWidth) store(alpha + i, color_byte(load(block.color[3] + i)));
  keep_if<int32_t>(Compare(unit), block.live, alpha, constants.alpha_reference_8, block.lanes);
}

static void stage_alpha_test_float(FragmentBlock& block, const FragmentConstants& constants, int unit) {
  keep_if<float>(Compare(unit), block.live, block.color[3], constants.alpha_reference, block.lanes);
}

} // namespace SOFTGL_ISA
} // namespace softgl
