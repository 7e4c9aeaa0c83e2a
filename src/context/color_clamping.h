// Whether colors are clamped to [0, 1] (GL_ARB_color_buffer_float, 2.19.6, 3.12 and 4.3.2).
#pragma once

#include "context/context.h"
#include "context/framebuffer_objects.h"

namespace softgl {

/// What a value of glClampColor means for the colors of `target`.
inline bool clamps(const RenderTarget& target, GLenum clamp) {
  return clamp == GL_FIXED_ONLY ? !is_float(target.surface) : clamp != GL_FALSE;
}
inline bool clamps_vertex_colors(const Context& c) {
  return clamps(*c.draw, c.state.lighting.clamp_vertex_color);
}
/// Colors that the surface cannot keep unclamped need no step of their own.
inline bool clamps_fragment_colors(const Context& c) {
  return c.draw->surface.encoding.numbers != ColorNumbers::Unsigned &&
         clamps(*c.draw, c.state.color_buffer.clamp_fragment_color);
}

} // namespace softgl
