#include "commands/framebuffer/flush.h"

#include <new>

#include "base/early_pages.h"
#include "base/fast_paths.h"
#include "commands/generated/commands.h"
#include "commands/vertices/list_compilation.h"
#include "commands/vertices/vertex_chunk.h"
#include "commands/vertices/vertex_stream.h"
#include "context/context.h"
#include "frame/parallel.h"
#include "frame/surface_work.h"
#include "snapshot/flush.h"
#include "snapshot/render_targets.h"

namespace softgl {

void flush_rendering(Context& c) {
  const ExecuteScope scope(c);
  if (c.guard & kRunPending) close_run(c);
  const VerticesAside aside(c);
  flush_frame(c);
}

void draw_what_waits(Context& c) {
  const ExecuteScope scope(c);
  if (c.guard & kRunPending) close_run(c);
  const VerticesAside aside(c);
  if (!c.frame.empty()) execute_frame(c);
}

bool flush_for_reading(Context& c) {
  flush_rendering(c);
  return prepare_read_target(c);
}

void finish_and_resolve(Context& c) {
  const ExecuteScope scope(c);
  if (c.guard & kRunPending) close_run(c);
  const VerticesAside aside(c); // a context may leave its thread between Begin and End
  Framebuffer& f = c.framebuffer;
  const Resolver resolver(f.surface, f.client);
  if (!c.frame.empty() && c.draw == &f && !f.resolved && takes(FastPath::EarlyCopies)) {
    execute_frame(c, &resolver);
  } else {
    if (!c.frame.empty()) flush_frame(c);
    if (!f.unresolved) return;
    resolve_samples(f);
    resolve(f.seen().surface, f.client);
  }
  f.unresolved = false;
  if (!f.depth_copy.empty()) {
    write_tiles(f);
    copy_depth(f);
  }
  ++f.counts.resolves;
}

void prepare_first_frame(Context& c) noexcept try {
  // 4 ms of a first frame of 1024x1024 pixels and 70,000 triangles. Small surfaces see small frames; of very
  // large ones not all may ever be drawn on.
  constexpr int64_t kLeast = 256 * 1024, kMost = 8 << 20;
  const Surface& s = c.framebuffer.surface;
  const int64_t pixels = int64_t(s.width) * s.height;
  if (pixels < kLeast || pixels > kMost || !takes(FastPath::EarlyPages)) return;
  std::vector<Pages> pages = {open_early_pages()};
  c.frame.prepare(pages);
  c.framebuffer.prepare(pages);
  bring_in(pages);
} catch (const std::bad_alloc&) {} // the first frame asks for what is missing itself

namespace gl {

void Flush(Context& c) { finish_and_resolve(c); }
void Finish(Context& c) { finish_and_resolve(c); }

} // namespace gl
} // namespace softgl
