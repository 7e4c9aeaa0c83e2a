#include "frame/surface_work.h"

#include <algorithm>

#include "frame/parallel.h"
#include "frame/tile_worker.h"
#include "surface/sample_resolve.h"

namespace softgl {
namespace {

/// With all threads; below about a quarter of a megapixel a copy is shorter than waking a thread.
template <class Visit> void for_each_tile(int width, int height, size_t tiles, Visit&& visit) {
  if (int64_t(width) * height < 256 * 1024)
    for (size_t tile = 0; tile < tiles; ++tile) visit(uint32_t(tile));
  else
    in_parallel(tiles, [&](size_t tile) { visit(uint32_t(tile)); });
}

template <class Visit> void for_each_tile(const Surface& s, Visit&& visit) {
  for_each_tile(s.width, s.height, size_t(s.tiles_x) * size_t(s.tiles_y), visit);
}

} // namespace

void load_plane(RenderPlane& plane, const TextureImage& image, int slice, int sample) {
  for_each_tile(plane.width, plane.height, plane.tiles(),
                [&](uint32_t tile) { load_tile(plane, image, slice, tile, sample); });
}

void store_plane(RenderPlane& plane, TextureImage& image, int slice, int sample) {
  for_each_tile(plane.width, plane.height, plane.tiles(),
                [&](uint32_t tile) { store_tile(plane, image, slice, tile, sample); });
}

bool has_changed(const RenderPlane& plane) {
  return std::any_of(plane.tile.begin(), plane.tile.end(), [](const TileWords& t) { return t.changed; });
}

void write_tiles(RenderTarget& f) {
  if (!f.unwritten) return;
  f.unwritten = false;
  const Surface& s = f.surface;
  for_each_tile(s, [&](uint32_t tile) { write_tile(s, tile); });
}

void accumulate(Framebuffer& f, const Accumulation& accumulation) {
  if (accumulation.operation == AccumulationOperation::Return) { // to all samples alike
    f.samples_changed = true;
    for (int i = 0; i < f.surface.samples; ++i) {
      const Surface s = sample_surface(f.surface, i);
      for_each_tile(s, [&](uint32_t tile) { accumulate_tile(s, f.accumulation, accumulation, tile); });
    }
    return;
  }
  resolve_samples(f);
  const Surface& s = f.seen().surface;
  for_each_tile(s, [&](uint32_t tile) { accumulate_tile(s, f.accumulation, accumulation, tile); });
}

void resolve_samples(Framebuffer& f) {
  if (!f.resolved || !f.samples_changed) return;
  const Surface &from = f.surface, &to = f.resolved->surface;
  for_each_tile(from, [&](uint32_t tile) {
    write_tile(from, tile);
    write_tile(to, tile);
    resolve_samples(from, to, tile);
  });
  f.samples_changed = false;
}

void resolve(const Surface& s, const ClientBuffer& client) {
  const Resolver resolver(s, client);
  for_each_tile(s, [&](uint32_t tile) { resolver.read(tile); });
}

} // namespace softgl
