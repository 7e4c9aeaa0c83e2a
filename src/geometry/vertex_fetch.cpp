#include "geometry/vertex_fetch.h"

#include "shaders/vertex/component_conversion.h"

namespace softgl {

void fetch_vertex(const AttributeStream& s, uint32_t vertex, float out[4]) {
  const unsigned char* p = s.data + size_t(vertex) * s.stride;
  for (int c = 0; c < 4; ++c)
    out[c] = c < s.components ? convert_component(p, s.type, s.normalized, c) : c == 3 ? 1.0f : 0.0f;
}

} // namespace softgl
