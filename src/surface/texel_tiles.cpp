#include "surface/texel_tiles.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "surface/plane_texels.h"
#include "texture/texture_object.h"

namespace softgl {
namespace {

using WholeRun = std::integral_constant<int, 8>; // pixels of a block's row
constexpr int kRun = WholeRun::value;

/// Rows of a texture are far from each other, and mostly not in the cache when a tile is stored: so many rows
/// ahead they are fetched (9.3 % of a frame of MuJoCo with shadows before, 7.5 % since; 2: no gain, 8: as 4).
constexpr size_t kRowsAhead = 4;

/// Calls visit(x, y, first of up to 8 neighbors in the tile, how many) for all pixels of the tile. Of a whole
/// run the compiler knows the length: storing the depths of shadow maps took 11 % of a frame of MuJoCo, then
/// 7 %.
template <class Visit> void for_each_run(const RenderPlane& p, uint32_t tile, Visit&& visit) {
  const int x0 = int(tile) % p.tiles_x * kTileSize, y0 = int(tile) / p.tiles_x * kTileSize;
  const int columns = std::min(kTileSize, p.width - x0), rows = std::min(kTileSize, p.height - y0);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; x += kRun) {
      const auto at = size_t(pixel_in_tile(x, y));
      if (columns - x >= kRun)
        visit(x0 + x, y0 + y, at, WholeRun{});
      else
        visit(x0 + x, y0 + y, at, columns - x);
    }
}

/// Depths of 32 bits are drawn to with 24.
uint32_t drawn_depth(uint32_t texel, int bits) { return bits == 32 ? texel >> 8 : texel; }
uint32_t stored_depth(uint32_t word, int bits) {
  const uint32_t z = bits == 16 ? word & 0xffff : word & 0xffffff;
  return bits == 32 ? z << 8 | z >> 16 : z;
}

} // namespace

void load_tile(RenderPlane& p, const TextureImage& image, int z, uint32_t tile, int sample) {
  unsigned char* pixels = p.pixels(tile);
  TileWords& words = p.tile[tile];
  const size_t texel_bytes = size_t(image.format->bytes());
  const uint32_t waiting = words.waits ? words.word & 0xff000000u : 0;
  const bool floats = p.format.has_floats();
  for_each_run(p, tile, [&](int x, int y, size_t at, auto count) {
    const unsigned char* texels = image.at(x, y, z);
    if (p.format.is_color()) {
      const auto bytes = size_t(p.pixel_bytes());
      if (p.samples == 1) {
        texels_to_pixels(*image.format, p.format.color, texels, count, pixels + at * bytes);
        return;
      }
      unsigned char run[kRun * 16];
      texels_to_pixels(*image.format, p.format.color, texels, count, run);
      for (size_t i = 0; i < size_t(count); ++i)
        std::memcpy(pixels + p.place(at + i, sample) * bytes, run + i * bytes, bytes);
      return;
    }
    for (int i = 0; i < count; ++i, texels += texel_bytes) {
      auto* word = reinterpret_cast<uint32_t*>(pixels) + p.place(at + size_t(i), sample);
      if (floats) {
        std::memcpy(word, texels, 4);
        if (!image.stencils.empty()) word[kTilePixels * p.samples] = *image.stencil_at(x + i, y, z);
        continue;
      }
      uint32_t texel;
      std::memcpy(&texel, texels, 4);
      const uint32_t stencil = image.stencils.empty() ? words.waits ? waiting : *word & 0xff000000u
                                                      : uint32_t(*image.stencil_at(x + i, y, z)) << 24;
      *word = drawn_depth(texel, image.format->bits[0]) | stencil;
    }
  });
  words.waits = words.changed = false;
  words.known = 0;
  p.stored[tile].known = false;
}

void store_tile(RenderPlane& p, TextureImage& image, int z, uint32_t tile, int sample) {
  TileWords& words = p.tile[tile];
  if (!words.changed) return;
  words.changed = false;
  RenderPlane::StoredWord& stored = p.stored[tile];
  if (words.waits && stored.known && stored.word == words.word) return;
  stored = {words.waits && !p.format.has_stencil_words(), words.word};
  uint32_t same[kRun];
  std::fill_n(same, kRun, words.word);
  const unsigned char* pixels = p.pixels(tile);
  const size_t texel_bytes = size_t(image.format->bytes());
  const bool depth_alone = !p.format.has_floats() && image.stencils.empty();
  const int depth_bits = image.format->bits[0];
  for_each_run(p, tile, [&](int x, int y, size_t at, auto count) {
    unsigned char* texels = image.at(x, y, z);
    __builtin_prefetch(texels + kRowsAhead * image.row_bytes, 1);
    const auto bytes = size_t(p.pixel_bytes());
    const unsigned char* from = pixels + at * bytes;
    unsigned char run[kRun * 16];
    if (words.waits) {
      from = reinterpret_cast<const unsigned char*>(same);
    } else if (p.samples > 1) {
      for (size_t i = 0; i < size_t(count); ++i)
        std::memcpy(run + i * bytes, pixels + p.place(at + i, sample) * bytes, bytes);
      from = run;
    }
    if (p.format.is_color()) {
      pixels_to_texels(*image.format, p.format.color, from, count, texels);
      return;
    }
    if (depth_alone) {
      alignas(32) uint32_t word[kRun] = {};
      std::memcpy(word, from, 4 * size_t(count));
      for (uint32_t& z : word) z = stored_depth(z, depth_bits);
      std::memcpy(texels, word, 4 * size_t(count));
      return;
    }
    for (int i = 0; i < count; ++i, texels += texel_bytes) {
      if (p.format.has_floats()) {
        std::memcpy(texels, from + 4 * i, 4);
        const auto* stencils = reinterpret_cast<const uint32_t*>(pixels) + kTilePixels * p.samples;
        if (!image.stencils.empty())
          *image.stencil_at(x + i, y, z) = uint8_t(stencils[p.place(at + size_t(i), sample)]);
      } else {
        uint32_t word;
        std::memcpy(&word, from + 4 * i, 4);
        if (!image.stencils.empty()) *image.stencil_at(x + i, y, z) = uint8_t(word >> 24);
        word = stored_depth(word, image.format->bits[0]);
        std::memcpy(texels, &word, 4);
      }
    }
  });
}

} // namespace softgl
