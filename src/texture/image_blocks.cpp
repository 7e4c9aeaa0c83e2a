// Images of compressed formats: their texels are always what their blocks say.
#include <algorithm>
#include <cstring>

#include "texture/texture_object.h"

namespace softgl {

namespace {

/// Calls visit(x, y, z) for the first texel of each block of `width` columns that the box touches.
template <class Visit> void for_each_block(int width, const TexelBox& box, Visit&& visit) {
  const int left = box.x / width * width, bottom = box.y / kBlockHeight * kBlockHeight;
  for (int z = box.z; z < box.z + box.depth; ++z)
    for (int y = bottom; y < box.y + box.height; y += kBlockHeight)
      for (int x = left; x < box.x + box.width; x += width) visit(x, y, z);
}

void decode(BlockFormat format, const uint8_t* block, uint8_t (*rgba)[4]) {
  decode_block(format, block, rgba);
}
void decode(BlockFormat format, const uint8_t* block, int16_t (*rgba)[4]) {
  decode_signed_block(format, block, rgba);
}
void encode(BlockFormat format, const uint8_t (*rgba)[4], uint8_t* block) {
  encode_block(format, rgba, block);
}
void encode(BlockFormat format, const int16_t (*rgba)[4], uint8_t* block) {
  encode_signed_block(format, rgba, block);
}

/// Texels of one block, whose first is at x, y, z. T: of which its components are.
template <class T> void decode_texels(TextureImage& image, int x, int y, int z) {
  T rgba[kMostBlockTexels][4];
  decode(image.format->block, image.block_at(x, y, z), rgba);
  const int width = block_width(image.format->block), columns = std::min(width, image.width - x),
            rows = std::min(kBlockHeight, image.height - y);
  for (int j = 0; j < rows; ++j)
    std::memcpy(image.at(x, y + j, z), rgba[j * width], sizeof rgba[0] * size_t(columns));
}

template <class T> void encode_texels(TextureImage& image, int x, int y, int z) {
  T rgba[kMostBlockTexels][4];
  const int width = block_width(image.format->block);
  for (int j = 0; j < kBlockHeight; ++j)
    for (int i = 0; i < width; ++i) // beyond the edges the texels at the edge count once more
      std::memcpy(rgba[j * width + i],
                  image.at(std::min(x + i, image.width - 1), std::min(y + j, image.height - 1), z),
                  sizeof rgba[0]);
  encode(image.format->block, rgba, image.block_at(x, y, z));
}

} // namespace

void TextureImage::decode_blocks(const TexelBox& box) {
  for_each_block(block_width(format->block), box, [&](int x, int y, int z) {
    format->layout == TexelLayout::Rgba8 ? decode_texels<uint8_t>(*this, x, y, z)
                                         : decode_texels<int16_t>(*this, x, y, z);
  });
}

void TextureImage::encode_blocks(const TexelBox& box) {
  for_each_block(block_width(format->block), box, [&](int x, int y, int z) {
    format->layout == TexelLayout::Rgba8 ? encode_texels<uint8_t>(*this, x, y, z)
                                         : encode_texels<int16_t>(*this, x, y, z);
  });
  decode_blocks(box);
}

} // namespace softgl
