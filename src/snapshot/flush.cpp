#include "snapshot/flush.h"

#include "base/float_environment.h"
#include "context/context.h"
#include "frame/surface_work.h"

namespace softgl {

void execute_frame(Context& c, const TileReader* reader) {
  const FloatEnvironment environment;
  // Also of a frame that there is no memory for, a part may be drawn.
  c.framebuffer.unresolved = c.framebuffer.unwritten = true;
  c.dirty = kDirtyAll;
  c.frame.flush(c.framebuffer.surface, reader);
  c.framebuffer.unresolved = !reader;
  ++c.framebuffer.counts.flushes;
}

void flush_frame(Context& c) {
  if (!c.frame.empty()) execute_frame(c);
  write_tiles(c.framebuffer);
}

} // namespace softgl
