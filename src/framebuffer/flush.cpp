// glFlush and glFinish (GL 1.5, 5.5), and what they need.
#include "api/generated/commands.h"
#include "api/list_interface.h"
#include "base/float_environment.h"
#include "state/context.h"

namespace softgl {

namespace {

void flush_rendering(Context& c, const TileReader* reader) {
  const FloatEnvironment environment;
  c.frame.flush(c.framebuffer.surface, reader);
  c.dirty = kDirtyAll;
  c.framebuffer.unresolved = !reader;
  ++c.framebuffer.counts.flushes;
}

} // namespace

void flush_rendering(Context& c) {
  if (c.guard & kRunPending) close_run(c);
  if (!c.frame.empty()) flush_rendering(c, nullptr);
}

void finish_and_resolve(Context& c) {
  if (c.guard & kRunPending) close_run(c);
  Framebuffer& f = c.framebuffer;
  const Resolver resolver(f.surface, f.client);
  if (!c.frame.empty()) flush_rendering(c, &resolver);
  else if (f.unresolved) resolve(f.surface, f.client);
  else return;
  f.unresolved = false;
  if (!f.depth_copy.empty()) copy_depth(f);
  ++f.counts.resolves;
}

namespace gl {

void Flush(Context& c) { finish_and_resolve(c); }
void Finish(Context& c) { finish_and_resolve(c); }

} // namespace gl
} // namespace softgl
