// Renderbuffers (GL_ARB_framebuffer_object, 4.4.2.1 and 6.1.16).
#include <memory>

#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "context/context.h"
#include "snapshot/render_targets.h"

namespace softgl::gl {

void GenRenderbuffers(Context& c, GLsizei n, GLuint* renderbuffers) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n");
  if (!c.shared->renderbuffers.reserve(n, renderbuffers)) set_error(c, GL_OUT_OF_MEMORY);
}

void DeleteRenderbuffers(Context& c, GLsizei n, const GLuint* renderbuffers) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n");
  for (GLsizei i = 0; i < n; ++i) {
    if (renderbuffers[i] == 0) continue;
    const auto object = c.shared->renderbuffers.find(renderbuffers[i]);
    if (object && is_attached(c, *object)) {
      draw_what_waits(c);
      detach_from_bound(c, *object);
    }
    c.shared->renderbuffers.erase(renderbuffers[i]);
    if (object && c.bindings.renderbuffer == object) c.bindings.renderbuffer = nullptr;
  }
}

GLboolean IsRenderbuffer(Context& c, GLuint renderbuffer) {
  return renderbuffer != 0 && c.shared->renderbuffers.find(renderbuffer) ? GL_TRUE : GL_FALSE;
}

namespace {

void bind_renderbuffer(Context& c, GLenum target, GLuint name, bool any_name) {
  if (target != GL_RENDERBUFFER) return set_error(c, GL_INVALID_ENUM, "target");
  if (name == 0) {
    c.bindings.renderbuffer = nullptr;
    return;
  }
  if (!any_name && !c.shared->renderbuffers.used(name)) return set_error(c, GL_INVALID_OPERATION);
  c.bindings.renderbuffer =
      c.shared->renderbuffers.find_or_create(name, [&] { return std::make_shared<Renderbuffer>(name); });
}

} // namespace

void BindRenderbuffer(Context& c, GLenum target, GLuint renderbuffer) {
  bind_renderbuffer(c, target, renderbuffer, false);
}
/// GL_EXT_framebuffer_object takes names that nobody has generated.
void BindRenderbufferEXT(Context& c, GLenum target, GLuint renderbuffer) {
  bind_renderbuffer(c, target, renderbuffer, true);
}

void RenderbufferStorageMultisample(Context& c, GLenum target, GLsizei samples, GLenum internalformat,
                                    GLsizei width, GLsizei height) {
  if (target != GL_RENDERBUFFER) return set_error(c, GL_INVALID_ENUM, "target");
  const RenderFormat format = renderbuffer_format(internalformat);
  if (format.kind == RenderFormat::Kind::None) return set_error(c, GL_INVALID_ENUM, "internalformat");
  const auto legal = [](GLsizei size) { return size >= 0 && size <= kMaxRenderbufferSize; };
  if (const char* wrong = first_wrong({{"width", !legal(width)},
                                       {"height", !legal(height)},
                                       {"samples", samples < 0 || samples > kSamples}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  const auto renderbuffer = c.bindings.renderbuffer;
  if (!renderbuffer) return set_error(c, GL_INVALID_OPERATION);
  const int stored = samples == 0 ? 1 : kSamples; // at least as many as are asked for
  auto plane =
      width > 0 && height > 0 ? std::make_shared<RenderPlane>(format, width, height, stored) : nullptr;
  const bool attached = is_attached(c, *renderbuffer);
  if (attached) draw_what_waits(c);
  renderbuffer->internal_format = internalformat;
  renderbuffer->width = width;
  renderbuffer->height = height;
  renderbuffer->samples = stored;
  renderbuffer->format = format;
  renderbuffer->plane = std::move(plane);
  if (attached) framebuffers_changed(c);
}

void RenderbufferStorage(Context& c, GLenum target, GLenum internalformat, GLsizei width, GLsizei height) {
  RenderbufferStorageMultisample(c, target, 0, internalformat, width, height);
}

void GetRenderbufferParameteriv(Context& c, GLenum target, GLenum pname, GLint* params) {
  if (target != GL_RENDERBUFFER) return set_error(c, GL_INVALID_ENUM, "target");
  const Renderbuffer* r = c.bindings.renderbuffer.get();
  if (!r) return set_error(c, GL_INVALID_OPERATION);
  switch (pname) {
  case GL_RENDERBUFFER_WIDTH: *params = r->width; return;
  case GL_RENDERBUFFER_HEIGHT: *params = r->height; return;
  case GL_RENDERBUFFER_INTERNAL_FORMAT: *params = GLint(r->internal_format); return;
  case GL_RENDERBUFFER_SAMPLES: *params = r->samples == 1 ? 0 : r->samples; return;
  case GL_RENDERBUFFER_RED_SIZE: *params = r->format.bits[0]; return;
  case GL_RENDERBUFFER_GREEN_SIZE: *params = r->format.bits[1]; return;
  case GL_RENDERBUFFER_BLUE_SIZE: *params = r->format.bits[2]; return;
  case GL_RENDERBUFFER_ALPHA_SIZE: *params = r->format.bits[3]; return;
  case GL_RENDERBUFFER_DEPTH_SIZE: *params = r->format.depth_bits; return;
  case GL_RENDERBUFFER_STENCIL_SIZE: *params = r->format.stencil_bits; return;
  default: set_error(c, GL_INVALID_ENUM, "pname");
  }
}

} // namespace softgl::gl
