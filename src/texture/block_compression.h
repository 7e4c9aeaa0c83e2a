// Compressed texels: blocks of 4x4 texels of a few bytes each (GL_EXT_texture_compression_s3tc).
#pragma once

#include <cstdint>

namespace softgl {

enum class BlockFormat : uint8_t { None, Dxt1Rgb, Dxt1Rgba, Dxt3, Dxt5 };

constexpr int kBlockSize = 4; // texels along an edge
constexpr int kBlockTexels = kBlockSize * kBlockSize;

constexpr int block_bytes(BlockFormat format) {
  return format == BlockFormat::Dxt1Rgb || format == BlockFormat::Dxt1Rgba ? 8 : 16;
}
/// How many blocks cover so many texels.
constexpr int blocks_along(int texels) { return (texels + kBlockSize - 1) / kBlockSize; }

/// The 16 texels of a block, row by row, each red, green, blue, alpha.
void decode_block(BlockFormat format, const uint8_t* block, uint8_t (*rgba)[4]);
/// A block that comes near to 16 texels. Those of Dxt1Rgba with an alpha below one half become transparent
/// black.
void encode_block(BlockFormat format, const uint8_t (*rgba)[4], uint8_t* block);

} // namespace softgl
