// The state of GL in which every picture of colors begins.
#pragma once

#include "scene/renderer.h"

namespace softgl::cli {

// With the terms of light, the background and the ground that the options' pass has.
RenderOptions settle_for_pass(RenderOptions options);

// The background, and no depth. Width and height are in samples.
void clear_picture(const RenderOptions& options, int width, int height);

// Clears, and sets the lights, the camera and the tests. `lines_on_surfaces`: surfaces are moved back a
// little, so that lines on them are seen.
void start_picture(const RenderOptions& options, const Camera& camera, const ModelFrame& frame, int width,
                   int height, bool lines_on_surfaces);

} // namespace softgl::cli
