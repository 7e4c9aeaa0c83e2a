// How texels are stored (GL 1.5, 3.8.1, tables 3.15 to 3.17): the same precision as OSMesa keeps, in three
// layouts that the sampling kernels read.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/gl_types.h"
#include "texture/block_compression.h"
#include "texture/byte_texels.h"

namespace softgl {

constexpr int kTexelRow = 256; // texels converted at a time

/// Rgba8: four bytes r g b a; components of fewer bits fill a byte by repeating their bits, as OSMesa's 8-bit
/// sampling does, so the upper bits are the stored value. Rgba16: four uint16_t, each the stored integer
/// itself. Signed16: the same, int16_t. Depth: uint32_t, the stored integer itself, or the bits of a float
/// (`floats`). Float: four floats, which have the precision of the format. Luminance and intensity are
/// already spread over r, g, b (and a); what a base format lacks is 0, or one for alpha.
enum class TexelLayout : uint8_t { Rgba8, Rgba16, Depth, Signed16, Float };

struct TexelFormat {
  GLenum base; // GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RED, GL_RG, GL_RGB, GL_RGBA,
               // GL_DEPTH_COMPONENT, GL_DEPTH_STENCIL (its stencil values lie beside the texels)
  TexelLayout layout;
  bool array;          // components are whole bytes or shorts: OSMesa converts them one by one
  uint8_t bits[4];     // stored bits of r g b a; 0 = not stored. Depth: bits[0]
  bool floats = false; // of Depth
  BlockFormat block = BlockFormat::None; // compressed: texels are what the blocks are decoded to
  bool srgb = false; // of Rgba8: red, green, blue and luminance are not linear (GL_EXT_texture_sRGB)
  int bytes() const {
    switch (layout) {
    case TexelLayout::Rgba16:
    case TexelLayout::Signed16: return 8;
    case TexelLayout::Float: return 16;
    default: return 4;
    }
  }
  /// Of Float: what is left of colors when they are stored. Halves are the next ones towards zero, or the
  /// nearest.
  void reduce(float (*rgba)[4], int count, bool to_nearest) const;
};

/// The storage that OSMesa chooses for an internal format; unsized formats look at the client's format and
/// type too. Null when `internal_format` is none.
const TexelFormat* choose_texel_format(GLint internal_format, GLenum format, GLenum type, bool swap_bytes);
/// The base internal format (table 3.15), 0 when `internal_format` is none.
GLenum base_internal_format(GLint internal_format);

struct PixelFormat;
struct PixelTransfer; // pixel_transfer.h

/// Stores a row of client pixels. Pixel transfer operations are applied.
void store_texels(const TexelFormat& to, void* texels, const PixelFormat& from, const void* pixels, int count,
                  bool swap_bytes, const PixelTransfer& transfer);
/// The same of color indexes, which become colors by shift, offset and maps (3.6.5). `bit_offset` and
/// `lsb_first` are of GL_BITMAP only.
void store_color_indexes(const TexelFormat& to, void* texels, const PixelFormat& from, const void* pixels,
                         int bit_offset, int count, bool swap_bytes, bool lsb_first,
                         const PixelTransfer& transfer);
/// Stores many rows of client pixels alike.
class TexelRows {
public:
  /// `pixels`: how many there will be, of all rows together. The references must live as long as this.
  TexelRows(const TexelFormat& to, const PixelFormat& from, bool swap_bytes, const PixelTransfer& transfer,
            uint64_t pixels);
  void store(void* texels, const void* pixels, int count) const;

private:
  const TexelFormat& to_;
  const PixelFormat& from_;
  bool swap_bytes_;
  const PixelTransfer& transfer_;
  ByteTexels bytes_;
  bool takes_bytes_ = false;
  int table_components_ = 0; // 0: there is no table
  uint32_t table_[2][256];   // a texel is the exclusive or of its pixel's components' words
};
/// The same of GL_DEPTH_STENCIL pixels, whose stencil values go to a row of their own.
void store_depth_stencil(const TexelFormat& to, uint32_t* texels, uint8_t* stencils, const PixelFormat& from,
                         const void* pixels, int count, bool swap_bytes, const PixelTransfer& transfer);
void load_depth_stencil(const TexelFormat& from, const uint32_t* texels, const uint8_t* stencils,
                        const PixelFormat& to, void* pixels, int count, bool swap_bytes);
/// Reads a row of texels into client pixels (GetTexImage, 6.1.4); no pixel transfer takes place.
void load_texels(const TexelFormat& from, const void* texels, const PixelFormat& to, void* pixels, int count,
                 bool swap_bytes);

} // namespace softgl
