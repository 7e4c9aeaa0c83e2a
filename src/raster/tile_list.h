// Per-tile lists: streams of segments in chunks of arena memory. One worker appends; joining links chunk
// chains.
#pragma once

#include <cstdint>
#include <new>
#include <vector>

#include "base/arena.h"
#include "base/assert.h"
#include "shaders/raster/raster_draw.h"

namespace softgl {

struct ClearRecord;

struct TileChunk {
  TileChunk* next;
  uint32_t used; // bytes of segments behind this header
  uint32_t size;
};

/// A run of entries of one kind and draw. Followed by pointers to primitives, by small triangles, or by
/// `capacity` depths, colors and pixels of fragments, of which `count` are set.
struct TileSegment {
  enum Kind : uint16_t { Primitives, Triangles, Fragments, Clear };
  Kind kind;
  uint16_t capacity;
  uint32_t count;
  union {
    const RasterDraw* draw;
    const ClearRecord* clear;
  };

  static constexpr size_t kFragmentBytes = sizeof(uint32_t) + sizeof(uint32_t) + sizeof(uint16_t);
  uint8_t* entries() { return reinterpret_cast<uint8_t*>(this + 1); }
  const uint8_t* entries() const { return reinterpret_cast<const uint8_t*>(this + 1); }
  size_t entry_bytes() const {
    return kind == Fragments   ? kFragmentBytes * capacity
           : kind == Triangles ? sizeof(SmallTriangle) * count
                               : sizeof(void*) * count;
  }
  SmallFragments fragments() const {
    auto* depth = reinterpret_cast<uint32_t*>(const_cast<uint8_t*>(entries()));
    return {reinterpret_cast<uint16_t*>(depth + 2 * capacity), depth, depth + capacity};
  }
};
static_assert(sizeof(TileSegment) == 16);

/// The lists that one portion of a frame makes, for the tiles that it touches.
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
    append(tile, TileSegment::Primitives, draw, primitive);
  }
  void append_triangle(uint32_t tile, const RasterDraw* draw, const SmallTriangle& triangle) {
    append(tile, TileSegment::Triangles, draw, triangle);
  }
  /// Where the next triangles of a tile go: `room` of them, at least one. Until end_triangles() says where
  /// they end nothing else may be appended to this tile.
  SmallTriangle* begin_triangles(uint32_t tile, const RasterDraw* draw, uint32_t& room) {
    List& l = list(tile);
    make_room(l, TileSegment::Triangles, draw, sizeof(SmallTriangle));
    room = static_cast<uint32_t>(static_cast<size_t>(l.end - l.next) / sizeof(SmallTriangle));
    return reinterpret_cast<SmallTriangle*>(l.next);
  }
  void end_triangles(uint32_t tile, SmallTriangle* end) {
    List& l = lists_[tile];
    SOFTGL_ASSERT(l.open && l.open->kind == TileSegment::Triangles);
    SOFTGL_ASSERT(reinterpret_cast<uint8_t*>(end) >= l.next && reinterpret_cast<uint8_t*>(end) <= l.end);
    l.open->count += static_cast<uint32_t>(end - reinterpret_cast<SmallTriangle*>(l.next));
    l.next = reinterpret_cast<uint8_t*>(end);
  }

  /// Room for at least one and at most `wanted` fragments of a tile; `given` says how many. The caller fills
  /// them.
  SmallFragments append_fragments(uint32_t tile, const RasterDraw* draw, uint32_t wanted, uint32_t& given) {
    List& l = list(tile);
    const bool goes_on = l.open && l.open->kind == TileSegment::Fragments && l.open->draw == draw;
    if (!goes_on || l.open->count == l.open->capacity) {
      // The first segment of a draw is as large as its fragments, since many draws have few; later ones are
      // full size.
      const uint32_t capacity = goes_on                  ? kMaxFragments
                                : wanted < kMaxFragments ? (wanted + 15) & ~15u
                                                         : kMaxFragments;
      open(l, TileSegment::Fragments, draw, TileSegment::kFragmentBytes * capacity);
      l.open->capacity = static_cast<uint16_t>(capacity);
      l.next += l.open->entry_bytes();
    }
    const uint32_t count = l.open->count, room = l.open->capacity - count;
    given = wanted < room ? wanted : room;
    SOFTGL_ASSERT(given > 0);
    l.open->count += given;
    const SmallFragments f = l.open->fragments();
    return {f.pixel + count, f.depth + count, f.color + count};
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
  static constexpr uint32_t kFirstChunk = 512, kMostChunk = 4096, kMaxFragments = 128;

  template <class Entry>
  void append(uint32_t tile, TileSegment::Kind kind, const RasterDraw* draw, const Entry& entry) {
    List& l = list(tile);
    make_room(l, kind, draw, sizeof(Entry));
    new (l.next) Entry(entry);
    l.next += sizeof(Entry);
    ++l.open->count;
  }
  void make_room(List& l, TileSegment::Kind kind, const RasterDraw* draw, size_t entry) {
    if (!l.open || l.open->kind != kind || l.open->draw != draw ||
        static_cast<size_t>(l.end - l.next) < entry)
      open(l, kind, draw, entry);
  }

  List& list(uint32_t tile) {
    SOFTGL_ASSERT(tile < lists_.size());
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

/// Calls visit(segment) for every segment of a chain of chunks.
template <class Visit> void for_each_segment(const TileChunk* chunk, Visit&& visit) {
  for (; chunk; chunk = chunk->next) {
    const auto* p = reinterpret_cast<const uint8_t*>(chunk + 1);
    const uint8_t* end = p + chunk->used;
    SOFTGL_ASSERT(!chunk->size || sizeof(TileChunk) + chunk->used <= chunk->size);
    while (p < end) {
      const auto& segment = *reinterpret_cast<const TileSegment*>(p);
      p = segment.entries() + segment.entry_bytes();
      SOFTGL_ASSERT(p <= end && reinterpret_cast<uintptr_t>(&segment) % alignof(TileSegment) == 0);
      SOFTGL_ASSERT(segment.kind != TileSegment::Fragments || segment.count <= segment.capacity);
      // The next one comes from a far cache.
      const auto* next = p < end ? p : reinterpret_cast<const uint8_t*>(chunk->next);
      if (next)
        for (int line = 0; line < 20; ++line) __builtin_prefetch(next + 64 * line);
      visit(segment);
    }
  }
}

} // namespace softgl
