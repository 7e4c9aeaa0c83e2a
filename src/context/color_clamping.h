// Whether colors are clamped to [0, 1] (GL_ARB_color_buffer_float, 2.19.6, 3.12 and 4.3.2).
#pragma once

#include "context/context.h"
#include "context/framebuffer_objects.h"

namespace softgl {

/// What a value of glClampColor means for the colors of `target`.
inline bool clamps(const RenderTarget& target, GLenum clamp) {
  return clamp == GL_FIXED_ONLY ? !is_float(target.surface) : clamp != GL_FALSE;
}
/// Whether what is drawn to keeps floats, also before prepare_draw_target() has made it c.draw.
inline bool draws_floats(const Context& c) {
  const FramebufferObject* f = c.bindings.draw.get();
  if (!f || c.bindings.draw_current) return is_float(c.draw->surface);
  const Attachment* a = f->complete() ? f->color_of(f->draw_buffer) : nullptr;
  return a && a->format().color == ColorFormat::RgbaFloat;
}
/// The same for what is drawn to.
inline bool clamps_drawn(const Context& c, GLenum clamp) {
  return clamp == GL_FIXED_ONLY ? !draws_floats(c) : clamp != GL_FALSE;
}
inline bool clamps_vertex_colors(const Context& c) {
  return clamps_drawn(c, c.state.lighting.clamp_vertex_color);
}
/// Colors of fragment operations are kept as given, and read back clamped (6.1.2).
inline bool clamps_queried_colors(const Context& c) {
  return clamps_drawn(c, c.state.color_buffer.clamp_fragment_color);
}
/// Colors that the surface cannot keep unclamped need no step of their own.
inline bool clamps_fragment_colors(const Context& c) {
  return c.draw->surface.encoding.numbers != ColorNumbers::Unsigned &&
         clamps_drawn(c, c.state.color_buffer.clamp_fragment_color);
}

} // namespace softgl
