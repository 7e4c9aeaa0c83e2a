#include "base/kernel_table.h"

namespace softgl {

#define SOFTGL_DECLARE_ISA(name) \
  namespace name { \
  extern const VertexKernels vertex_kernels; \
  extern const RasterKernels raster_kernels; \
  extern const TextureKernels texture_kernels; \
  }
#ifdef SOFTGL_HAVE_ISA_baseline
SOFTGL_DECLARE_ISA(baseline)
#else
#error "the baseline kernels must be built"
#endif
#ifdef SOFTGL_HAVE_ISA_v2
SOFTGL_DECLARE_ISA(v2)
#endif
#ifdef SOFTGL_HAVE_ISA_v3
SOFTGL_DECLARE_ISA(v3)
#endif
#ifdef SOFTGL_HAVE_ISA_v4
SOFTGL_DECLARE_ISA(v4)
#endif

const Kernels* find_kernels(Isa isa) {
#define SOFTGL_TABLE(name) \
  static constexpr Kernels table_##name = { \
    &name::vertex_kernels, \
    &name::raster_kernels, \
    &name::texture_kernels \
  }
  switch (isa) {
  case Isa::Baseline: {
    SOFTGL_TABLE(baseline);
    return &table_baseline;
  }
#ifdef SOFTGL_HAVE_ISA_v2
  case Isa::V2: {
    SOFTGL_TABLE(v2);
    return &table_v2;
  }
#endif
#ifdef SOFTGL_HAVE_ISA_v3
  case Isa::V3: {
    SOFTGL_TABLE(v3);
    return &table_v3;
  }
#endif
#ifdef SOFTGL_HAVE_ISA_v4
  case Isa::V4: {
    SOFTGL_TABLE(v4);
    return &table_v4;
  }
#endif
  default: return nullptr;
  }
}

const Kernels& kernels() {
  static const Kernels& table = *find_kernels(selected_isa());
  return table;
}

} // namespace softgl
