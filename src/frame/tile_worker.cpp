#include "frame/tile_worker.h"

#include <algorithm>
#include <atomic>
#include <cstring>

#include "base/assert.h"
#include "base/fast_paths.h"
#include "frame/frame.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {

namespace {

struct Box {
  int32_t x0, y0, x1, y1; // inside the tile, half open
};

Box clear_box(const ClearRecord& c, const Surface& s, uint32_t tile) {
  const int32_t x = static_cast<int32_t>(tile % uint32_t(s.tiles_x)) * kTileSize,
                y = static_cast<int32_t>(tile / uint32_t(s.tiles_x)) * kTileSize;
  return {std::max(c.x0 - x, 0), std::max(c.y0 - y, 0), std::min(c.x1 - x, kTileSize),
          std::min(c.y1 - y, kTileSize)};
}

/// True when the clear covers every pixel of the tile that the planes have.
bool covers_tile(const ClearRecord& c, const Surface& s, uint32_t tile) {
  const Box b = clear_box(c, s, tile);
  const int32_t x = static_cast<int32_t>(tile % uint32_t(s.tiles_x)) * kTileSize,
                y = static_cast<int32_t>(tile / uint32_t(s.tiles_x)) * kTileSize;
  return b.x0 == 0 && b.y0 == 0 && b.x1 >= std::min(kTileSize, s.plane_width - x) &&
         b.y1 >= std::min(kTileSize, s.plane_height - y);
}

/// Replaces the bits of `mask` in all samples of the pixels of the box; all of the tile when `whole`.
template <class Word>
void fill(Word* plane, int32_t samples, Word value, Word mask, const Box& box, bool whole) {
  if (whole && mask == static_cast<Word>(~Word(0))) {
    std::fill_n(plane, kTilePixels * samples, value);
    return;
  }
  const auto replace = [&](Word& w) { w = static_cast<Word>((w & ~mask) | (value & mask)); };
  if (whole) {
    for (int i = 0; i < kTilePixels * samples; ++i) replace(plane[i]);
    return;
  }
  for (int32_t y = box.y0; y < box.y1; ++y)
    for (int32_t x = box.x0; x < box.x1; ++x)
      for (int32_t s = 0; s < samples; ++s) replace(plane[pixel_in_tile(x, y) * samples + s]);
}

void write_words(uint32_t* plane, int32_t samples, TileWords& words) {
  if (!words.waits) return;
  // A string store does not read the memory first, which lies in a far cache: all of mesh70k takes 1 to 3 %
  // less time.
  const uint64_t pair = words.word | uint64_t(words.word) << 32;
  size_t pairs = size_t(kTilePixels) / 2 * size_t(samples);
  asm volatile("rep stosq" : "+D"(plane), "+c"(pairs) : "a"(pair) : "memory");
  words.waits = false;
}

/// Of a tile that waits without a place nothing is read or written there.
size_t first_pixel(const TileWords& words) {
  return words.place == kNoPlace ? 0 : words.place * size_t(kTilePixels);
}

/// Replaces the bits of `mask` in the words of the box. What waits has been written, unless the box is the
/// whole tile.
void clear_words(uint32_t* plane, int32_t samples, TileWords& words, uint32_t value, uint32_t mask,
                 const Box& box, bool whole) {
  if (!whole) {
    words.known &= ~mask;
    return fill(plane, samples, value, mask, box, false);
  }
  words.word = (words.word & ~mask) | (value & mask);
  words.known |= mask;
  words.waits = words.known == ~uint32_t(0);
  if (!words.waits) fill(plane, samples, value, mask, box, true);
}

void clear_color(const ClearRecord& c, const Surface& s, uint32_t tile, const Box& box, bool whole) {
  TileWords& words = color_words(s, tile);
  const size_t first = first_pixel(words);
  words.changed = true;
  switch (s.color_format) {
  case ColorFormat::Rgba8: {
    uint32_t value = 0, mask = 0;
    for (int i = 0; i < 4; ++i) {
      value |= uint32_t(c.color_value[i]) << (8 * i);
      if (c.color_mask[i])
        mask |= 0xffu << (8 * i); // GCC 12.2 -fsanitize=undefined makes 0 of (c ? 0xffu : 0u) << 8 * i
    }
    clear_words(static_cast<uint32_t*>(s.color) + first, s.samples, words, value, mask, box, whole);
    break;
  }
  case ColorFormat::Rgb565: {
    const auto r = uint32_t(c.color_value[0]), g = uint32_t(c.color_value[1]), b = uint32_t(c.color_value[2]);
    const uint32_t mask = (c.color_mask[0] ? 0xf800u : 0u) | (c.color_mask[1] ? 0x07e0u : 0u) |
                          (c.color_mask[2] ? 0x001fu : 0u);
    fill(static_cast<uint16_t*>(s.color) + first, s.samples, static_cast<uint16_t>(r << 11 | g << 5 | b),
         static_cast<uint16_t>(mask), box, whole);
    break;
  }
  case ColorFormat::Rgba16: {
    uint64_t value = 0, mask = 0;
    for (int i = 0; i < 4; ++i) {
      value |= uint64_t(uint16_t(int32_t(c.color_value[i]))) << (16 * i);
      if (c.color_mask[i]) mask |= uint64_t(0xffff) << (16 * i);
    }
    fill(static_cast<uint64_t*>(s.color) + first, s.samples, value, mask, box, whole);
    break;
  }
  case ColorFormat::RgbaFloat: {
    float* plane = static_cast<float*>(s.color) + 4 * first;
    for (int32_t y = box.y0; y < box.y1; ++y)
      for (int32_t x = box.x0; x < box.x1; ++x)
        for (int32_t sample = 0; sample < s.samples; ++sample)
          for (int i = 0; i < 4; ++i)
            if (c.color_mask[i]) plane[4 * (pixel_in_tile(x, y) * s.samples + sample) + i] = c.color_value[i];
    break;
  }
  }
}

void clear_depth_stencil(const ClearRecord& c, const Surface& s, uint32_t tile, const Box& box, bool whole) {
  TileWords& words = depth_words(s, tile);
  uint32_t* plane = s.depth_stencil + first_pixel(words);
  uint32_t value = 0, mask = 0;
  if (c.depth) {
    value = c.depth_value & largest_depth(s.depth_format);
    mask = has_stencil_bits(s.depth_format) ? 0xffffffu : ~0u;
  }
  if (c.stencil && has_stencil_bits(s.depth_format))
    value |= c.stencil_value << 24, mask |= c.stencil_write_mask << 24;
  words.changed = true;
  if (c.stencil && s.depth_format == DepthFormat::Z32F) // these never wait
    fill(plane + stencil_step(s), s.samples, c.stencil_value, c.stencil_write_mask, box, whole);
  if (mask) clear_words(plane, s.samples, words, value, mask, box, whole);
}

void execute_clear(const ClearRecord& c, const Surface& s, uint32_t tile) {
  const Box box = clear_box(c, s, tile);
  if (box.x0 >= box.x1 || box.y0 >= box.y1) return;
  const bool whole = covers_tile(c, s, tile) && takes(FastPath::WaitingClears);
  if (!whole) write_tile(s, tile);
  if (c.color && s.color) clear_color(c, s, tile, box, whole);
  if (s.depth_stencil && (c.depth || c.stencil)) clear_depth_stencil(c, s, tile, box, whole);
}

/// Makes ready for fragments of a draw: what waits is written, and what they write is no longer known.
void open_tile(const Surface& s, uint32_t tile, const RasterDraw& draw) {
  write_tile(s, tile);
  const FragmentKey& key = draw.program->key;
  const uint32_t stencil = has_stencil_bits(s.depth_format) ? 0xff000000u : 0;
  if (s.color) {
    TileWords& words = color_words(s, tile);
    words.known &= ~draw.color_mask;
    words.changed = true;
  }
  if (!s.depth_stencil) return;
  TileWords& words = depth_words(s, tile);
  if (key.stencil) words.known &= ~stencil;
  if (key.depth_write) words.known &= stencil;
  words.changed = words.changed || key.stencil || key.depth_write;
}

/// Where a draw finds the pixels of the tile.
void set_target(const Surface& s, uint32_t tile, uint32_t* no_colors, TileTarget& target) {
  target.color = no_colors;
  if (s.color) {
    const auto bytes = size_t(bytes_per_pixel(s.color_format));
    target.color = static_cast<uint8_t*>(s.color) + first_pixel(color_words(s, tile)) * bytes;
  }
  target.depth_stencil = nullptr;
  target.one_stencil = takes(FastPath::DepthWords);
  target.stencil_bits = 0;
  if (!s.depth_stencil) return;
  const TileWords& words = depth_words(s, tile);
  target.depth_stencil = s.depth_stencil + first_pixel(words);
  if (!has_stencil_bits(s.depth_format)) return;
  target.one_stencil = target.one_stencil && words.known >> 24 == 255;
  target.stencil_bits = words.word & 0xff000000u;
}

} // namespace

