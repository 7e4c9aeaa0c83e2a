// glFlush and glFinish (GL 1.5, 5.5), and what they need.
#include "api/generated/commands.h"
#include "api/list_interface.h"
#include "base/float_environment.h"
#include "state/context.h"

namespace softgl {

void flush_rendering(Context& c) {
  if ((c.guard & kRunPending)) close_run(c);
  if (c.frame.empty()) return;
  const FloatEnvironment environment;
  c.frame.flush(c.framebuffer.surface);
  c.dirty = kDirtyAll;
  c.framebuffer.unresolved = true;
  ++c.framebuffer.counts.flushes;
}

void finish_and_resolve(Context& c) {
  flush_rendering(c);
  if (!c.framebuffer.unresolved) return;
  c.framebuffer.unresolved = false;
  resolve(c.framebuffer.surface, c.framebuffer.client);
  if (!c.framebuffer.depth_copy.empty()) copy_depth(c.framebuffer);
  ++c.framebuffer.counts.resolves;
}

namespace gl {

void Flush(Context& c) { finish_and_resolve(c); }
void Finish(Context& c) { finish_and_resolve(c); }

} // namespace gl
} // namespace softgl
