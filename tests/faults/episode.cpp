#include "faults/episode.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace softgl::test {

static int gl_threads() {
  const char* text = std::getenv("SOFTGL_THREADS");
  return text ? std::atoi(text) : 0;
}

Outcome play(const Gl& gl, const Episode& e) {
  Outcome o;
  try {
    Player player(gl, e.seed);
    fail_allocation(e.k, e.persistent);
    e.stream.run(player);
    const Allocations seen = stop_failing();
    o.calls = seen.calls, o.failed = seen.failed;
    o.result = player.result();
    o.out_of_memory = player.out_of_memory();
    o.disorderly = player.disorderly();
    player.restore();
    o.frame = draw_reference_frame(player);
    if (!o.disorderly) {
      player.restart();
      e.stream.run(player);
      player.restore();
      o.again = player.result();
      o.again_out_of_memory = player.out_of_memory();
    }
  } catch (const std::exception& error) {
    stop_failing();
    std::snprintf(o.failure, sizeof o.failure, "%s", error.what());
  }
  o.left = live_memory();
  // A worker may still hold what it was asked to bring in: a busy machine lets it wait.
  const auto may_shrink = [&] {
    return !e.usual || o.left.objects > e.usual->objects || o.left.mapped_bytes > e.usual->mapped_bytes;
  };
  for (int i = 0; i < (e.usual ? 4000 : 20) && gl_threads() > 1 && may_shrink(); ++i) {
    usleep(500);
    const LiveMemory now = live_memory();
    o.left = {std::min(o.left.objects, now.objects), std::min(o.left.mapped_bytes, now.mapped_bytes)};
  }
  return o;
}

std::string judge(const Outcome& o, const Outcome& clean) {
  if (o.failure[0]) return o.failure;
  if (o.failed == 0 && o.out_of_memory) return "GL_OUT_OF_MEMORY although nothing failed";
  if (!o.disorderly && !o.out_of_memory && o.result != clean.result)
    return "another picture, and no error says so";
  if (o.frame != clean.frame) return "the next frame is another one";
  if (o.again_out_of_memory) return "GL_OUT_OF_MEMORY when the stream is played again";
  if (o.again != clean.again) return "another picture when the stream is played again";
  if (o.left.objects > clean.left.objects)
    return std::to_string(o.left.objects - clean.left.objects) + " allocations are lost";
  if (o.left.mapped_bytes > clean.left.mapped_bytes)
    return std::to_string(o.left.mapped_bytes - clean.left.mapped_bytes) + " mapped bytes are lost";
  return {};
}

} // namespace softgl::test
