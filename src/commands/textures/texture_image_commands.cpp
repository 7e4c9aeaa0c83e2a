// TexImage, TexSubImage and GetTexImage (GL 1.5, 3.8.1, 3.8.2, 6.1.4).

#include "commands/buffers/pixel_buffers.h"
#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "commands/textures/texture_images.h"
#include "context/context.h"
#include "context/pixel_transfer.h"
#include "shaders/common/seeded_faults.h"
#include "snapshot/render_targets.h"
#include "texture/pixel_formats.h"

namespace softgl {

Refusal check_level(const ImageTarget& t, GLint level) {
  const bool wrong = level < 0 || level >= max_texture_levels(t.target);
  return wrong ? Refusal{GL_INVALID_VALUE, "level"} : Refusal{};
}

Refusal check_signs(GLsizei width, GLsizei height, GLsizei depth) {
  const char* wrong = first_wrong({{"width", width < 0}, {"height", height < 0}, {"depth", depth < 0}});
  return wrong ? Refusal{GL_INVALID_VALUE, wrong} : Refusal{};
}

Refusal check_border(GLint border) {
  return border < 0 || border > 1 ? Refusal{GL_INVALID_VALUE, "border"} : Refusal{};
}

Refusal check_image_size(const ImageTarget& t, GLint level, GLsizei width, GLsizei height, GLsizei depth,
                         GLint border) {
  if (const Refusal refusal = check_level(t, level)) return refusal;
  if (border != 0 && t.target == kTextureRectangle) return {GL_INVALID_VALUE, "border"};
  if (const Refusal refusal = check_border(border)) return refusal;
  const int largest = max_texture_size(t.target) >> level;
  // Any size will do: GL_ARB_texture_non_power_of_two.
  auto legal = [&](GLsizei size, bool bordered) {
    const int b = bordered ? border : 0;
    return size >= 2 * b && size - 2 * b <= largest;
  };
  const bool two = t.target != kTexture1D, three = t.target == kTexture3D;
  const char* wrong = first_wrong({{"width", !legal(width, true)},
                                   {"height", two && !legal(height, true)},
                                   {"depth", three && !legal(depth, true)},
                                   {"height", t.target == kTextureCube && width != height}});
  return wrong ? Refusal{GL_INVALID_VALUE, wrong} : Refusal{};
}

void mark_images(Context& c, const TextureObject& object) {
  c.dirty |= kDirtyTextureObjects;
  if (is_attached(c, object)) framebuffers_changed(c);
}

TextureImage& image_for_change(Context& c, TextureObject& object, int face, int level) {
  // A copy of 1 MB takes twice as long as to draw a small frame.
  constexpr uint64_t kLarge = 256 * 1024;
  const auto& image = object.image[face][level];
  if (image.use_count() > 1 &&
      image_bytes(*image->format, image->width, image->height, image->depth) >= kLarge) {
    draw_what_waits(c);
    store_drawn_texels(object);
  }
  return object.writable(face, level);
}

GLint granted_format(GLint internal_format) {
  switch (internal_format) {
  case GL_COMPRESSED_ALPHA:
  case GL_COMPRESSED_LUMINANCE:
  case GL_COMPRESSED_LUMINANCE_ALPHA:
  case GL_COMPRESSED_INTENSITY:
  case GL_COMPRESSED_RGB:
  case GL_COMPRESSED_RGBA:
  case GL_COMPRESSED_RED:
  case GL_COMPRESSED_RG:
  case GL_COMPRESSED_SRGB:
  case GL_COMPRESSED_SRGB_ALPHA:
  case GL_COMPRESSED_SLUMINANCE:
  case GL_COMPRESSED_SLUMINANCE_ALPHA: return GLint(base_internal_format(internal_format));
  case GL_RGB_S3TC:
  case GL_RGB4_S3TC: return GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
  case GL_RGBA_S3TC:
  case GL_RGBA4_S3TC: return GL_COMPRESSED_RGBA_S3TC_DXT3_EXT;
  default: return internal_format;
  }
}

bool takes_target(const TexelFormat& format, TextureTarget target) {
  return format.block == BlockFormat::None || target == kTexture2D || target == kTextureCube;
}

bool whole_blocks(const TextureImage& image, GLint x, GLint y, GLsizei width, GLsizei height) {
  if (image.format->block == BlockFormat::None) return true;
  const int columns = block_width(image.format->block);
  return x % columns == 0 && y % kBlockHeight == 0 && (width % columns == 0 || x + width == image.width) &&
         (height % kBlockHeight == 0 || y + height == image.height);
}

std::shared_ptr<TextureImage> describe_image(const TexelFormat& format, GLint internal_format, GLsizei width,
                                             GLsizei height, GLsizei depth, ImageBorder border) {
  auto image = std::make_shared<TextureImage>();
  image->format = &format, image->internal_format = internal_format;
  image->border = border;
  image->width = width - 2 * border.x, image->height = height - 2 * border.y,
  image->depth = depth - 2 * border.z;
  return image;
}

void regenerate_mipmaps(TextureObject& object, int face, int level) {
  if (object.parameters.generate_mipmap && level == object.base_level()) generate_mipmaps(object, face);
}

namespace {

// Texels of a box from client memory; the pointer and the offset of bits are already past the skipped pixels.
void store_box(Context& c, TextureImage& image, int x, int y, int z, int width, int height, int depth,
               const PixelFormat& format, const ImageLayout& layout, const unsigned char* pixels) {
  const PixelStore& store = c.client.pixel_store.unpack;
  const PixelTransfer transfer = pixel_transfer(c);
  const TexelRows rows(*image.format, format, store.swap_bytes, transfer,
                       format.format == GL_COLOR_INDEX || format.format == GL_DEPTH_STENCIL
                           ? 0
                           : uint64_t(width) * uint64_t(height) * uint64_t(depth));
  for (int k = 0; k < depth; ++k)
    for (int j = 0; j < height; ++j) {
      void* const texels = image.at(x, y + j, z + k);
      const unsigned char* row = pixels + size_t(k) * layout.image_stride + size_t(j) * layout.row_stride;
      if (format.format == GL_COLOR_INDEX)
        store_color_indexes(*image.format, texels, format, row, layout.bit_offset, width, store.swap_bytes,
                            store.lsb_first, transfer);
      else if (format.format == GL_DEPTH_STENCIL)
        store_depth_stencil(*image.format, static_cast<uint32_t*>(texels), image.stencil_at(x, y + j, z + k),
                            format, row, width, store.swap_bytes, transfer);
      else
        rows.store(texels, row, width);
    }
  image.texels_changed({x, y, z, width, height, depth});
}

Refusal check_format(GLint internal_format, GLenum format, GLenum type) {
  if (const Refusal refusal = check_pixel_format(format, type)) return refusal;
  if (format == GL_STENCIL_INDEX) return {GL_INVALID_ENUM, "format"};
  const GLenum base = base_internal_format(internal_format);
  if (base == 0) return {GL_INVALID_VALUE, "internalformat"};
  return same_kind(base, format) ? Refusal{} : Refusal{GL_INVALID_OPERATION};
}

void specify_image(Context& c, int dimensions, GLenum target, GLint level, GLint internal_format,
                   GLsizei width, GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type,
                   const void* pixels) {
  const ImageTarget t = image_target(target, dimensions);
  if (!t.valid()) return set_error(c, GL_INVALID_ENUM, "target");
  if (const Refusal refusal = check_level(t, level)) return set_error(c, refusal);
  if (const Refusal refusal = check_border(border)) return set_error(c, refusal);
  if (const Refusal refusal = check_signs(width, height, depth)) return set_error(c, refusal);
  if (const Refusal refusal = check_format(internal_format, format, type)) return set_error(c, refusal);
  const auto object = target_object(c, t);
  if (object->immutable_levels) return set_error(c, GL_INVALID_OPERATION);
  const TexelFormat& texel = level_format(
      *object, t.face, level, granted_format(internal_format),
      *choose_texel_format(internal_format, format, type, c.client.pixel_store.unpack.swap_bytes));
  // Cube maps of depths came with GL_EXT_gpu_shader4 and OpenGL 3.0; programs take them for granted.
  if (texel.layout == TexelLayout::Depth && t.target == kTexture3D) return set_error(c, GL_INVALID_OPERATION);
  if (!takes_target(texel, t.target)) return set_error(c, GL_INVALID_ENUM, "internalformat");
  if (border != 0 && texel.block != BlockFormat::None) return set_error(c, GL_INVALID_OPERATION);
  const Refusal wrong_size = check_image_size(t, level, width, height, depth, border);
  const bool fits = !wrong_size && image_bytes(texel, width, height, depth) <= kMaxImageBytes;
  if (t.proxy) {
    object->image[0][level] = nullptr;
    if (fits)
      object->image[0][level] = describe_image(texel, granted_format(internal_format), width, height, depth,
                                               image_border(border, dimensions));
    return;
  }
  if (wrong_size) return set_error(c, wrong_size);
  if (!fits) return set_error(c, GL_OUT_OF_MEMORY);
  const PixelFormat f = describe_pixel_format(format, type);
  ImageLayout layout = layout_image(c.client.pixel_store.unpack, dimensions, width, height, f);
  if (width > 0 && height > 0 && depth > 0 &&
      !find_unpack_memory(c, pixels, image_span(c.client.pixel_store.unpack, layout, height, depth, f)))
    return;
  const ImageBorder given = image_border(border, dimensions), kept = kept_border(c, given);
  auto image = make_image(texel, granted_format(internal_format), width - 2 * given.x, height - 2 * given.y,
                          depth - 2 * given.z, kept);
  mark_images(c, *object);
  match_formats(*object, *image);
  if (pixels && !image->empty()) {
    // Where the border is dropped only the pixels inside are read.
    const ImageBorder left = {given.x - kept.x, given.y - kept.y, given.z - kept.z};
    const auto* p = static_cast<const unsigned char*>(pixels) + layout.offset + size_t(left.x) * f.bytes +
                    size_t(left.y) * layout.row_stride + size_t(left.z) * layout.image_stride;
    if (f.channel == PixelChannel::Bitmap) layout.bit_offset += left.x;
    const TexelBox box = image->with_border();
    store_box(c, *image, box.x, box.y, box.z, box.width, box.height, box.depth, f, layout, p);
  } else {
    image->fill_absent_alpha();
  }
  object->image[t.face][level] = std::move(image);
  regenerate_mipmaps(*object, t.face, level);
}

void change_image(Context& c, int dimensions, GLenum target, GLint level, GLint x, GLint y, GLint z,
                  GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type,
                  const void* pixels) {
  const ImageTarget t = image_target(target, dimensions);
  if (!t.valid() || t.proxy) return set_error(c, GL_INVALID_ENUM, "target");
  if (const Refusal refusal = check_level(t, level)) return set_error(c, refusal);
  if (const Refusal refusal = check_signs(width, height, depth)) return set_error(c, refusal);
  if (const Refusal refusal = check_pixel_format(format, type)) return set_error(c, refusal);
  const auto object = target_object(c, t);
  const TextureImage* image = object->image[t.face][level].get();
  if (!image) return set_error(c, GL_INVALID_OPERATION);
  if (const Refusal refusal = check_box(*image, x, y, z, width, height, depth)) return set_error(c, refusal);
  if (format == GL_STENCIL_INDEX) return set_error(c, GL_INVALID_ENUM, "format");
  if (!same_kind(image->format->base, format)) return set_error(c, GL_INVALID_OPERATION);
  if (!whole_blocks(*image, x, y, width, height)) return set_error(c, GL_INVALID_OPERATION);
  if (width == 0 || height == 0 || depth == 0 || image->empty()) return;
  const PixelFormat f = describe_pixel_format(format, type);
  const ImageLayout layout = layout_image(c.client.pixel_store.unpack, dimensions, width, height, f);
  if (!find_unpack_memory(c, pixels, image_span(c.client.pixel_store.unpack, layout, height, depth, f)) ||
      !pixels)
    return;
  TextureImage& changed = image_for_change(c, *object, t.face, level);
  mark_images(c, *object);
  store_box(c, changed, x, y, z, width, height, depth, f, layout,
            static_cast<const unsigned char*>(pixels) + layout.offset);
  regenerate_mipmaps(*object, t.face, level);
}

} // namespace

bool same_kind(GLenum base, GLenum format) {
  const auto kind = [](GLenum f) {
    return f == GL_DEPTH_COMPONENT || f == GL_DEPTH_STENCIL ? f : GLenum(GL_RGBA);
  };
  return kind(base) == kind(format);
}

Refusal check_box(const TextureImage& image, GLint x, GLint y, GLint z, GLsizei width, GLsizei height,
                  GLsizei depth) {
  const auto begins_outside = [](GLint begin, GLsizei size, int end, int border) {
    return begin < -border || begin > end + border || (begin == end + border && size > 0);
  };
  const ImageBorder b = image.border;
  const char* wrong = first_wrong({{"xoffset", begins_outside(x, width, image.width, b.x)},
                                   {"yoffset", begins_outside(y, height, image.height, b.y)},
                                   {"zoffset", begins_outside(z, depth, image.depth, b.z)},
                                   {"width", int64_t(x) + width > image.width + b.x},
                                   {"height", int64_t(y) + height > image.height + b.y},
                                   {"depth", int64_t(z) + depth > image.depth + b.z}});
  return wrong ? Refusal{GL_INVALID_VALUE, wrong} : Refusal{};
}

namespace gl {

void TexImage1D(Context& c, GLenum target, GLint level, GLint internalformat, GLsizei width, GLint border,
                GLenum format, GLenum type, const void* pixels) {
  specify_image(c, 1, target, level, internalformat, width, 1, 1, border, format, type, pixels);
}
void TexImage2D(Context& c, GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height,
                GLint border, GLenum format, GLenum type, const void* pixels) {
  specify_image(c, 2, target, level, internalformat, width, height, 1, border, format, type, pixels);
}
void TexImage3D(Context& c, GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height,
                GLsizei depth, GLint border, GLenum format, GLenum type, const void* pixels) {
  specify_image(c, 3, target, level, internalformat, width, height, depth, border, format, type, pixels);
}
void TexSubImage1D(Context& c, GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format,
                   GLenum type, const void* pixels) {
  change_image(c, 1, target, level, xoffset, 0, 0, width, 1, 1, format, type, pixels);
}
void TexSubImage2D(Context& c, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width,
                   GLsizei height, GLenum format, GLenum type, const void* pixels) {
  if (SOFTGL_FAULT(part_at_origin)) xoffset = yoffset = 0;
  change_image(c, 2, target, level, xoffset, yoffset, 0, width, height, 1, format, type, pixels);
}
void TexSubImage3D(Context& c, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset,
                   GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type,
                   const void* pixels) {
  change_image(c, 3, target, level, xoffset, yoffset, zoffset, width, height, depth, format, type, pixels);
}

void GetTexImage(Context& c, GLenum target, GLint level, GLenum format, GLenum type, void* pixels) {
  const ImageTarget t = any_image_target(target);
  if (!t.valid() || t.proxy) return set_error(c, GL_INVALID_ENUM, "target");
  if (level < 0 || level >= max_texture_levels(t.target)) return set_error(c, GL_INVALID_VALUE, "level");
  if (const Refusal refusal = check_pixel_format(format, type)) return set_error(c, refusal);
  if (format == GL_STENCIL_INDEX || format == GL_COLOR_INDEX) return set_error(c, GL_INVALID_ENUM, "format");
  const auto object = target_object(c, t);
  const TextureImage* image = object->image[t.face][level].get();
  if (!image || image->empty() || (!pixels && !c.client.pixel_store.pack_buffer.object)) return;
  // Depths alone can be had of both.
  if (!same_kind(image->format->base, format) &&
      !(image->format->base == GL_DEPTH_STENCIL && format == GL_DEPTH_COMPONENT))
    return set_error(c, GL_INVALID_OPERATION);
  const PixelFormat f = describe_pixel_format(format, type);
  const int dimensions = t.target == kTexture1D ? 1 : t.target == kTexture3D ? 3 : 2;
  const TexelBox box = image->with_border();
  const ImageLayout layout = layout_image(c.client.pixel_store.pack, dimensions, box.width, box.height, f);
  if (!find_pack_memory(c, pixels, image_span(c.client.pixel_store.pack, layout, box.height, box.depth, f)))
    return;
  auto p = static_cast<unsigned char*>(pixels);
  const bool swap = c.client.pixel_store.pack.swap_bytes;
  for (int k = 0; k < box.depth; ++k)
    for (int j = 0; j < box.height; ++j) {
      unsigned char* row = p + size_t(k) * layout.image_stride + layout.row(j);
      const unsigned char* texels = image->at(box.x, box.y + j, box.z + k);
      if (format == GL_DEPTH_STENCIL)
        load_depth_stencil(*image->format, reinterpret_cast<const uint32_t*>(texels),
                           image->stencil_at(box.x, box.y + j, box.z + k), f, row, box.width, swap);
      else
        load_texels(*image->format, texels, f, row, box.width, swap);
    }
}

} // namespace gl
} // namespace softgl
