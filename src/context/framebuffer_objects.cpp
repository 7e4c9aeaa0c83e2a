#include "context/framebuffer_objects.h"

#include "context/context.h"

namespace softgl {

RenderFormat Attachment::format() const {
  if (renderbuffer) return renderbuffer->format;
  const TextureImage* i = image();
  return i ? render_format(*i->format) : RenderFormat{};
}

int Attachment::width() const {
  if (renderbuffer) return renderbuffer->width;
  return image() ? image()->width : 0;
}

int Attachment::height() const {
  if (renderbuffer) return renderbuffer->height;
  return image() ? image()->height : 0;
}

int Attachment::samples() const { return renderbuffer ? renderbuffer->samples : 1; }

namespace {

/// Whether the image may be attached there (4.4.4.1). Formats that cannot be drawn to but are renderable by
/// the specification make the whole framebuffer unsupported, not the attachment incomplete.
bool is_complete(const Attachment& a, bool color, bool depth, bool stencil) {
  if (a.empty()) return true;
  if (a.width() == 0 || a.height() == 0) return false;
  if (a.texture && (a.layer >= a.image()->depth || a.image()->format->block != BlockFormat::None))
    return false;
  const RenderFormat format = a.format();
  if (format.kind == RenderFormat::Kind::None) return color;
  if (color) return format.is_color();
  return !format.is_color() && !(depth && format.depth_bits == 0) && !(stencil && format.stencil_bits == 0);
}

} // namespace

GLenum FramebufferObject::status() const {
  bool any = !depth.empty() || !stencil.empty(), drawable = true;
  for (const Attachment& a : color) {
    if (!is_complete(a, true, false, false)) return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
    any = any || !a.empty();
    drawable = drawable && (a.empty() || a.format().is_color());
  }
  if (!is_complete(depth, false, true, false) || !is_complete(stencil, false, false, true))
    return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
  if (!any) return GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT;
  for (const Attachment& a : color)
    if (!a.empty() && a.samples() != samples()) return GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE;
  for (const Attachment* a : {&depth, &stencil})
    if (!a->empty() && a->samples() != samples()) return GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE;
  // GL_ARB_ES2_compatibility and OpenGL 4.1 took back that draw and read buffers need an image.
  // Depths and stencil values lie in one plane.
  const bool two_planes = !depth.empty() && !stencil.empty() && !depth.same_image(stencil);
  return drawable && !two_planes ? GL_FRAMEBUFFER_COMPLETE : GL_FRAMEBUFFER_UNSUPPORTED;
}

int FramebufferObject::samples() const {
  for (const Attachment& a : color)
    if (!a.empty()) return a.samples();
  return depth.empty() ? stencil.samples() : depth.samples();
}

int bits_of_color(const RenderTarget& target, int component) {
  if (component == 3 && !target.has_alpha) return 0;
  switch (target.surface.color_format) {
  case ColorFormat::Rgba8: break;
  case ColorFormat::Rgba16: return 16;
  case ColorFormat::RgbaFloat: return 32;
  case ColorFormat::Rgb565: return component == 1 ? 6 : 5;
  }
  return 8;
}

namespace {

bool names_image(const FramebufferObject* object, GLenum buffer) {
  if (!object) return buffer != GL_NONE;
  const Attachment* a = object->color_of(buffer);
  return a && !a->empty();
}

} // namespace

bool draws_color(const Context& c) { return names_image(c.bindings.draw.get(), draw_buffer(c)); }
bool reads_color(const Context& c) { return names_image(c.bindings.read.get(), read_buffer(c)); }

GLenum draw_buffer(const Context& c) {
  return c.bindings.draw ? c.bindings.draw->draw_buffer : c.state.color_buffer.draw_buffer;
}

GLenum read_buffer(const Context& c) {
  return c.bindings.read ? c.bindings.read->read_buffer : c.state.pixel_mode.read_buffer;
}

} // namespace softgl
