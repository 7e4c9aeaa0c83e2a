#include "frame/planned_vertices.h"

#include <algorithm>

#include "base/fast_paths.h"
#include "base/thread_pool.h"

namespace softgl {
namespace {

constexpr uint32_t kShadeChunk = 2048; // vertices shaded at a time; a multiple of 64

void leave(ShadedVertices& vertices) {
  vertices.clipped = true;
  count_as_taken(FastPath::ClippedDraws);
}

} // namespace

const ShadedVertices* PlannedVertices::add(const DrawRecord& draw, Arena& arena) {
  const uint32_t begin = draw.call.first_vertex, count = draw.call.vertex_count;
  ShadedVertices* vertices = allocate_vertices(draw, begin, count, arena);
  for (uint32_t first = 0; first < count; first += kShadeChunk)
    chunks_.push_back({&draw, vertices, begin + first, std::min(kShadeChunk, count - first), 0});
  return vertices;
}

void PlannedVertices::shade() {
  shade_chunks(is_enabled(FastPath::ClippedDraws));
  for (auto first = chunks_.begin(); first != chunks_.end();) {
    uint32_t common = ~0u;
    auto last = first;
    for (; last != chunks_.end() && last->vertices == first->vertices; ++last) common &= last->clipped;
    if (common) {
      leave(*first->vertices);
      std::for_each(first, last, [](Chunk& c) { c.clipped = 0; });
    }
    first = last;
  }
  std::erase_if(chunks_, [](const Chunk& c) { return !c.clipped; }); // shaded, or left for good
  shade_chunks(false);
  chunks_.clear();
}

void PlannedVertices::shade_chunks(bool leave_clipped) {
  ThreadPool::instance().run(chunks_.size(), [&](size_t i, int) {
    Chunk& c = chunks_[i];
    c.clipped = shade_vertices(*c.draw, c.first, c.count, *c.vertices, leave_clipped);
  });
}

const ShadedVertices* shade_vertices_of_piece(const DrawRecord& draw, uint32_t first, uint32_t count,
                                              Arena& arena) {
  ShadedVertices* vertices = allocate_vertices(draw, first, count, arena);
  if (shade_vertices(draw, first, count, *vertices, is_enabled(FastPath::ClippedDraws))) leave(*vertices);
  return vertices;
}

} // namespace softgl
