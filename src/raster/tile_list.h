// Per-tile lists: streams of segments in chunks of arena memory. One worker appends; joining links chunk chains.
#pragma once

#include <cstdint>
#include <vector>

#include "base/arena.h"
#include "raster_draw.h"

namespace softgl {

struct ClearRecord;

struct TileChunk {
  TileChunk* next;
  uint32_t used; // bytes of segments behind this header
  uint32_t size;
};

/// A run of entries of one kind and draw. Followed by `count` entries, padded to 8 bytes.
struct TileSegment {
  enum Kind : uint32_t { Primitives, Fragments, Clear };
  Kind kind;
  uint32_t count;
  union {
    const RasterDraw* draw;
    const ClearRecord* clear;
  };
};
static_assert(sizeof(TileSegment) == 16);

/// The lists that one unit of work makes, for the tiles that it touches.
class TileLists {
public:
  struct List {
    uint8_t *next = nullptr, *end = nullptr;
    TileSegment* open = nullptr;
    TileChunk *first = nullptr, *last = nullptr;
    uint32_t stamp = 0;
  };
  struct Touched {
    uint32_t tile;
    TileChunk *first, *last;
  };

  /// Makes ready for a surface of `tiles` tiles; the lists of the last unit are forgotten.
  void begin(size_t tiles, Arena& arena) {
    if (lists_.size() < tiles) lists_.resize(tiles);
    if (++stamp_ == 0) {
      for (auto& l : lists_) l.stamp = 0;
      stamp_ = 1;
    }
    touched_.clear();
    arena_ = &arena;
  }

  void append_primitive(uint32_t tile, const RasterDraw* draw, const RasterPrimitive* primitive) {
    List& l = list(tile);
    if (!l.open || l.open->kind != TileSegment::Primitives || l.open->draw != draw || l.end - l.next < 8) open(l, TileSegment::Primitives, draw, 8);
    memcpy(l.next, &primitive, 8);
    l.next += 8;
    ++l.open->count;
  }

  /// Room for at least one and at most `wanted` fragments of a tile; `given` says how many. The caller fills them.
  SmallFragment* append_fragments(uint32_t tile, const RasterDraw* draw, uint32_t wanted, uint32_t& given) {
    List& l = list(tile);
    // 8 bytes are kept back for the padding behind the segment.
    if (!l.open || l.open->kind != TileSegment::Fragments || l.open->draw != draw || l.end - l.next < 20)
      open(l, TileSegment::Fragments, draw, 20);
    const uint32_t room = static_cast<uint32_t>((l.end - l.next - 8) / 12);
    given = wanted < room ? wanted : room;
    auto* result = reinterpret_cast<SmallFragment*>(l.next);
    l.next += 12 * size_t(given);
    l.open->count += given;
    return result;
  }

  /// Closes all lists and returns them.
  const std::vector<Touched>& finish() {
    for (auto& t : touched_) {
      List& l = lists_[t.tile];
      close(l);
      t.first = l.first;
      t.last = l.last;
    }
    return touched_;
  }

private:
  static constexpr uint32_t kFirstChunk = 512, kChunk = 2048;

  List& list(uint32_t tile) {
    List& l = lists_[tile];
    if (l.stamp != stamp_) {
      l = List{};
      l.stamp = stamp_;
      touched_.push_back({tile, nullptr, nullptr});
    }
    return l;
  }
  static void close(List& l) {
    if (l.last) l.last->used = static_cast<uint32_t>(l.next - reinterpret_cast<uint8_t*>(l.last + 1));
  }
  void open(List& l, TileSegment::Kind kind, const RasterDraw* draw, size_t entry);

  std::vector<List> lists_;
  std::vector<Touched> touched_;
  Arena* arena_ = nullptr;
  uint32_t stamp_ = 0;
};

/// Calls visit(segment, entries) for every segment of a chain of chunks.
template <class Visit> void for_each_segment(const TileChunk* chunk, Visit&& visit) {
  for (; chunk; chunk = chunk->next) {
    const auto* p = reinterpret_cast<const uint8_t*>(chunk + 1);
    const uint8_t* end = p + chunk->used;
    while (p < end) {
      const auto& segment = *reinterpret_cast<const TileSegment*>(p);
      const uint8_t* entries = p + sizeof(TileSegment);
      visit(segment, entries);
      const size_t bytes = segment.kind == TileSegment::Fragments ? (12 * size_t(segment.count) + 7) & ~size_t(7) : 8 * size_t(segment.count);
      p = entries + bytes;
    }
  }
}

} // namespace softgl
