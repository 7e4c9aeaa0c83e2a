// softgl/softgl.h.
#include <softgl/softgl.h>

#include "api/call_trace.h"
#include "base/cpu_features.h"
#include "commands/framebuffer/flush.h"
#include "context/current_context.h"
#include "frame/parallel.h"
#include "frame/surface_work.h"

using namespace softgl;

namespace {

uint64_t mixed(uint64_t hash, uint64_t word) {
  hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
  return hash ^ (hash >> 29);
}

} // namespace

extern "C" {

SOFTGL_EXPORT const char* softgl_version() {
  SOFTGL_TRACED(softgl_version);
  return SOFTGL_VERSION_TEXT;
}
SOFTGL_EXPORT void softgl_set_threads(int count) {
  SOFTGL_TRACED(softgl_set_threads, count);
  set_drawing_threads(count);
}
SOFTGL_EXPORT int softgl_threads() {
  SOFTGL_TRACED(softgl_threads);
  return drawing_threads();
}
SOFTGL_EXPORT const char* softgl_isa() {
  SOFTGL_TRACED(softgl_isa);
  return isa_name(selected_isa());
}

SOFTGL_EXPORT uint64_t softgl_frame_hash() {
  SOFTGL_TRACED(softgl_frame_hash);
  Context& c = *current_context;
  if (c.guard & kNoContext) return 0;
  try {
    flush_rendering(c);
    resolve_samples(c.framebuffer);
    write_tiles(c.framebuffer);
  } catch (...) { set_error(c, GL_OUT_OF_MEMORY); }
  const Surface& s = c.framebuffer.seen().surface;
  uint64_t hash = mixed(uint64_t(s.width) << 32 | uint32_t(s.height), uint64_t(s.color_format));
  const size_t bytes = size_t(bytes_per_pixel(s.color_format));
  const auto* color = static_cast<const unsigned char*>(s.color);
  for (int y = 0; y < s.height; ++y)
    for (int x = 0; x < s.width; ++x) {
      const size_t i = color_index(s, x, y);
      uint64_t word = 0;
      for (size_t b = 0; b < bytes; ++b) {
        word = word << 8 | color[i * bytes + b];
        if (b % 8 == 7) hash = mixed(hash, word);
      }
      if (bytes < 8) hash = mixed(hash, word);
      if (s.depth_stencil) hash = mixed(hash, s.depth_stencil[depth_index(s, x, y)]);
    }
  return hash;
}

SOFTGL_EXPORT void softgl_get_statistics(softgl_statistics* statistics) {
  SOFTGL_TRACED(softgl_get_statistics, statistics);
  if (!statistics) return;
  *statistics = {};
  const Context& c = *current_context;
  if (c.guard & kNoContext) return;
  const FramebufferCounts& counts = c.framebuffer.counts;
  *statistics = {counts.flushes, counts.resolves, counts.clears, counts.reads};
}

} // extern "C"
