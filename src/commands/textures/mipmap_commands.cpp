// GenerateMipmap (GL_ARB_framebuffer_object, 3.8.8).
#include "commands/generated/commands.h"
#include "commands/textures/texture_images.h"
#include "context/context.h"

namespace softgl {
namespace {

/// The base levels of all faces have one size and one format (3.8.10).
bool is_cube_complete(const TextureObject& object) {
  const GLint level = object.base_level();
  if (level < 0 || level >= kMaxTextureLevels) return false;
  const TextureImage* first = object.image[0][level].get();
  if (!first || first->empty() || first->width != first->height) return false;
  for (const auto& face : object.image) {
    const TextureImage* image = face[level].get();
    if (!image || image->width != first->width || image->height != first->height ||
        image->internal_format != first->internal_format)
      return false;
  }
  return true;
}

bool has_stencil(const TextureObject& object) {
  const GLint level = object.parameters.base_level;
  const TextureImage* image =
      level >= 0 && level < kMaxTextureLevels ? object.image[0][level].get() : nullptr;
  return image && !image->empty() && image->format->base == GL_DEPTH_STENCIL;
}

} // namespace

void gl::GenerateMipmap(Context& c, GLenum target) {
  const TextureTarget t = binding_target(target);
  if (t == kTextureTargets || t == kTextureRectangle) return set_error(c, GL_INVALID_ENUM, "target");
  const auto object = target_object(c, {t, 0, false});
  if (t == kTextureCube && !is_cube_complete(*object)) return set_error(c, GL_INVALID_OPERATION);
  // The mean of stencil values is none: GL_EXT_packed_depth_stencil leaves it open (issue 12), OpenGL 3.0 and
  // OSMesa refuse it.
  if (has_stencil(*object)) return set_error(c, GL_INVALID_OPERATION);
  mark_images(c, *object);
  for (int face = 0; face < (t == kTextureCube ? 6 : 1); ++face) generate_mipmaps(*object, face);
}

} // namespace softgl
