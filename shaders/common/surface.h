// Framebuffer memory as the kernels see it: 64x64-pixel tiles of sixty-four 8x8-pixel blocks, window y down.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace softgl {

constexpr int kTileSize = 64; // pixels; one worker owns a tile
constexpr int kTilePixels = kTileSize * kTileSize;
constexpr int kLanes = 64; // lanes of a block: measured, 16 costs 26 % more, 128 gains nothing
constexpr int kStripLanes =
    16; // a strip is 8x2 pixels: whole 2x2 quads, and the unit in which dead lanes are skipped

/// How a pixel's color is stored. Rgb565 keeps r in bits 11-15; Float is not clamped.
enum class ColorFormat : uint8_t { Rgba8, Rgba16, RgbaFloat, Rgb565 };
constexpr int bytes_per_pixel(ColorFormat f) {
  return f == ColorFormat::Rgba8 ? 4 : f == ColorFormat::Rgba16 ? 8 : f == ColorFormat::RgbaFloat ? 16 : 2;
}
/// Z24S8 keeps depth in bits 0-23 and stencil in 24-31 of a uint32_t; Z16 keeps depth in bits 0-15 of a
/// uint32_t.
enum class DepthFormat : uint8_t { None, Z16, Z24S8 };
/// The integer that depth 1 is stored as.
constexpr uint32_t largest_depth(DepthFormat f) { return f == DepthFormat::Z16 ? 0xffff : 0xffffff; }

/// Index of pixel (x, y), y down, inside its 64x64 tile: 8x8 blocks in rows, rows of pixels inside a block.
inline int pixel_in_tile(int x, int y) {
  return ((y & 56) << 6) | ((x & 56) << 3) | ((y & 7) << 3) | (x & 7);
}

/// What is known of the words that a plane has in a tile. While it waits, all of them are `word`, and the
/// plane's memory has still to be told: so a tile that is cleared and never drawn on costs nothing.
struct TileWords {
  uint32_t word = 0;
  uint32_t known = 0; // bits that are those of `word` at all pixels
  bool waits = false; // known are all bits
};
/// Tile t = (y / 64) * tiles_x + x / 64 has the pixels from place * kTilePixels on in both planes.
struct TileState {
  uint32_t place;                 // kNoPlace: both planes wait
  TileWords color, depth_stencil; // color: of Rgba8 only
};
constexpr uint32_t kNoPlace = ~uint32_t(0);

/// The color and depth/stencil planes. Tiles get their places in them when they are first written to, so
/// that those of a picture that fills half the window lie close together and the rest of the planes is never
/// brought into memory. Where both planes have words they share that memory, a tile's depths behind its
/// colors.
struct Surface {
  int32_t width, height; // pixels
  int32_t tiles_x, tiles_y;
  ColorFormat color_format;
  DepthFormat depth_format;
  void* color;             // tiles_x * tiles_y * kTilePixels pixels of color_format
  uint32_t* depth_stencil; // as many words; null when depth_format is None
  TileState* tile;         // of each tile
  uint32_t* next_place;    // places before it are taken
  uint32_t place_step;     // places from tile to tile: 2 where the planes share memory, else 1
};

inline size_t pixel_index(const Surface& s, int x, int y) {
  return s.tile[(y >> 6) * s.tiles_x + (x >> 6)].place * size_t(kTilePixels) + size_t(pixel_in_tile(x, y));
}

} // namespace softgl
