// What the target tokens of texture commands mean.
#pragma once

#include "texture/texture_object.h"

namespace softgl {

struct Context;

/// Target of BindTexture and TexParameter; kTextureTargets when it is none.
TextureTarget binding_target(GLenum target);

/// Target of an image command.
struct ImageTarget {
  TextureTarget target = kTextureTargets; // kTextureTargets: not one of this command's targets
  int face = 0;
  bool proxy = false;
  bool valid() const { return target != kTextureTargets; }
};
/// `dimensions` 1 to 3 as in TexImage1D to 3D.
ImageTarget image_target(GLenum target, int dimensions);
/// Any image, for level queries and GetTexImage.
ImageTarget any_image_target(GLenum target);

/// Its texels are up to date.
std::shared_ptr<TextureObject> target_object(Context& c, const ImageTarget& target);
/// The largest width, height or depth of level 0.
int max_texture_size(TextureTarget target);
/// Levels 0 to this number - 1 may be named.
int max_texture_levels(TextureTarget target);

} // namespace softgl