void write_tile(const Surface& s, uint32_t tile) {
  if (s.color) {
    TileWords& words = color_words(s, tile);
    if (words.place == kNoPlace) {
      words.place = std::atomic_ref(*s.next_place).fetch_add(s.place_step, std::memory_order_relaxed);
      if (s.depth_stencil) depth_words(s, tile).place = words.place;
    }
    if (s.color_format == ColorFormat::Rgba8)
      write_words(static_cast<uint32_t*>(s.color) + first_pixel(words), s.samples, words);
  }
  if (s.depth_stencil) {
    TileWords& words = depth_words(s, tile);
    write_words(s.depth_stencil + first_pixel(words), s.samples, words);
  }
}

bool clear_hides_all(const ClearRecord& c, const Surface& s, uint32_t tile, bool stencil_drawn) {
  if (s.color && !c.color) return false;
  if (s.color && !(c.color_mask[0] && c.color_mask[1] && c.color_mask[2] && c.color_mask[3])) return false;
  if (s.depth_format != DepthFormat::None && !c.depth) return false;
  if (stencil_drawn && s.depth_format != DepthFormat::Z16 && s.depth_format != DepthFormat::None &&
      !(c.stencil && (c.stencil_write_mask & 255) == 255))
    return false;
  return covers_tile(c, s, tile) && takes(FastPath::HidingClears);
}

