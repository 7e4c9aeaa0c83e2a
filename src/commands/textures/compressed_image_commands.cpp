// CompressedTexImage, CompressedTexSubImage and GetCompressedTexImage (GL 1.5, 3.8.3, 6.1.4).
// All compressed formats have images of two dimensions alone.
#include <cstring>

#include "commands/buffers/pixel_buffers.h"
#include "commands/generated/commands.h"
#include "commands/textures/texture_images.h"
#include "context/context.h"

namespace softgl {
namespace {

/// Null where the format is none, or a generic one, whose blocks nobody knows.
const TexelFormat* compressed_format(GLenum internal_format) {
  const TexelFormat* f = choose_texel_format(GLint(internal_format), 0, 0, false);
  return f && f->block != BlockFormat::None ? f : nullptr;
}

uint64_t compressed_bytes(const TexelFormat& format, GLsizei width, GLsizei height) {
  const auto along = [](GLsizei texels, int size) {
    return (uint64_t(texels) + uint64_t(size) - 1) / uint64_t(size);
  };
  return along(width, block_width(format.block)) * along(height, kBlockHeight) *
         uint64_t(block_bytes(format.block));
}

void specify_compressed(Context& c, GLenum target, GLint level, GLenum internal_format, GLsizei width,
                        GLsizei height, GLint border, GLsizei image_size, const void* data) {
  const ImageTarget t = image_target(target, 2);
  const TexelFormat* format = compressed_format(internal_format);
  if (!t.valid()) return set_error(c, GL_INVALID_ENUM, "target");
  if (!format || !takes_target(*format, t.target)) return set_error(c, GL_INVALID_ENUM, "internalformat");
  if (const Refusal refusal = check_level(t, level)) return set_error(c, refusal);
  if (const Refusal refusal = check_signs(width, height, 1)) return set_error(c, refusal);
  if (image_size < 0) return set_error(c, GL_INVALID_VALUE, "imageSize");
  if (border != 0) return set_error(c, GL_INVALID_OPERATION);
  if (uint64_t(image_size) != compressed_bytes(*format, width, height))
    return set_error(c, GL_INVALID_VALUE, "imageSize");
  const auto object = target_object(c, t);
  if (object->immutable_levels) return set_error(c, GL_INVALID_OPERATION);
  const Refusal wrong_size = check_image_size(t, level, width, height, 1, 0);
  const bool fits = !wrong_size && image_bytes(*format, width, height, 1) <= kMaxImageBytes;
  if (t.proxy) {
    object->image[0][level] = nullptr;
    if (fits)
      object->image[0][level] =
          describe_image(*format, granted_format(GLint(internal_format)), width, height, 1);
    return;
  }
  if (wrong_size) return set_error(c, wrong_size);
  if (!fits) return set_error(c, GL_OUT_OF_MEMORY);
  if (!find_unpack_memory(c, data, array_span(size_t(image_size), 1))) return;
  auto image = make_image(*format, granted_format(GLint(internal_format)), width, height, 1);
  mark_images(c, *object);
  if (data && !image->empty()) std::memcpy(image->blocks.data(), data, image->blocks.size());
  image->blocks_changed(image->whole());
  object->image[t.face][level] = std::move(image);
  regenerate_mipmaps(*object, t.face, level);
}

void change_compressed(Context& c, GLenum target, GLint level, GLint x, GLint y, GLsizei width,
                       GLsizei height, GLenum format, GLsizei image_size, const void* data) {
  const ImageTarget t = image_target(target, 2);
  if (!t.valid() || t.proxy || t.target == kTextureRectangle) return set_error(c, GL_INVALID_ENUM, "target");
  if (granted_format(GLint(format)) != GLint(format))
    return set_error(c, GL_INVALID_ENUM, "format"); // a generic one
  if (const Refusal refusal = check_level(t, level)) return set_error(c, refusal);
  if (const Refusal refusal = check_signs(width, height, 1)) return set_error(c, refusal);
  if (image_size < 0) return set_error(c, GL_INVALID_VALUE, "imageSize");
  const auto object = target_object(c, t);
  const TextureImage* image = object->image[t.face][level].get();
  if (!image || image->format->block == BlockFormat::None || GLint(format) != image->internal_format)
    return set_error(c, GL_INVALID_OPERATION);
  if (uint64_t(image_size) != compressed_bytes(*image->format, width, height))
    return set_error(c, GL_INVALID_VALUE, "imageSize");
  if (const Refusal refusal = check_box(*image, x, y, 0, width, height, 1)) return set_error(c, refusal);
  if (!whole_blocks(*image, x, y, width, height)) return set_error(c, GL_INVALID_OPERATION);
  if (width == 0 || height == 0) return;
  if (!find_unpack_memory(c, data, array_span(size_t(image_size), 1)) || !data) return;
  TextureImage& changed = image_for_change(c, *object, t.face, level);
  mark_images(c, *object);
  const size_t row =
      size_t(blocks_in_row(changed.format->block, width)) * size_t(block_bytes(changed.format->block));
  auto from = static_cast<const uint8_t*>(data);
  for (int j = 0; j < height; j += kBlockHeight, from += row)
    std::memcpy(changed.block_at(x, y + j, 0), from, row);
  changed.blocks_changed({x, y, 0, width, height, 1});
  regenerate_mipmaps(*object, t.face, level);
}

} // namespace

namespace gl {

// No compressed format has one dimension or three.
void CompressedTexImage1D(Context& c, GLenum, GLint, GLenum, GLsizei, GLint, GLsizei, const void*) {
  set_error(c, GL_INVALID_ENUM, "internalformat");
}
void CompressedTexImage3D(Context& c, GLenum, GLint, GLenum, GLsizei, GLsizei, GLsizei, GLint, GLsizei,
                          const void*) {
  set_error(c, GL_INVALID_ENUM, "internalformat");
}
void CompressedTexSubImage1D(Context& c, GLenum, GLint, GLint, GLsizei, GLenum, GLsizei, const void*) {
  set_error(c, GL_INVALID_ENUM, "format");
}
void CompressedTexSubImage3D(Context& c, GLenum, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei,
                             GLenum, GLsizei, const void*) {
  set_error(c, GL_INVALID_ENUM, "format");
}

void CompressedTexImage2D(Context& c, GLenum target, GLint level, GLenum internalformat, GLsizei width,
                          GLsizei height, GLint border, GLsizei imageSize, const void* data) {
  specify_compressed(c, target, level, internalformat, width, height, border, imageSize, data);
}
void CompressedTexSubImage2D(Context& c, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                             GLsizei width, GLsizei height, GLenum format, GLsizei imageSize,
                             const void* data) {
  change_compressed(c, target, level, xoffset, yoffset, width, height, format, imageSize, data);
}

void GetCompressedTexImage(Context& c, GLenum target, GLint level, void* pixels) {
  const ImageTarget t = any_image_target(target);
  if (!t.valid() || t.proxy) return set_error(c, GL_INVALID_ENUM, "target");
  if (level < 0 || level >= max_texture_levels(t.target)) return set_error(c, GL_INVALID_VALUE, "level");
  const auto object = target_object(c, t);
  const TextureImage* image = object->image[t.face][level].get();
  if (!image || image->format->block == BlockFormat::None) return set_error(c, GL_INVALID_OPERATION);
  if (image->empty() || !find_pack_memory(c, pixels, array_span(image->blocks.size(), 1)) || !pixels) return;
  std::memcpy(pixels, image->blocks.data(), image->blocks.size());
}

} // namespace gl
} // namespace softgl
