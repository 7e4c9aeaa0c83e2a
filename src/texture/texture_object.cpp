#include "texture/texture_object.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "base/assert.h"
#include "shaders/common/seeded_faults.h"
#include "texture/pixel_formats.h"
#include "texture/pixel_transfer.h"

namespace softgl {

uint64_t image_bytes(const TexelFormat& format, int width, int height, int depth) {
  return uint64_t(width + 1) * uint64_t(height + 1) * uint64_t(depth) * uint64_t(format.bytes());
}

std::shared_ptr<TextureImage> make_image(const TexelFormat& format, GLint internal_format, int width,
                                         int height, int depth, ImageBorder border) {
  auto image = std::make_shared<TextureImage>();
  SOFTGL_ASSERT(width >= 0 && height >= 0 && depth >= 0);
  image->format = &format;
  image->internal_format = internal_format;
  image->width = width;
  image->height = height;
  image->depth = depth;
  image->border = border;
  image->row_bytes = size_t(width + 2 * border.x + 1) * size_t(format.bytes());
  image->slice_bytes = size_t(height + 2 * border.y + 1) * image->row_bytes;
  image->origin = size_t(border.z) * image->slice_bytes + size_t(border.y) * image->row_bytes +
                  size_t(border.x) * size_t(format.bytes());
  if (!image->empty()) image->texels = TexelMemory(image->slice_bytes * size_t(depth + 2 * border.z) + 16);
  if (format.block != BlockFormat::None)
    image->blocks.resize(image->block_row_bytes() * size_t(blocks_in_column(height)) * size_t(depth));
  const TexelBox box = image->with_border();
  if (format.base == GL_DEPTH_STENCIL)
    image->stencils.resize(size_t(box.width) * size_t(box.height) * size_t(box.depth));
  return image;
}

void TextureImage::fill_absent_alpha() {
  if (!blocks.empty()) return decode_blocks(whole());
  if (format->bits[3] || format->layout == TexelLayout::Depth) return;
  const size_t step = size_t(format->bytes());
  if (format->layout == TexelLayout::Rgba8)
    for (size_t i = 3; i < texels.size(); i += step) texels.data()[i] = 255;
  else if (format->layout == TexelLayout::Float)
    for (size_t i = 12; i < texels.size(); i += step) {
      const float one = 1;
      std::memcpy(texels.data() + i, &one, sizeof one);
    }
  else
    for (size_t i = 6; i < texels.size(); i += step)
      texels.data()[i] = 1; // what absent components are stored as
}

void TextureImage::texels_changed(const TexelBox& box) {
  if (!blocks.empty()) encode_blocks(box);
  finish_change();
}

void TextureImage::blocks_changed(const TexelBox& box) {
  decode_blocks(box);
  finish_change();
}

void TextureImage::finish_change() {
  repeat_edges();
  blank = false;
  for (DrawnSlice& slice : slices) slice.texels_newer = true;
}

void TextureImage::repeat_edges() {
  if (empty() || border != ImageBorder{}) return;
  const size_t texel = size_t(format->bytes());
  for (int z = 0; z < depth; ++z) {
    for (int y = 0; y < height; ++y) std::memcpy(at(width, y, z), at(0, y, z), texel);
    std::memcpy(at(0, height, z), at(0, 0, z), row_bytes);
  }
}

TextureImage& TextureObject::writable(int face, int level) {
  auto& pointer = image[face][level];
  if (pointer.use_count() > 1) pointer = std::make_shared<TextureImage>(*pointer);
  return *pointer;
}

const TexelFormat& level_format(const TextureObject& object, int face, int level, GLint internal_format,
                                const TexelFormat& chosen) {
  const TextureImage* before = level > 0 ? object.image[face][level - 1].get() : nullptr;
  return before && before->width > 0 && before->internal_format == internal_format ? *before->format : chosen;
}

void match_formats(TextureObject& object, const TextureImage& image) {
  const bool depth = image.format->layout == TexelLayout::Depth;
  const PixelFormat client =
      describe_pixel_format(depth ? GL_DEPTH_COMPONENT : GL_RGBA, depth ? GL_UNSIGNED_INT : GL_FLOAT);
  std::vector<unsigned char> row;
  for (auto& face : object.image)
    for (auto& other : face) {
      if (!other || other->internal_format != image.internal_format || other->format == image.format)
        continue;
      auto converted = make_image(*image.format, other->internal_format, other->width, other->height,
                                  other->depth, other->border);
      const TexelBox box = other->with_border();
      row.resize(size_t(box.width) * size_t(client.bytes));
      for (int z = 0; !other->empty() && z < box.depth; ++z)
        for (int y = 0; y < box.height; ++y) {
          load_texels(*other->format, other->at(box.x, box.y + y, box.z + z), client, row.data(), box.width,
                      false);
          store_texels(*image.format, converted->at(box.x, box.y + y, box.z + z), client, row.data(),
                       box.width, false, PixelTransfer::none());
        }
      converted->texels_changed();
      other = std::move(converted);
    }
}

bool uses_mipmaps(GLenum min_filter) { return min_filter != GL_NEAREST && min_filter != GL_LINEAR; }

CompleteLevels complete_levels(const TextureObject& object, GLenum min_filter) {
  const int first = SOFTGL_FAULT(base_level_ignored) ? 0 : object.base_level(),
            max_level = object.max_level();
  if (first < 0 || first >= kMaxTextureLevels) return {};
  const TextureImage* base = object.image[0][first].get();
  if (!base || base->empty()) return {};
  const int faces = object.target == kTextureCube ? 6 : 1;
  if (faces == 6 && base->width != base->height) return {};
  const int size = std::max({base->width, base->height, base->depth});
  int last = first;
  if (uses_mipmaps(min_filter)) {
    if (object.target == kTextureRectangle || max_level < first) return {};
    for (int s = size; s > 1 && last < max_level; s >>= 1) ++last;
    if (last >= kMaxTextureLevels) return {};
  }
  for (int face = 0; face < faces; ++face)
    for (int level = first; level <= last; ++level) {
      const TextureImage* image = object.image[face][level].get();
      const int shift = level - first;
      if (!image || image->format != base->format || image->internal_format != base->internal_format)
        return {};
      if (SOFTGL_FAULT(incomplete_is_sampled)) continue;
      if (image->border != base->border || image->width != std::max(1, base->width >> shift) ||
          image->height != std::max(1, base->height >> shift) ||
          image->depth != std::max(1, base->depth >> shift))
        return {};
    }
  return {first, last - first + 1};
}

} // namespace softgl
