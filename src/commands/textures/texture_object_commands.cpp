// Naming and binding of texture objects (GL 1.5, 3.8.12).
#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "commands/textures/texture_targets.h"
#include "commands/vertices/vertex_stream.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"
#include "snapshot/render_targets.h"

namespace softgl::gl {

void GenTextures(Context& c, GLsizei n, GLuint* textures) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n");
  if (!textures) return;
  if (!c.shared->textures.reserve(n, textures)) set_error(c, GL_OUT_OF_MEMORY);
}

void DeleteTextures(Context& c, GLsizei n, const GLuint* textures) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n");
  if (!textures) return;
  for (GLsizei i = 0; i < n; ++i) {
    if (textures[i] == 0) continue;
    if (const auto object = c.shared->textures.find(textures[i]); object && is_attached(c, *object)) {
      draw_what_waits(c);
      detach_from_bound(c, *object);
    }
    const auto object = c.shared->textures.erase(textures[i]);
    for (int unit = 0; object && unit < kMaxTextureUnits; ++unit)
      if (auto& bound = c.bound_texture[unit][object->target];
          bound == object && !SOFTGL_FAULT(deleted_stays_bound)) {
        bound = nullptr;
        c.state.texture.unit[unit].bound[object->target] = 0;
      }
  }
  c.dirty |= kDirtyTexture;
}

void BindTexture(Context& c, GLenum target, GLuint texture) {
  const TextureTarget t = binding_target(target);
  if (t == kTextureTargets) return set_error(c, GL_INVALID_ENUM, "target");
  const int unit = c.state.texture.active_unit;
  auto& bound = c.bound_texture[unit][t];
  auto object = texture ? c.shared->textures.find(texture) : nullptr;
  if (object && object->target != t) return set_error(c, GL_INVALID_OPERATION);
  // To bind what is bound already changes nothing: vertices that wait go on waiting, as in OSMesa. With other
  // contexts it brings what they have done to the texture.
  if (bound == object && (object || !texture) && c.shared.use_count() == 1) return;
  if (c.guard & kRunPending) close_run(c);
  if (texture && !object)
    object = c.shared->textures.find_or_create(texture,
                                               [&] { return std::make_shared<TextureObject>(texture, t); });
  bound = std::move(object);
  c.state.texture.unit[unit].bound[t] = texture;
  c.dirty |= kDirtyTexture;
}

GLboolean IsTexture(Context& c, GLuint texture) {
  return texture != 0 && c.shared->textures.find(texture) ? GL_TRUE : GL_FALSE;
}

GLboolean AreTexturesResident(Context& c, GLsizei n, const GLuint* textures, GLboolean*) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n"), GL_FALSE;
  if (!textures) return GL_FALSE;
  for (GLsizei i = 0; i < n; ++i)
    if (textures[i] == 0 || !c.shared->textures.find(textures[i]))
      return set_error(c, GL_INVALID_VALUE, "textures"), GL_FALSE;
  return GL_TRUE; // all of memory is texture memory
}

void PrioritizeTextures(Context& c, GLsizei n, const GLuint* textures, const GLfloat* priorities) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n");
  if (!textures || !priorities) return;
  for (GLsizei i = 0; i < n; ++i)
    if (auto object = textures[i] ? c.shared->textures.find(textures[i]) : nullptr)
      object->parameters.priority = priorities[i] > 0 ? (priorities[i] < 1 ? priorities[i] : 1.0f) : 0.0f;
}

} // namespace softgl::gl
