// What is behind the model.
#pragma once

#include "scene/look.h"

namespace softgl::cli {

// Fills the current framebuffer, without alpha: that counts what is drawn. `linear`: colors are decoded from
// sRGB.
void draw_background(const Background& background, int width, int height, bool linear);

} // namespace softgl::cli
