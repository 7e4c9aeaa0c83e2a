// Framebuffer memory as the kernels see it: 64x64-pixel tiles of sixty-four 8x8-pixel blocks. Rows go down
// from the top of the window; in framebuffer objects they go up from the bottom (Surface::y_up).
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace softgl {

constexpr int kTileSize = 64; // pixels; one worker owns a tile
constexpr int kTilePixels = kTileSize * kTileSize;
constexpr int kSamples = 4; // of the pixels of a multisampled surface
constexpr int kLanes = 64;  // lanes of a block: measured, 16 costs 26 % more, 128 gains nothing
constexpr int kStripLanes =
    16; // a strip is 8x2 pixels: whole 2x2 quads, and the unit in which dead lanes are skipped

/// How a pixel's color is stored. Rgb565 keeps r in bits 11-15; Float is not clamped.
enum class ColorFormat : uint8_t { Rgba8, Rgba16, RgbaFloat, Rgb565 };
constexpr int bytes_per_pixel(ColorFormat f) {
  return f == ColorFormat::Rgba8 ? 4 : f == ColorFormat::Rgba16 ? 8 : f == ColorFormat::RgbaFloat ? 16 : 2;
}
/// What the numbers of a color are. Signed ones are int16_t where Rgba16 has uint16_t, also those of 8 bits.
enum class ColorNumbers : uint8_t { Unsigned, Signed, Float };
/// What of a color is kept. Unsigned numbers of fewer bits than the ColorFormat has fill its bits by
/// repeating their own. A component that is not kept is 0, alpha 1. Luminance and intensity are kept as red.
struct ColorEncoding {
  ColorNumbers numbers = ColorNumbers::Unsigned;
  uint8_t bits[4] = {8, 8, 8, 8}; // of r g b a; 0: not kept
  bool srgb = false;              // red, green and blue are not linear (GL_EXT_framebuffer_sRGB)
  bool operator==(const ColorEncoding&) const = default;
};
/// How many components are kept.
constexpr int kept_components(const ColorEncoding& e) {
  return (e.bits[0] > 0) + (e.bits[1] > 0) + (e.bits[2] > 0) + (e.bits[3] > 0);
}
/// Z24S8 keeps depth in bits 0-23 and stencil in 24-31 of a uint32_t; Z16 keeps depth in bits 0-15 of a
/// uint32_t. Z32F keeps a float of [0, 1] in a uint32_t; if there are stencil values, each is a uint32_t
/// kTilePixels times the samples behind its depth.
enum class DepthFormat : uint8_t { None, Z16, Z24S8, Z32F };
/// The integer that depth 1 is stored as, which is also the mask of the bits of a depth; of floats the mask.
constexpr uint32_t largest_depth(DepthFormat f) {
  return f == DepthFormat::Z16 ? 0xffff : f == DepthFormat::Z32F ? ~uint32_t(0) : 0xffffff;
}
/// Stencil values lie in the upper bits of the words of depths.
constexpr bool has_stencil_bits(DepthFormat f) { return f == DepthFormat::Z24S8; }

/// Index of pixel (x, y) inside its 64x64 tile: 8x8 blocks in rows, rows of pixels inside a block.
inline int pixel_in_tile(int x, int y) {
  return ((y & 56) << 6) | ((x & 56) << 3) | ((y & 7) << 3) | (x & 7);
}

/// What is known of a plane in a tile, and where its pixels are: from place * kTilePixels on. If a pixel has
/// several samples they lie side by side, and the tile reaches into the next places. While it waits, all
/// words are `word`, and the plane's memory does not have them yet: so a tile that is cleared and never drawn
/// on costs nothing. Only planes of 32-bit words may wait.
struct TileWords {
  uint32_t word = 0;
  uint32_t known = 0;   // bits that are those of `word` at all pixels
  bool waits = false;   // known are all bits
  bool changed = false; // something was written since the owner looked (Plane)
  uint32_t place = ~uint32_t(0);
};
constexpr uint32_t kNoPlace = ~uint32_t(0); // the tile waits without memory

/// The color and depth/stencil planes. Tiles of the window get their places in them when they are first
/// written to, so that those of a picture that fills half the window lie close together and the rest of the
/// planes is never brought into memory. Where both planes have words they share that memory, a tile's depths
/// behind its colors. The planes of framebuffer objects have fixed places; each may be larger than the
/// surface, and one may be missing.
struct Surface {
  int32_t width, height; // pixels
  int32_t tiles_x, tiles_y;
  ColorFormat color_format;
  DepthFormat depth_format;
  ColorEncoding encoding;
  uint32_t name;                     // of the framebuffer object, for the trace; 0: the window
  bool y_up;                         // row 0 is the bottom row of GL's window coordinates, not the top one
  int32_t plane_width, plane_height; // pixels of the larger plane: a clear of the surface leaves those beyond
  void* color;                       // pixels of color_format; null: nothing is drawn to colors
  uint32_t* depth_stencil;           // words; null when depth_format is None
  TileWords *color_tile, *depth_tile;   // of each tile of the planes; null where there is no plane
  int32_t color_columns, depth_columns; // tiles in a row of each plane
  uint32_t* next_place;                 // of the window: places before it are taken
  uint32_t
      place_step;     // places from tile to tile: as many as samples, twice as many where planes share memory
  int32_t samples;    // of a pixel: 1 or kSamples
  int32_t pixel_step; // from a pixel to its neighbor, in pixels of one sample: 1 or kSamples
};

/// Number of tile `tile` of the surface in a plane that has `columns` tiles in a row.
inline uint32_t tile_of_plane(const Surface& s, int32_t columns, uint32_t tile) {
  const auto row = uint32_t(s.tiles_x);
  return columns == s.tiles_x ? tile : tile / row * uint32_t(columns) + tile % row;
}
inline TileWords& color_words(const Surface& s, uint32_t tile) {
  return s.color_tile[tile_of_plane(s, s.color_columns, tile)];
}
inline TileWords& depth_words(const Surface& s, uint32_t tile) {
  return s.depth_tile[tile_of_plane(s, s.depth_columns, tile)];
}

/// The surface of one of the samples of each pixel.
inline Surface sample_surface(Surface s, int sample) {
  if (s.color) s.color = static_cast<char*>(s.color) + sample * bytes_per_pixel(s.color_format);
  if (s.depth_stencil) s.depth_stencil += sample;
  s.samples = 1;
  return s;
}

inline size_t pixel_index(const Surface& s, const TileWords* tiles, int32_t columns, int x, int y) {
  return tiles[(y >> 6) * columns + (x >> 6)].place * size_t(kTilePixels) +
         size_t(pixel_in_tile(x, y) * s.pixel_step);
}
inline size_t color_index(const Surface& s, int x, int y) {
  return pixel_index(s, s.color_tile, s.color_columns, x, y);
}
inline size_t depth_index(const Surface& s, int x, int y) {
  return pixel_index(s, s.depth_tile, s.depth_columns, x, y);
}
/// Words from the depths of a tile to its stencil values, where those have words of their own.
inline size_t stencil_step(const Surface& s) { return size_t(kTilePixels) * size_t(s.pixel_step); }

} // namespace softgl
