#include "raster/tile_list.h"

#include <algorithm>

namespace softgl {

void TileLists::open(List& l, TileSegment::Kind kind, const RasterDraw* draw, size_t entry) {
  if (!l.next || static_cast<size_t>(l.end - l.next) < sizeof(TileSegment) + entry) {
    close(l);
    const size_t least = sizeof(TileChunk) + sizeof(TileSegment) + entry;
    const uint32_t wanted = l.last ? std::min(2 * l.last->size, kMostChunk) : kFirstChunk;
    const auto size = static_cast<uint32_t>(std::max<size_t>(wanted, least));
    auto* chunk = static_cast<TileChunk*>(arena_->allocate(size));
    chunk->next = nullptr;
    chunk->used = 0;
    chunk->size = size;
    if (l.last)
      l.last->next = chunk;
    else
      l.first = chunk;
    l.last = chunk;
    // The memory that comes next is needed soon, by this or another list, and lies in a far cache.
    for (auto *p = reinterpret_cast<uint8_t*>(chunk) + size, *stop = p + size; p < stop; p += 64)
      __builtin_prefetch(p, 1);
    l.next = reinterpret_cast<uint8_t*>(chunk + 1);
    l.end = reinterpret_cast<uint8_t*>(chunk) + size;
  }
  SOFTGL_ASSERT(static_cast<size_t>(l.end - l.next) >= sizeof(TileSegment) + entry);
  l.open = new (l.next) TileSegment;
  l.open->kind = kind;
  l.open->capacity = 0;
  l.open->count = 0;
  l.open->draw = draw;
  l.next += sizeof(TileSegment);
  // What is written after this segment comes from a far cache.
  if (kind == TileSegment::Fragments)
    for (const uint8_t *p = l.next + entry, *stop = p + entry; p < stop; p += 64) __builtin_prefetch(p, 1);
}

} // namespace softgl
