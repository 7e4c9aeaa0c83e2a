// Until geometry is built: draws nothing.
#include "geometry/geometry.h"

namespace softgl {

__attribute__((weak)) void shade_vertices(const DrawRecord&, uint32_t, uint32_t, const ShadedVertices&) {}
__attribute__((weak)) void assemble(const DrawRecord&, const ShadedVertices&, const PrimitiveRange&, uint32_t, uint32_t, Arena&, PrimitiveSink&) {}

} // namespace softgl
