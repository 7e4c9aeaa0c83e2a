// Pixel storage, pixel transfer (3.6) and images of pixels, as the specification's machine has them.
#pragma once

#include <map>
#include <vector>

#include "script/pixel_types.h"
#include "spec/interval.h"

namespace softgl::suite {

using spec::Interval;

/// Table 3.1.
struct PixelStore {
  bool swap_bytes = false, lsb_first = false;
  int row_length = 0, skip_rows = 0, skip_pixels = 0, alignment = 4, image_height = 0, skip_images = 0;
};

/// Table 3.2 and the pixel maps.
struct PixelTransferState {
  bool map_color = false, map_stencil = false;
  int index_shift = 0, index_offset = 0;
  double scale[4] = {1, 1, 1, 1}, bias[4] = {0, 0, 0, 0}, depth_scale = 1, depth_bias = 0;
  std::map<GLenum, std::vector<double>> maps; // one entry of 0 if it is not there
  bool is_default() const;
};

/// A pixel: a color, an index (in red) or a depth (in red).
struct Pixel {
  Interval c[4];
};
enum class PixelKind { Color, Index, Stencil, Depth };
PixelKind kind_of(GLenum format);

struct PixelImage {
  PixelKind kind = PixelKind::Color;
  int width = 0, height = 0, depth = 1;
  std::vector<Pixel> pixels; // rows from below
};

/// The places of the elements of an image in memory (3.6.4): where the group of a pixel begins, in bytes.
size_t group_offset(const PixelStore& store, GLenum format, GLenum type, int width, int height, int x, int y,
                    int z);
/// Unpacks an image and converts it to RGBA, but for indexes and depths (3.6.4).
PixelImage unpack(const PixelStore& store, const Argument& memory, GLenum format, GLenum type, int width,
                  int height, int depth);
/// Pixel transfer (3.6.5). Color indexes become colors if `to_colors` says so.
void transfer(const PixelTransferState& state, PixelImage& image, bool to_colors);
/// Bit (x, y) of a bitmap.
bool bitmap_bit(const PixelStore& store, const std::vector<double>& bytes, int width, int x, int y);

/// The elements that reading (4.3.2) leaves in memory of `count` elements, each component as it is painted:
/// with the rounding of the type.
std::vector<Interval> packed_elements(const PixelStore& store, const PixelImage& image, GLenum format,
                                      GLenum type, int count);

} // namespace softgl::suite
