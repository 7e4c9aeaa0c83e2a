#include "snapshot/diagonal.h"

#include <algorithm>

#include "base/kernel_table.h"
#include "shaders/fragment/fragment_program.h"
#include "shaders/texture/combiner_program.h"

namespace softgl {
namespace {

bool reads_colors(const CombinerProgram& program) {
  const auto color = [](uint8_t value) { return value >= kCombinerPrimary && value < kCombinerConstant; };
  return std::any_of(program.result, program.result + 4, color) ||
         std::any_of(program.step, program.step + program.step_count,
                     [&](const CombinerStep& step) { return color(step.a) || color(step.b); });
}

/// False if textures take the place of the primary colors.
bool reads_colors(const FragmentProgram& program) {
  const TextureKernels& textures = *kernels().texture;
  for (int i = 0; i < program.step_count; ++i) {
    const FragmentStage stage = program.step[i].stage;
    if (stage == textures.replace) return false;
    if (stage == textures.combine) return reads_colors(*program.constants->combiner);
    if (stage == textures.modulate || stage == textures.modulate_fixed) return true;
  }
  return true;
}

/// Whether fragments take a color from a vertex. One that is the same over the draw is none of a vertex.
bool reads_colors_of_vertices(const Context& c, const DrawCall& call, const FragmentProgram& program) {
  const auto varies = [&](int slot) { return c.state.lighting.enabled || call.source->present >> slot & 1; };
  return (varies(kColor) && reads_colors(program)) || (varies(kSecondaryColor) && program.key.secondary);
}

} // namespace

Diagonal diagonal_of_quadrilaterals(const Context& c, const DrawCall& call, const FragmentProgram& program) {
  const bool flat = program.key.flat;
  if (!c.osmesa_quadrilaterals) return flat ? Diagonal::From1To3 : Diagonal::From0To2;
  if (call.indices || call.from_list || (flat && reads_colors_of_vertices(c, call, program)))
    return Diagonal::From1To3;
  return Diagonal::Unclipped02;
}

} // namespace softgl
