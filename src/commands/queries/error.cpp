// glGetError (GL 1.5, 2.5).
#include "commands/generated/commands.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"

namespace softgl::gl {

GLenum GetError(Context& c) {
  const GLenum code = c.error;
  if (!SOFTGL_FAULT(error_stays)) c.error = GL_NO_ERROR;
  return code;
}

} // namespace softgl::gl
