#include "fragment/fragment_stages.h"

#include "base/kernel_table.h"

namespace softgl {

void append_fragment_stages(FragmentProgram& program) {
  const FragmentKey& key = program.key;
  const RasterKernels& k = *kernels().raster;
  if (key.color_sum) program.add(key.lit ? k.color_sum_clamped : k.color_sum);
  switch (static_cast<FogMode>(key.fog_mode)) {
  case FogMode::None: break;
  case FogMode::Linear: program.add(k.fog_linear); break;
  case FogMode::Exp: program.add(k.fog_exp); break;
  case FogMode::Exp2: program.add(k.fog_exp2); break;
  }
  if (static_cast<Compare>(key.alpha_function) != Compare::Always)
    program.add(static_cast<ColorFormat>(key.color_format) == ColorFormat::Rgba8 ? k.alpha_test_8
                                                                                 : k.alpha_test_float,
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
