#include "context/vertex_array_objects.h"

#include <utility>

#include "context/context.h"

namespace softgl {

void bind_vertex_array(Context& c, const std::shared_ptr<VertexArrayObject>& object) {
  VertexArrayState& state = c.client.vertex_array;
  if (object == state.bound) return;
  const auto place = [&](const std::shared_ptr<VertexArrayObject>& o) -> VertexArrays& {
    return o ? o->arrays : c.client.unbound_arrays;
  };
  VertexArrays& arrays = state;
  place(state.bound) = std::move(arrays);
  arrays = std::move(place(object));
  state.bound = object;
  c.dirty |= kDirtyArrays;
}

} // namespace softgl
