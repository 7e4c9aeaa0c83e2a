// One attribute of one vertex, wherever it lies.
#pragma once

#include "shaders/common/vertex_attributes.h"

namespace softgl {

/// The four components of element `vertex`, converted as the vertex kernels convert them.
void fetch_vertex(const AttributeStream& stream, uint32_t vertex, float out[4]);

} // namespace softgl
