// Selection and feedback (GL 1.5, 5.2 and 5.3): what primitives and pixel rectangles become when nothing is
// rendered.
#pragma once

#include "draw/draw_call.h"

namespace softgl {

struct Context;
struct RenderModeState;

/// Notes the hits of the draw, or writes its vertices to the feedback buffer.
void feed_back(Context& context, const DrawCall& call);
/// A hit at the depth of a valid raster position.
void feed_back_raster_position(Context& context);
/// GL_BITMAP_TOKEN, GL_DRAW_PIXEL_TOKEN or GL_COPY_PIXEL_TOKEN at the raster position.
void feed_back_pixels(Context& context, GLenum token);

/// Writes a value to the feedback buffer, or only counts it where there is no room.
void feed_back_value(RenderModeState& mode, float value);
void feed_back_token(RenderModeState& mode, GLenum token);
/// Writes the record of the hits since the name stack changed last, if there were any.
void write_hit_record(RenderModeState& mode);

} // namespace softgl
