// Images of compressed formats: their texels are always what their blocks say.
#include <algorithm>
#include <cstring>

#include "texture/texture_object.h"

namespace softgl {

namespace {

/// Calls visit(x, y, z) for the first texel of each block that the box touches.
template <class Visit> void for_each_block(const TexelBox& box, Visit&& visit) {
  const int left = box.x / kBlockSize * kBlockSize, bottom = box.y / kBlockSize * kBlockSize;
  for (int z = box.z; z < box.z + box.depth; ++z)
    for (int y = bottom; y < box.y + box.height; y += kBlockSize)
      for (int x = left; x < box.x + box.width; x += kBlockSize) visit(x, y, z);
}

void store_block_texels(TextureImage& image, int x, int y, int z, const uint8_t (*rgba)[4]) {
  const int columns = std::min(kBlockSize, image.width - x), rows = std::min(kBlockSize, image.height - y);
  for (int j = 0; j < rows; ++j)
    std::memcpy(image.at(x, y + j, z), rgba[j * kBlockSize], 4 * size_t(columns));
}

} // namespace

void TextureImage::decode_blocks(const TexelBox& box) {
  for_each_block(box, [&](int x, int y, int z) {
    uint8_t rgba[kBlockTexels][4];
    decode_block(format->block, block_at(x, y, z), rgba);
    store_block_texels(*this, x, y, z, rgba);
  });
}

void TextureImage::encode_blocks(const TexelBox& box) {
  for_each_block(box, [&](int x, int y, int z) {
    uint8_t rgba[kBlockTexels][4];
    for (int j = 0; j < kBlockSize; ++j)
      for (int i = 0; i < kBlockSize; ++i) // beyond the edges the texels at the edge count once more
        std::memcpy(rgba[j * kBlockSize + i], at(std::min(x + i, width - 1), std::min(y + j, height - 1), z),
                    4);
    encode_block(format->block, rgba, block_at(x, y, z));
    decode_block(format->block, block_at(x, y, z), rgba);
    store_block_texels(*this, x, y, z, rgba);
  });
}

} // namespace softgl
