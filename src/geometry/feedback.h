// Selection and feedback (GL 1.5, 5.2 and 5.3): what primitives and pixel rectangles become when nothing is
// rendered.
#pragma once

#include "frame/draw_call.h"

namespace softgl {

/// Notes the hits of the draw, or writes its vertices to the feedback buffer.
void feed_back(Context& context, const DrawCall& call);
/// A hit at the depth of a valid raster position.
void feed_back_raster_position(Context& context);
/// GL_BITMAP_TOKEN, GL_DRAW_PIXEL_TOKEN or GL_COPY_PIXEL_TOKEN at the raster position.
void feed_back_pixels(Context& context, GLenum token);

} // namespace softgl
