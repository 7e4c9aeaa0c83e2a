// CopyTexImage and CopyTexSubImage (GL 1.5, 3.8.2).
#include <algorithm>
#include <bit>
#include <memory>
#include <vector>

#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "commands/textures/texture_images.h"
#include "context/context.h"
#include "context/pixel_transfer.h"
#include "shaders/common/seeded_faults.h"
#include "surface/plane_texels.h"
#include "surface/read_surface.h"
#include "surface/render_plane.h"
#include "surface/stored_color.h"
#include "texture/component_values.h"
#include "texture/drawn_values.h"
#include "texture/pixel_formats.h"

namespace softgl {

namespace {

/// A depth as the texture stores it, after depth scale and bias.
uint32_t transferred_depth(const PixelTransfer& transfer, uint32_t z, int from_bits, int to_bits) {
  if (!transfer.changes_depth()) return float_to_wide(wide_to_float(z, from_bits), to_bits);
  const double scaled = double(convert_unorm(z, from_bits, 32)) * transfer.mode.depth_scale +
                        double(transfer.mode.depth_bias * 4294967296.0f);
  return uint32_t(std::clamp(scaled, 0.0, 4294967295.0)) >> (32 - to_bits);
}

/// The same on its way from floats or to them.
uint32_t transferred_float(const PixelTransfer& transfer, float depth, const TexelFormat& to) {
  const float d = transfer.depth(depth);
  return to.floats ? std::bit_cast<uint32_t>(d) : float_to_wide(d, to.bits[0]);
}

/// The depths of a rectangle, bottom row first, in the bits of `format`; 0 outside the surface.
void copy_depths(Context& c, int x, int y, int width, int height, const TexelFormat& format,
                 TextureImage& image, int to_x, int to_y, int to_z) {
  const Surface& surface = c.read->surface;
  const PixelTransfer transfer = pixel_transfer(c);
  const bool floats = surface.depth_format == DepthFormat::Z32F || format.floats;
  const int from_bits = surface.depth_format == DepthFormat::Z16 ? 16 : 24, to_bits = format.bits[0];
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      uint32_t word = 0, stencil = 0;
      const int sx = x + i, sy = y + j;
      const bool stencils = !image.stencils.empty();
      if (sx >= 0 && sy >= 0 && sx < surface.width && sy < surface.height) {
        copy_depth_stencil_row(surface, sx, surface_row(surface, sy), 1, &word);
        if (stencils) copy_stencil_row(surface, sx, surface_row(surface, sy), 1, &stencil);
      }
      const uint32_t z = from_bits == 24 ? word & 0xffffffu : word & 0xffffu;
      *reinterpret_cast<uint32_t*>(image.at(to_x + i, to_y + j, to_z)) =
          floats ? transferred_float(transfer, depth_to_float(surface.depth_format, word), format)
                 : transferred_depth(transfer, z, from_bits, to_bits);
      if (stencils) *image.stencil_at(to_x + i, to_y + j, to_z) = uint8_t(transfer.stencil(stencil));
    }
}

/// True where the format needs colors, depths or stencil values that what is read does not have.
bool lacks_buffer(const Context& c, const TexelFormat& format) {
  return (format.layout != TexelLayout::Depth && !c.read->surface.color) ||
         (format.layout == TexelLayout::Depth && c.read->depth_bits == 0) ||
         (format.base == GL_DEPTH_STENCIL && c.read->stencil_bits == 0);
}

bool whole_bytes(const TexelFormat& f) {
  return f.layout == TexelLayout::Rgba8 && f.array && (f.base == GL_RGB || f.base == GL_RGBA);
}

/// Whether a copy is stored as if it were drawn, as OSMesa 22.3.6 does it. For bytes that makes no
/// difference.
bool draws_copy(const Context& c, const TexelFormat& to) {
  if (!render_format(to).is_color()) return false;
  return (c.read->texels && !whole_bytes(*c.read->texels)) || to.layout == TexelLayout::Signed16 ||
         to.layout == TexelLayout::Float;
}

void draw_colors(Context& c, int x, int y, int width, int height, TextureImage& image, int to_x, int to_y,
                 int to_z) {
  const RenderFormat format = render_format(*image.format);
  std::vector<float> colors(size_t(width) * size_t(height) * 4);
  auto* rgba = reinterpret_cast<float(*)[4]>(colors.data());
  read_rgba_float(c.read->surface, x, y, width, height, rgba);
  spread_colors(c.read->texels, rgba, size_t(width) * size_t(height));
  std::vector<unsigned char> pixels(size_t(width) * 16);
  for (int j = 0; j < height; ++j) {
    store_drawn_colors(format.color, format.encoding, rgba + size_t(j) * size_t(width), width, pixels.data());
    pixels_to_texels(*image.format, format.color, pixels.data(), width, image.at(to_x, to_y + j, to_z));
  }
}

void copy_colors(Context& c, int x, int y, int width, int height, TextureImage& image, int to_x, int to_y,
                 int to_z) {
  const PixelTransfer transfer = pixel_transfer(c);
  if (draws_copy(c, *image.format) && !transfer.changes_color())
    return draw_colors(c, x, y, width, height, image, to_x, to_y, to_z);
  const Surface& surface = c.read->surface;
  if (surface.color_format == ColorFormat::Rgba8) {
    uint8_t bits[4] = {8, 8, 8, 8}; // that are left of a byte
    if (image.format->layout == TexelLayout::Rgba8 && !transfer.changes_color())
      for (int k = 0; k < 4; ++k)
        if (image.format->bits[k]) bits[k] = image.format->bits[k];
    const bool reduces = std::any_of(bits, bits + 4, [](uint8_t b) { return b != 8; });
    const PixelFormat f = describe_pixel_format(GL_RGBA, GL_UNSIGNED_BYTE);
    std::vector<uint8_t> row(size_t(width) * 4); // a row at a time stays in the cache
    const auto left = int(std::clamp(-int64_t(x), int64_t(0), int64_t(width))),
               right = int(std::clamp(int64_t(surface.width) - x, int64_t(left), int64_t(width)));
    for (int j = 0; j < height; ++j) {
      const int64_t line = int64_t(y) + j;
      if (line >= 0 && line < surface.height && left < right)
        copy_color_row(surface, x + left, surface_row(surface, int(line)), right - left,
                       row.data() + size_t(left) * 4);
      else
        std::fill(row.begin(), row.end(), uint8_t(0));
      if (reduces)
        for (size_t i = 0; i < row.size(); ++i) row[i] = reduced_byte(row[i], bits[i & 3]);
      store_texels(*image.format, image.at(to_x, to_y + j, to_z), f, row.data(), width, false, transfer);
    }
  } else {
    std::vector<float> pixels(size_t(width) * size_t(height) * 4);
    read_rgba_float(c.read->surface, x, y, width, height, reinterpret_cast<float(*)[4]>(pixels.data()));
    const PixelFormat f = describe_pixel_format(GL_RGBA, GL_FLOAT);
    for (int j = 0; j < height; ++j)
      store_texels(*image.format, image.at(to_x, to_y + j, to_z), f,
                   pixels.data() + size_t(j) * size_t(width) * 4, width, false, transfer);
  }
}

void copy_rectangle(Context& c, int x, int y, int width, int height, TextureImage& image, int to_x, int to_y,
                    int to_z) {
  if (width == 0 || height == 0) return;
  if (SOFTGL_FAULT(texture_copy_row_too_high)) y += 1;
  if (image.format->layout == TexelLayout::Depth)
    copy_depths(c, x, y, width, height, *image.format, image, to_x, to_y, to_z);
  else
    copy_colors(c, x, y, width, height, image, to_x, to_y, to_z);
  image.texels_changed({to_x, to_y, to_z, width, height, 1});
}

void copy_image(Context& c, int dimensions, GLenum target, GLint level, GLenum internal_format, GLint x,
                GLint y, GLsizei width, GLsizei height, GLint border) {
  const ImageTarget t = image_target(target, dimensions);
  if (!t.valid() || t.proxy) return set_error(c, GL_INVALID_ENUM, "target");
  if (const Refusal refusal = check_level(t, level)) return set_error(c, refusal);
  if (const Refusal refusal = check_border(border)) return set_error(c, refusal);
  if (const Refusal refusal = check_signs(width, height, 1)) return set_error(c, refusal);
  if (!flush_for_reading(c)) return set_error(c, GL_INVALID_FRAMEBUFFER_OPERATION);
  if (c.read->surface.samples > 1) return set_error(c, GL_INVALID_OPERATION);
  // The numbers 1 to 4 are no formats here (3.8.2).
  const TexelFormat* chosen =
      internal_format <= 4 ? nullptr : choose_texel_format(GLint(internal_format), 0, 0, false);
  if (!chosen) return set_error(c, GL_INVALID_ENUM, "internalformat");
  const auto object = target_object(c, t);
  if (object->immutable_levels) return set_error(c, GL_INVALID_OPERATION);
  const TexelFormat* texel =
      &level_format(*object, t.face, level, granted_format(GLint(internal_format)), *chosen);
  if (lacks_buffer(c, *texel)) return set_error(c, GL_INVALID_OPERATION);
  if (!takes_target(*texel, t.target)) return set_error(c, GL_INVALID_ENUM, "internalformat");
  if (border != 0 && texel->block != BlockFormat::None) return set_error(c, GL_INVALID_OPERATION);
  if (const Refusal refusal = check_image_size(t, level, width, height, 1, border))
    return set_error(c, refusal);
  if (image_bytes(*texel, width, height, 1) > kMaxImageBytes) return set_error(c, GL_OUT_OF_MEMORY);
  const ImageBorder given = image_border(border, dimensions), kept = kept_border(c, given);
  auto image = make_image(*texel, granted_format(GLint(internal_format)), width - 2 * given.x,
                          height - 2 * given.y, 1, kept);
  const TexelBox box = image->with_border();
  if (!image->empty())
    copy_rectangle(c, x + given.x - kept.x, y + given.y - kept.y, box.width, box.height, *image, box.x, box.y,
                   0);
  mark_images(c, *object);
  match_formats(*object, *image);
  object->image[t.face][level] = std::move(image);
  regenerate_mipmaps(*object, t.face, level);
}

void copy_sub_image(Context& c, int dimensions, GLenum target, GLint level, GLint to_x, GLint to_y,
                    GLint to_z, GLint x, GLint y, GLsizei width, GLsizei height) {
  const ImageTarget t = image_target(target, dimensions);
  if (!t.valid() || t.proxy) return set_error(c, GL_INVALID_ENUM, "target");
  if (const Refusal refusal = check_level(t, level)) return set_error(c, refusal);
  if (const Refusal refusal = check_signs(width, height, 1)) return set_error(c, refusal);
  // A frame that still samples the image is done then, so no copy has to be made of it.
  if (!flush_for_reading(c)) return set_error(c, GL_INVALID_FRAMEBUFFER_OPERATION);
  if (c.read->surface.samples > 1) return set_error(c, GL_INVALID_OPERATION);
  const auto object = target_object(c, t);
  const TextureImage* image = object->image[t.face][level].get();
  if (!image) return set_error(c, GL_INVALID_OPERATION);
  if (const Refusal refusal = check_box(*image, to_x, to_y, to_z, width, height, 1))
    return set_error(c, refusal);
  if (lacks_buffer(c, *image->format) || !whole_blocks(*image, to_x, to_y, width, height))
    return set_error(c, GL_INVALID_OPERATION);
  // Texels that would come from outside the window are undefined (3.8.2); as in OSMesa they stay what they
  // are.
  const Surface& surface = c.read->surface;
  const int right = int(std::min(int64_t(x) + width, int64_t(surface.width))),
            top = int(std::min(int64_t(y) + height, int64_t(surface.height)));
  const int left = std::max(x, 0), bottom = std::max(y, 0);
  if (left >= right || bottom >= top || image->empty()) return;
  mark_images(c, *object);
  copy_rectangle(c, left, bottom, right - left, top - bottom, object->writable(t.face, level),
                 to_x + left - x, to_y + bottom - y, to_z);
  regenerate_mipmaps(*object, t.face, level);
}

} // namespace

namespace gl {

void CopyTexImage1D(Context& c, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                    GLsizei width, GLint border) {
  copy_image(c, 1, target, level, internalformat, x, y, width, 1, border);
}
void CopyTexImage2D(Context& c, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                    GLsizei width, GLsizei height, GLint border) {
  copy_image(c, 2, target, level, internalformat, x, y, width, height, border);
}
void CopyTexSubImage1D(Context& c, GLenum target, GLint level, GLint xoffset, GLint x, GLint y,
                       GLsizei width) {
  copy_sub_image(c, 1, target, level, xoffset, 0, 0, x, y, width, 1);
}
void CopyTexSubImage2D(Context& c, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x, GLint y,
                       GLsizei width, GLsizei height) {
  copy_sub_image(c, 2, target, level, xoffset, yoffset, 0, x, y, width, height);
}
void CopyTexSubImage3D(Context& c, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset,
                       GLint x, GLint y, GLsizei width, GLsizei height) {
  copy_sub_image(c, 3, target, level, xoffset, yoffset, zoffset, x, y, width, height);
}

} // namespace gl
} // namespace softgl
