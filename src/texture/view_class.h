// Which internal formats have the same bits in another meaning (GL_ARB_copy_image, table 4.X.1;
// GL_ARB_texture_view, table 3.X.2).
#pragma once

#include "base/gl_types.h"

namespace softgl {

/// Formats of one class are copied into each other bit by bit.
enum class ViewClass : uint8_t {
  None,
  Bits128,
  Bits96,
  Bits64,
  Bits48,
  Bits32,
  Bits24,
  Bits16,
  Bits8,
  Rgtc1,
  Rgtc2,
  S3tcDxt1Rgb,
  S3tcDxt1Rgba,
  S3tcDxt3,
  S3tcDxt5
};

struct ViewFormat {
  GLenum internal_format;
  ViewClass view_class;
  GLenum format, type; // of client pixels that are the texel's bits; 0 of compressed formats
};

/// Null for a format of no class.
const ViewFormat* view_format(GLenum internal_format);
/// Bytes of a block of compressed formats that a texel of uncompressed ones may become, or of such a texel;
/// 0: of no such class (table 4.X.1).
int block_copy_bytes(ViewClass view_class);

} // namespace softgl
