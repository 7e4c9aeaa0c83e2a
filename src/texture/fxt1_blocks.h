// Blocks of GL_3DFX_texture_compression_FXT1: 8x4 texels in 16 bytes, in one of four ways.
#pragma once

#include <cstdint>

namespace softgl {

/// The 32 texels, row by row. Without `alpha` all are opaque.
void decode_fxt1_block(const uint8_t* block, bool alpha, uint8_t (*rgba)[4]);
/// A block that comes near to 32 texels, row by row. Without `alpha` their own does not matter.
void encode_fxt1_block(const uint8_t (*rgba)[4], bool alpha, uint8_t* block);

} // namespace softgl
