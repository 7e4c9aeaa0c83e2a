#include "frame/surface_work.h"

#include "frame/parallel.h"
#include "frame/tile_worker.h"

namespace softgl {
namespace {

/// With all threads; below about a quarter of a megapixel a copy is shorter than waking a thread.
template <class Visit> void for_each_tile(const Surface& s, Visit&& visit) {
  const size_t tiles = size_t(s.tiles_x) * size_t(s.tiles_y);
  if (int64_t(s.width) * s.height < 256 * 1024)
    for (size_t tile = 0; tile < tiles; ++tile) visit(uint32_t(tile));
  else
    in_parallel(tiles, [&](size_t tile) { visit(uint32_t(tile)); });
}

} // namespace

void write_tiles(Framebuffer& f) {
  if (!f.unwritten) return;
  f.unwritten = false;
  const Surface& s = f.surface;
  for_each_tile(s, [&](uint32_t tile) { write_tile(s, tile); });
}

void accumulate(Framebuffer& f, const Accumulation& accumulation) {
  const Surface& s = f.surface;
  for_each_tile(s, [&](uint32_t tile) { accumulate_tile(s, f.accumulation, accumulation, tile); });
}

void resolve(const Surface& s, const ClientBuffer& client) {
  const Resolver resolver(s, client);
  for_each_tile(s, [&](uint32_t tile) { resolver.read(tile); });
}

} // namespace softgl
