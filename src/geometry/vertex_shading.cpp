#include "base/assert.h"
#include "base/kernel_table.h"
#include "geometry/geometry.h"
#include "geometry/vertex_job.h"

namespace softgl {

VertexJob make_vertex_job(const DrawRecord& draw) {
  static_assert(sizeof(Vec4) == sizeof(float[4]));
  const DrawCall& call = draw.call;
  return {draw.vertex,
          draw.layout,
          call.source->present,
          call.source->stream,
          reinterpret_cast<const float(*)[4]>(call.constant),
          call.first_vertex + call.vertex_count};
}

ShadedVertices* allocate_vertices(const DrawRecord& draw, uint32_t first, uint32_t count, Arena& arena) {
  auto* v = arena.make<ShadedVertices>();
  v->first = first;
  v->count = count;
  const size_t rounded = (size_t(count) + 63) & ~size_t(63);
  v->slot = static_cast<ShadedVertices::Slot*>(
      arena.allocate(rounded * draw.layout.slots * sizeof(ShadedVertices::Slot) + 64));
  v->clip_mask = arena.allocate_array<uint16_t>(rounded + 32);
  return v;
}

uint16_t shade_vertices(const DrawRecord& draw, uint32_t first, uint32_t count, const ShadedVertices& out,
                        bool leave_clipped) {
  const VertexJob job = make_vertex_job(draw);
  const uint32_t offset = first - out.first;
  SOFTGL_ASSERT(first >= out.first && offset % 64 == 0 && uint64_t(offset) + count <= out.count);
  SOFTGL_ASSERT(first >= draw.call.first_vertex && uint64_t(first) + count <= job.end);
  return kernels().vertex->shade(job, first, count, out.slot + size_t(offset) * draw.layout.slots,
                                 out.clip_mask + offset, leave_clipped);
}

} // namespace softgl
