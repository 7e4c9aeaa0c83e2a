// The kernels of the selected instruction set.
#pragma once

#include "base/cpu_features.h"
#include "shaders/kernels.h"

namespace softgl {

struct Kernels {
  const VertexKernels* vertex;
  const RasterKernels* raster;
  const TextureKernels* texture;
};

/// The kernels of one instruction set; null when this build does not have it. The caller must know that the
/// processor supports it (detect_isa).
const Kernels* find_kernels(Isa isa);
/// The kernels of selected_isa().
const Kernels& kernels();

} // namespace softgl
