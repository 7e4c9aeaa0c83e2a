// Compressed texels: blocks of 4x4 texels of a few bytes each (GL_EXT_texture_compression_s3tc,
// GL_ARB_texture_compression_rgtc, GL_EXT_texture_compression_latc).
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
  LuminanceAlpha
};

constexpr int kBlockSize = 4; // texels along an edge
constexpr int kBlockTexels = kBlockSize * kBlockSize;

constexpr int block_bytes(BlockFormat format) {
  switch (format) {
  case BlockFormat::Dxt1Rgb:
  case BlockFormat::Dxt1Rgba:
  case BlockFormat::Red:
  case BlockFormat::Luminance: return 8;
  default: return 16;
  }
}
/// How many blocks cover so many texels.
constexpr int blocks_along(int texels) { return (texels + kBlockSize - 1) / kBlockSize; }

/// The 16 texels of a block, row by row, each red, green, blue, alpha.
void decode_block(BlockFormat format, const uint8_t* block, uint8_t (*rgba)[4]);
/// A block that comes near to 16 texels. Those of Dxt1Rgba with an alpha below one half become transparent
/// black.
void encode_block(BlockFormat format, const uint8_t (*rgba)[4], uint8_t* block);

/// The same of the formats from Red on with components from -128 to 127, which mean -1 to 1. A component that
/// is absent becomes 0, an alpha 1.
void decode_signed_block(BlockFormat format, const uint8_t* block, int16_t (*rgba)[4]);
void encode_signed_block(BlockFormat format, const int16_t (*rgba)[4], uint8_t* block);

} // namespace softgl
