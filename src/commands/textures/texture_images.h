// What the image commands share: checks of sizes and the consequences of a change.
#pragma once

#include "commands/textures/texture_targets.h"

namespace softgl {

/// GL_NO_ERROR or GL_INVALID_VALUE (3.8.1). Sizes include the border.
GLenum check_image_size(const ImageTarget& target, GLint level, GLsizei width, GLsizei height, GLsizei depth,
                        GLint border);
bool box_inside(const TextureImage& image, GLint x, GLint y, GLint z, GLsizei width, GLsizei height,
                GLsizei depth);
/// Regenerates mipmaps if that is asked for, and marks the state.
void image_changed(Context& c, TextureObject& object, int face, int level);

} // namespace softgl
