// The table of the vertex kernels of one instruction set.
#include "shaders/common/isa.h"
#include "shaders/kernels.h"
#include "shaders/vertex/vertex_shade.inl"

namespace softgl {
namespace SOFTGL_ISA {

extern const VertexKernels vertex_kernels;
const VertexKernels vertex_kernels = {
    .isa = SOFTGL_STRING(SOFTGL_ISA),
    .shade = shade_vertices,
};

} // namespace SOFTGL_ISA
} // namespace softgl
