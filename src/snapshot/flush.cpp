#include "snapshot/flush.h"

#include "base/assert.h"
#include "base/float_environment.h"
#include "context/context.h"
#include "frame/surface_work.h"

namespace softgl {

namespace {

/// Also of a frame that there is no memory for, a part may be drawn.
void mark_drawn(Context& c) {
  c.draw->unwritten = true;
  if (const auto& object = c.bindings.draw)
    object->for_each([](const Attachment& a) {
      if (a.texture) a.texture->drawn_to = true;
    });
  else
    c.framebuffer.unresolved = c.framebuffer.samples_changed = true;
}

} // namespace

void execute_frame(Context& c, const TileReader* reader) {
  SOFTGL_ASSERT(!reader || c.draw == &c.framebuffer);
  const FloatEnvironment environment;
  mark_drawn(c);
  c.dirty = kDirtyAll;
  c.frame.flush(c.draw->surface, reader);
  if (reader) c.framebuffer.unresolved = false;
  ++c.framebuffer.counts.flushes;
}

void execute_frame_so_far(Context& c) {
  const FloatEnvironment environment;
  mark_drawn(c);
  c.dirty |= kDirtyTextureObjects;
  c.frame.flush(c.draw->surface, nullptr, true);
  ++c.framebuffer.counts.flushes;
}

void flush_frame(Context& c) {
  if (!c.frame.empty()) execute_frame(c);
  write_tiles(*c.draw);
}

} // namespace softgl
