// ArrayElement (GL 1.5, 2.8): a vertex from the arrays, as if it had been given call by call.
#pragma once

#include <cstdint>

namespace softgl {

struct Context;
struct ArrayCache;

/// Sets the attributes of element `index` and, if there are positions, gives the vertex.
void emit_array_element(Context& context, const ArrayCache& arrays, uint32_t index);

} // namespace softgl
