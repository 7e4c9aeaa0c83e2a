// The client's side of an image: what a (format, type) pair looks like in memory (GL 1.5, 3.6.4 and tables 3.5 to 3.11)
// and where the pixel storage modes put its rows (table 3.1).
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/state.h"

namespace softgl {

struct PixelLayout {
  uint32_t bytes = 0;         // of a pixel; 0: no such pair. A bitmap says 1.
  uint32_t components = 0;    // of a pixel
  uint32_t element_bytes = 0; // the unit of byte swapping and of addressing
  bool packed = false;        // one element holds all components
  bool bitmap = false;        // one bit each
};
/// The layout of a pair, or bytes = 0 when one of them is unknown or they do not fit together.
PixelLayout pixel_layout(GLenum format, GLenum type);
/// GL_NO_ERROR, GL_INVALID_ENUM (unknown) or GL_INVALID_OPERATION (known, but not together).
GLenum check_pixel_format(GLenum format, GLenum type);
/// Components of a format, 0 if unknown.
uint32_t format_components(GLenum format);

/// Where the pixels of an image begin, by the pixel storage modes.
struct ImageAddressing {
  size_t row_stride = 0, image_stride = 0, start = 0; // bytes
  size_t first_bit = 0;                               // of a row, bitmaps only
  ImageAddressing(const PixelStore& store, const PixelLayout& layout, GLsizei width, GLsizei height);
  size_t row(GLsizei y, GLsizei z = 0) const { return start + size_t(z) * image_stride + size_t(y) * row_stride; }
};

inline bool bitmap_bit(const unsigned char* row, size_t bit, bool lsb_first) {
  return (row[bit >> 3] >> (lsb_first ? bit & 7 : 7 - (bit & 7))) & 1;
}
/// Reverses the bytes of every element of 2 or 4 bytes.
void swap_bytes(unsigned char* data, size_t bytes, uint32_t element_bytes);

} // namespace softgl
