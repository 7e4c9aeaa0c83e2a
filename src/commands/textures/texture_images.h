// What the image commands share: checks of sizes, and what goes with a change.
#pragma once

#include "base/refusal.h"
#include "commands/textures/texture_targets.h"
#include "context/context.h"

namespace softgl {

/// What of an image is wrong with GL_INVALID_VALUE (3.8.1): its level, a negative size, its border.
Refusal check_level(const ImageTarget& target, GLint level);
Refusal check_signs(GLsizei width, GLsizei height, GLsizei depth);
Refusal check_border(GLint border);
/// All of that, and sizes that are too large. They include the border.
Refusal check_image_size(const ImageTarget& target, GLint level, GLsizei width, GLsizei height, GLsizei depth,
                         GLint border);
/// A part of an image that does not lie inside (3.8.2).
Refusal check_box(const TextureImage& image, GLint x, GLint y, GLint z, GLsizei width, GLsizei height,
                  GLsizei depth);
/// Whether client pixels of `format` and texels of a base format go together: colors, depths, or both of
/// GL_DEPTH_STENCIL (3.8.1).
bool same_kind(GLenum base, GLenum format);
/// The internal format that an image gets: the base format takes the place of a generic compressed one, whose
/// images are not compressed (3.8.1), and the names of GL_EXT_texture_compression_s3tc that of GL_S3_s3tc.
GLint granted_format(GLint internal_format);
/// Whether textures of the target can have images of the format: compressed ones are two-dimensional.
bool takes_target(const TexelFormat& format, TextureTarget target);
/// Whether a part that is to be changed consists of whole blocks, if the image is compressed.
bool whole_blocks(const TextureImage& image, GLint x, GLint y, GLsizei width, GLsizei height);
/// The image of a proxy is only a description, whose sizes include the border here; what is impossible leaves
/// it empty, without an error (3.8.11).
std::shared_ptr<TextureImage> describe_image(const TexelFormat& format, GLint internal_format, GLsizei width,
                                             GLsizei height, GLsizei depth, ImageBorder border = {});
/// The border that an image is kept with: the texels that it is specified with, or none, as by OSMesa 22.3.6,
/// which drops them.
inline ImageBorder kept_border(const Context& c, ImageBorder border) {
  return c.specification_answers ? border : ImageBorder{};
}
/// Marks the state. Called before the first image changes: where memory ends, some of them have changed.
void mark_images(Context& c, const TextureObject& object);
/// The image for a change. A frame that still samples a large one is drawn first, so that no copy has to be
/// made of it. Called before mark_images(). Throws std::bad_alloc.
TextureImage& image_for_change(Context& c, TextureObject& object, int face, int level);
/// After a change: regenerates mipmaps if that is asked for (3.8.8). Throws std::bad_alloc.
void regenerate_mipmaps(TextureObject& object, int face, int level);

} // namespace softgl
