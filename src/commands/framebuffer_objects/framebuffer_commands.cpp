// Framebuffer objects: naming, binding and completeness (GL_ARB_framebuffer_object, 4.4.1 and 4.4.4).
#include <memory>

#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "context/context.h"
#include "snapshot/render_targets.h"

namespace softgl::gl {
namespace {

using Object = std::shared_ptr<FramebufferObject>;

/// Null: the window.
void bind_framebuffer(Context& c, const Object& object, bool draw, bool read) {
  const bool changes = (draw && c.bindings.draw != object) || (read && c.bindings.read != object);
  if (!changes) {
    // What was done to shared images by other contexts is seen from here on.
    if (object && c.frame.empty()) framebuffers_changed(c);
    return;
  }
  draw_what_waits(c);
  if (draw) c.bindings.draw = object;
  if (read) c.bindings.read = object;
  c.bindings.draw_target = c.bindings.read_target = AssembledTarget{};
  framebuffers_changed(c);
}

void bind_framebuffer(Context& c, GLenum target, GLuint name, bool any_name) {
  const bool draw = target == GL_FRAMEBUFFER || target == GL_DRAW_FRAMEBUFFER,
             read = target == GL_FRAMEBUFFER || target == GL_READ_FRAMEBUFFER;
  if (!draw && !read) return set_error(c, GL_INVALID_ENUM, "target");
  if (name == 0) return bind_framebuffer(c, Object(), draw, read);
  if (!any_name && !c.framebuffer_objects.used(name)) return set_error(c, GL_INVALID_OPERATION);
  bind_framebuffer(
      c,
      c.framebuffer_objects.find_or_create(name, [&] { return std::make_shared<FramebufferObject>(name); }),
      draw, read);
}

} // namespace

void GenFramebuffers(Context& c, GLsizei n, GLuint* framebuffers) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n");
  if (!c.framebuffer_objects.reserve(n, framebuffers)) set_error(c, GL_OUT_OF_MEMORY);
}

void DeleteFramebuffers(Context& c, GLsizei n, const GLuint* framebuffers) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n");
  for (GLsizei i = 0; i < n; ++i) {
    if (framebuffers[i] == 0) continue;
    if (const Object object = c.framebuffer_objects.find(framebuffers[i]))
      bind_framebuffer(c, nullptr, object == c.bindings.draw, object == c.bindings.read);
    c.framebuffer_objects.erase(framebuffers[i]);
  }
}

GLboolean IsFramebuffer(Context& c, GLuint framebuffer) {
  return framebuffer != 0 && c.framebuffer_objects.find(framebuffer) ? GL_TRUE : GL_FALSE;
}

void BindFramebuffer(Context& c, GLenum target, GLuint framebuffer) {
  bind_framebuffer(c, target, framebuffer, false);
}
/// GL_EXT_framebuffer_object takes names that nobody has generated.
void BindFramebufferEXT(Context& c, GLenum target, GLuint framebuffer) {
  bind_framebuffer(c, target, framebuffer, true);
}

GLenum CheckFramebufferStatus(Context& c, GLenum target) {
  if (target != GL_FRAMEBUFFER && target != GL_DRAW_FRAMEBUFFER && target != GL_READ_FRAMEBUFFER)
    return set_error(c, GL_INVALID_ENUM, "target"), 0;
  const Object& object = target == GL_READ_FRAMEBUFFER ? c.bindings.read : c.bindings.draw;
  return object ? object->status() : GLenum(GL_FRAMEBUFFER_COMPLETE);
}

} // namespace softgl::gl
