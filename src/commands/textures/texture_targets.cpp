#include "commands/textures/texture_targets.h"
#include "context/texture_bindings.h"

#include "commands/framebuffer/flush.h"
#include "context/context.h"
#include "snapshot/render_targets.h"

namespace softgl {

TextureTarget binding_target(GLenum target) {
  switch (target) {
  case GL_TEXTURE_1D: return kTexture1D;
  case GL_TEXTURE_2D: return kTexture2D;
  case GL_TEXTURE_3D: return kTexture3D;
  case GL_TEXTURE_CUBE_MAP: return kTextureCube;
  case GL_TEXTURE_RECTANGLE: return kTextureRectangle;
  default: return kTextureTargets;
  }
}

ImageTarget image_target(GLenum target, int dimensions) {
  switch (dimensions) {
  case 1:
    if (target == GL_TEXTURE_1D || target == GL_PROXY_TEXTURE_1D)
      return {kTexture1D, 0, target == GL_PROXY_TEXTURE_1D};
    break;
  case 2:
    if (target == GL_TEXTURE_2D || target == GL_PROXY_TEXTURE_2D)
      return {kTexture2D, 0, target == GL_PROXY_TEXTURE_2D};
    if (target == GL_TEXTURE_RECTANGLE || target == GL_PROXY_TEXTURE_RECTANGLE)
      return {kTextureRectangle, 0, target == GL_PROXY_TEXTURE_RECTANGLE};
    if (target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X && target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z)
      return {kTextureCube, int(target - GL_TEXTURE_CUBE_MAP_POSITIVE_X), false};
    if (target == GL_PROXY_TEXTURE_CUBE_MAP) return {kTextureCube, 0, true};
    break;
  case 3:
    if (target == GL_TEXTURE_3D || target == GL_PROXY_TEXTURE_3D)
      return {kTexture3D, 0, target == GL_PROXY_TEXTURE_3D};
    break;
  }
  return {};
}

ImageTarget any_image_target(GLenum target) {
  for (int dimensions = 1; dimensions <= 3; ++dimensions)
    if (ImageTarget t = image_target(target, dimensions); t.valid()) return t;
  return {};
}

std::shared_ptr<TextureObject> target_object(Context& c, const ImageTarget& target) {
  if (target.proxy) return proxy_texture(c, target.target);
  auto object = bound_texture(c, c.state.texture.active_unit, target.target);
  if (is_attached(c, *object)) draw_what_waits(c);
  store_drawn_texels(*object);
  return object;
}

int max_texture_size(TextureTarget target) {
  return target == kTexture3D ? kMax3DTextureSize : kMaxTextureSize;
}

int max_texture_levels(TextureTarget target) {
  return target == kTextureRectangle ? 1 : target == kTexture3D ? 12 : kMaxTextureLevels;
}

} // namespace softgl