bool clear_hides_clear(const ClearRecord& clear, const ClearRecord& before) {
  if (clear.x0 > before.x0 || clear.y0 > before.y0 || clear.x1 < before.x1 || clear.y1 < before.y1)
    return false;
  if (before.depth && !clear.depth) return false;
  if (before.stencil && !(clear.stencil && !(before.stencil_write_mask & ~clear.stencil_write_mask)))
    return false;
  for (int i = 0; i < 4; ++i)
    if (before.color && before.color_mask[i] && !(clear.color && clear.color_mask[i])) return false;
  return takes(FastPath::HidingClears);
}

void execute_tile(const Surface& surface, uint32_t tile, const TileChunk* work, const RasterKernels& kernels,
                  FragmentBlock& scratch, uint32_t* no_colors) {
  SOFTGL_ASSERT(tile < uint32_t(surface.tiles_x) * uint32_t(surface.tiles_y));
  TileTarget target;
  target.x = static_cast<int32_t>(tile % uint32_t(surface.tiles_x)) * kTileSize;
  target.y = static_cast<int32_t>(tile / uint32_t(surface.tiles_x)) * kTileSize;
  for_each_segment(work, [&](const TileSegment& segment) {
    const auto count = static_cast<int32_t>(segment.count);
    uint64_t samples = 0;
    SOFTGL_ASSERT(segment.kind == TileSegment::Clear ? segment.clear != nullptr : segment.draw && count > 0);
    if (segment.kind != TileSegment::Clear) {
      open_tile(surface, tile, *segment.draw);
      set_target(surface, tile, no_colors, target);
      target.samples = segment.draw->samples ? &samples : nullptr;
    }
    switch (segment.kind) {
    case TileSegment::Primitives:
      kernels.tile_primitives(target, *segment.draw,
                              reinterpret_cast<const RasterPrimitive* const*>(segment.entries()), count,
                              scratch);
      break;
    case TileSegment::Triangles:
      kernels.tile_triangles(target, *segment.draw, reinterpret_cast<const SmallTriangle*>(segment.entries()),
                             count, scratch);
      break;
    case TileSegment::Fragments:
      kernels.tile_fragments(target, *segment.draw, segment.fragments(), count);
      break;
    case TileSegment::Clear: execute_clear(*segment.clear, surface, tile); break;
    }
    if (samples && SOFTGL_FAULT(query_of_last_tile)) *segment.draw->samples = 0;
    if (samples) std::atomic_ref(*segment.draw->samples).fetch_add(samples, std::memory_order_relaxed);
  });
}

} // namespace softgl
