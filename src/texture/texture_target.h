// The kinds of textures.
#pragma once

namespace softgl {

enum TextureTarget : int {
  kTexture1D,
  kTexture2D,
  kTexture3D,
  kTextureCube,
  kTextureRectangle,
  kTextureTargets
};

} // namespace softgl
