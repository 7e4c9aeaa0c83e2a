// Compressed texels: blocks of a few bytes each, of 4x4 texels (GL_EXT_texture_compression_s3tc,
// GL_ARB_texture_compression_rgtc, GL_EXT_texture_compression_latc) or of 8x4
// (GL_3DFX_texture_compression_FXT1).
#pragma once

#include <cstdint>

namespace softgl {

enum class BlockFormat : uint8_t {
  None,
  Dxt1Rgb,
  Dxt1Rgba,
  Dxt3,
  Dxt5,
  Red,
  RedGreen,
  Luminance,
  LuminanceAlpha,
  Fxt1Rgb,
  Fxt1Rgba
};

/// Texels of a row of a block.
constexpr int block_width(BlockFormat format) {
  return format == BlockFormat::Fxt1Rgb || format == BlockFormat::Fxt1Rgba ? 8 : 4;
}
constexpr int kBlockHeight = 4;
constexpr int kBlockTexels = 16; // but for those of FXT1:
constexpr int kMostBlockTexels = 32;

constexpr int block_bytes(BlockFormat format) {
  switch (format) {
  case BlockFormat::Dxt1Rgb:
  case BlockFormat::Dxt1Rgba:
  case BlockFormat::Red:
  case BlockFormat::Luminance: return 8;
  default: return 16;
  }
}
/// How many blocks cover a row and a column of so many texels.
constexpr int blocks_in_row(BlockFormat format, int texels) {
  return (texels - 1 + block_width(format)) / block_width(format);
}
constexpr int blocks_in_column(int texels) { return (texels - 1 + kBlockHeight) / kBlockHeight; }

/// The texels of a block, row by row, each red, green, blue, alpha.
void decode_block(BlockFormat format, const uint8_t* block, uint8_t (*rgba)[4]);
/// A block that comes near to these texels. Those of Dxt1Rgba with an alpha below one half become transparent
/// black.
void encode_block(BlockFormat format, const uint8_t (*rgba)[4], uint8_t* block);

/// The same of the formats from Red on with components from -128 to 127, which mean -1 to 1. A component that
/// is absent becomes 0, an alpha 1.
void decode_signed_block(BlockFormat format, const uint8_t* block, int16_t (*rgba)[4]);
void encode_signed_block(BlockFormat format, const int16_t (*rgba)[4], uint8_t* block);

} // namespace softgl
