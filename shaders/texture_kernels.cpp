// The table of the texture kernels of one instruction set.
#include "isa.h"
#include "kernels.h"

namespace softgl {
namespace SOFTGL_ISA {

extern const TextureKernels texture_kernels;
const TextureKernels texture_kernels = {
    .isa = SOFTGL_STRING(SOFTGL_ISA),
};

} // namespace SOFTGL_ISA
} // namespace softgl
