#include "fragment/fragment_stages.h"

#include "base/kernel_table.h"

namespace softgl {

namespace {

/// OSMesa 22.3.6 compares alpha as it is stored where the components are four bytes, the last of them unused
/// or not.
bool stores_alpha_bytes(const FragmentProgram& program) {
  const uint8_t* bits = program.constants->encoding.bits;
  return static_cast<ColorFormat>(program.key.color_format) == ColorFormat::Rgba8 && bits[0] == 8 &&
         bits[1] == 8 && bits[2] == 8;
}

} // namespace

void append_fragment_stages(FragmentProgram& program, bool clamp, bool clamp_sum) {
  const FragmentKey& key = program.key;
  const RasterKernels& k = *kernels().raster;
  if (key.color_sum) program.add(key.lit ? k.color_sum_clamped : k.color_sum);
  if (clamp_sum && static_cast<FogMode>(key.fog_mode) != FogMode::None) program.add(k.clamp_color);
  switch (static_cast<FogMode>(key.fog_mode)) {
  case FogMode::None: break;
  case FogMode::Linear: program.add(k.fog_linear); break;
  case FogMode::Exp: program.add(k.fog_exp); break;
  case FogMode::Exp2: program.add(k.fog_exp2); break;
  }
  if (clamp) program.add(k.clamp_color);
  if (static_cast<Compare>(key.alpha_function) != Compare::Always)
    program.add(stores_alpha_bytes(program) ? k.alpha_test_8 : k.alpha_test_float,
                static_cast<int32_t>(key.alpha_function));
}

FragmentProgram with_coverage(const FragmentProgram& program, Coverage coverage) {
  const RasterKernels& k = *kernels().raster;
  FragmentProgram smooth = program;
  smooth.coverage = coverage;
  const bool tests = static_cast<Compare>(program.key.alpha_function) != Compare::Always;
  if (tests) --smooth.step_count;
  smooth.add(coverage == Coverage::Point  ? k.point_coverage
             : coverage == Coverage::Line ? k.line_coverage
                                          : k.polygon_coverage);
  if (tests) {
    const FragmentStep& test = program.step[program.step_count - 1];
    smooth.add(test.stage, test.unit);
  }
  return smooth;
}

} // namespace softgl
