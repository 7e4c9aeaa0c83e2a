// The table of the raster kernels of one instruction set.
#include "isa.h"
#include "kernels.h"

namespace softgl {
namespace SOFTGL_ISA {

extern const RasterKernels raster_kernels;
const RasterKernels raster_kernels = {
    .isa = SOFTGL_STRING(SOFTGL_ISA),
};

} // namespace SOFTGL_ISA
} // namespace softgl
