// Pixels of client memory (GL 1.5, 3.6.4 and 4.3.2): which formats and types there are, where the pixels of
// an image lie, and their conversion from and to rows of RGBA. Used by textures, DrawPixels and ReadPixels.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/gl_types.h"
#include "base/refusal.h"

namespace softgl {

struct PixelStore;

enum class PixelChannel : uint8_t {
  UnsignedByte,
  Byte,
  UnsignedShort,
  Short,
  UnsignedInt,
  Int,
  Float,
  Half,
  Packed,
  PackedFloat,
  Bitmap
};

/// A format and type taken apart. Component i of a pixel holds channel target[i]: 0-3 = r, g, b, a.
struct PixelFormat {
  PixelChannel channel;
  uint8_t components;    // in memory; 1 for luminance, intensity, index and depth
  uint8_t bytes;         // of a whole pixel; 0 for GL_BITMAP
  uint8_t element_bytes; // what GL_UNPACK_SWAP_BYTES swaps
  uint8_t target[4];
  uint8_t shift[4], bits[4]; // of packed components, by component
  bool luminance;            // one component stands for r, g and b
  GLenum format, type;
};

/// GL_INVALID_ENUM for an unknown format or type, GL_INVALID_OPERATION for a packed type that
/// does not fit the format (tables 3.5, 3.6, 3.8).
Refusal check_pixel_format(GLenum format, GLenum type);
/// Only after check_pixel_format() found nothing.
PixelFormat describe_pixel_format(GLenum format, GLenum type);

/// Where the pixels of a client image lie (3.6.4). `row_bytes` are read or written in each row.
struct ImageLayout {
  size_t offset; // of the first pixel, from the pointer given by the client
  size_t row_stride, image_stride, row_bytes;
  int bit_offset; // of the first pixel in its byte, GL_BITMAP only
  int inverted;   // 0, or the number of rows, the last of which lies first (GL_MESA_pack_invert)

  /// Where row `r` begins, from the pointer given by the client; rows count from the bottom.
  size_t row(int r) const { return offset + size_t(inverted ? inverted - 1 - r : r) * row_stride; }
};
/// `dimensions` 1 to 3: rows are skipped from two on, images in three only.
ImageLayout layout_image(const PixelStore& store, int dimensions, int width, int height,
                         const PixelFormat& format);

/// A row of pixels in the three intermediate forms of OSMesa 22.3.6; which one is used decides how a value is
/// rounded. Missing components become 0, 0, 0, 1.
void unpack_pixels(const PixelFormat& format, const void* row, int count, bool swap_bytes,
                   uint8_t (*rgba)[4]);
void unpack_pixels(const PixelFormat& format, const void* row, int count, bool swap_bytes,
                   uint16_t (*rgba)[4]);
void unpack_pixels(const PixelFormat& format, const void* row, int count, bool swap_bytes, float (*rgba)[4]);
/// In signed forms, for formats with components in [-1, 1].
void unpack_pixels(const PixelFormat& format, const void* row, int count, bool swap_bytes, int8_t (*rgba)[4]);
void unpack_pixels(const PixelFormat& format, const void* row, int count, bool swap_bytes,
                   int16_t (*rgba)[4]);
/// The way back. A luminance format takes red: sums are the caller's (4.3.2).
void pack_pixels(const PixelFormat& format, const uint8_t (*rgba)[4], int count, bool swap_bytes, void* row);
void pack_pixels(const PixelFormat& format, const uint16_t (*rgba)[4], int count, bool swap_bytes, void* row);
void pack_pixels(const PixelFormat& format, const float (*rgba)[4], int count, bool swap_bytes, void* row);
void pack_pixels(const PixelFormat& format, const int8_t (*rgba)[4], int count, bool swap_bytes, void* row);
void pack_pixels(const PixelFormat& format, const int16_t (*rgba)[4], int count, bool swap_bytes, void* row);

/// Indexes (GL_COLOR_INDEX, GL_STENCIL_INDEX): whole numbers, of floats their integer part. `bit_offset` and
/// `lsb_first` are of GL_BITMAP only.
void unpack_indexes(const PixelFormat& format, const void* row, int bit_offset, int count, bool swap_bytes,
                    bool lsb_first, uint32_t* index);

/// Depth as floats in [0,1] before the pixel transfer, and from floats in [0,1].
void unpack_depth(const PixelFormat& format, const void* row, int count, bool swap_bytes, float* depth);
void pack_depth(const PixelFormat& format, const float* depth, int count, bool swap_bytes, void* row);

/// A pixel of GL_DEPTH_STENCIL. Its depth is a number of 24 bits, or a float.
struct DepthStencilPixel {
  bool integer = true;
  uint32_t bits = 0; // the integer
  float depth = 0;   // the float; of an integer the nearest one
  uint32_t stencil = 0;
};
DepthStencilPixel unpack_depth_stencil(const PixelFormat& format, const void* pixel, bool swap_bytes);
/// A row of them: the depths as floats.
void unpack_depths_and_stencils(const PixelFormat& format, const void* row, int count, bool swap_bytes,
                                float* depth, uint8_t* stencil);
/// As OSMesa 22.3.6 does, cuts a float that becomes an integer.
void pack_depth_stencil(const PixelFormat& format, const DepthStencilPixel& value, bool swap_bytes,
                        void* pixel);

} // namespace softgl
