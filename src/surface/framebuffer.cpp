#include "surface/framebuffer.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#include "base/pages.h"
#include "surface/accumulation.h"
#include "surface/stored_color.h"

namespace softgl {
namespace {

bool plane_bytes(int tiles_x, int tiles_y, size_t pixel_bytes, size_t& bytes) {
  size_t tiles = 0;
  return !__builtin_mul_overflow(size_t(tiles_x), size_t(tiles_y), &tiles) &&
         !__builtin_mul_overflow(tiles, kTilePixels * pixel_bytes, &bytes) && bytes < (size_t(1) << 46);
}

} // namespace

void Framebuffer::release() {
  unmap_pages(surface.color, color_bytes_);
  if (depth_bytes_) unmap_pages(surface.depth_stencil, depth_bytes_);
  if (accumulation) unmap_pages(accumulation, accumulation_bytes_);
  surface = Surface{};
  color_tiles_.clear();
  depth_tiles_.clear();
  accumulation = nullptr;
  color_bytes_ = depth_bytes_ = accumulation_bytes_ = 0;
}

void Framebuffer::make_accumulation() {
  if (accumulation) return;
  const size_t bytes = accumulation_numbers(surface) * sizeof(int16_t);
  accumulation = static_cast<int16_t*>(map_pages(bytes));
  if (!accumulation) throw std::bad_alloc();
  accumulation_bytes_ = bytes;
}

void Framebuffer::set_samples(int count) {
  samples = count;
  resolved.reset();
  if (count == 1) return;
  resolved = std::make_unique<Framebuffer>();
  resolved->has_alpha = has_alpha;
  resolved->depth_bits = depth_bits;
  resolved->stencil_bits = stencil_bits;
}

bool Framebuffer::allocate(int width, int height, ColorFormat color_format) {
  Surface s{};
  s.width = width;
  s.height = height;
  s.tiles_x = int((int64_t(width) + kTileSize - 1) / kTileSize);
  s.tiles_y = int((int64_t(height) + kTileSize - 1) / kTileSize);
  s.plane_width = width;
  s.plane_height = height;
  s.color_columns = s.depth_columns = s.tiles_x;
  s.color_format = color_format;
  s.encoding = whole_encoding(color_format, has_alpha);
  s.depth_format = depth_bits == 0 && stencil_bits == 0    ? DepthFormat::None
                   : depth_bits == 16 && stencil_bits == 0 ? DepthFormat::Z16
                                                           : DepthFormat::Z24S8;
  size_t color_bytes = 0, depth_bytes = 0;
  const auto n = size_t(samples);
  if (!plane_bytes(s.tiles_x, s.tiles_y, n * size_t(bytes_per_pixel(color_format)), color_bytes))
    return false;
  const bool waits = color_format == ColorFormat::Rgba8;
  const size_t tiles = size_t(s.tiles_x) * size_t(s.tiles_y);
  std::vector<TileWords> color_tiles(tiles, TileWords{has_alpha ? 0 : 0xff000000u, ~0u, waits}), depth_tiles;
  if (s.depth_format != DepthFormat::None) depth_tiles.assign(tiles, TileWords{0, ~0u, true});
  uint32_t places = 0;
  if (!waits)
    for (size_t i = 0; i < tiles; ++i) {
      color_tiles[i].place = places;
      if (!depth_tiles.empty()) depth_tiles[i].place = places;
      places += uint32_t(samples);
    }
  if (s.depth_format != DepthFormat::None &&
      !plane_bytes(s.tiles_x, s.tiles_y, n * sizeof(uint32_t), depth_bytes))
    return false;
  s.samples = s.pixel_step = samples;
  s.place_step = uint32_t(samples);
  if (depth_bytes && color_format == ColorFormat::Rgba8)
    s.place_step *= 2, color_bytes += std::exchange(depth_bytes, 0);
  s.color = map_pages(color_bytes);
  if (!s.color) return false;
  if (s.place_step == 2 * uint32_t(samples))
    s.depth_stencil = static_cast<uint32_t*>(s.color) + n * kTilePixels;
  if (depth_bytes) {
    s.depth_stencil = static_cast<uint32_t*>(map_pages(depth_bytes));
    if (!s.depth_stencil) {
      unmap_pages(s.color, color_bytes);
      return false;
    }
  }
  if (!has_alpha) { fill_alpha(color_format, s.encoding, s.color, color_bytes); }
  if (resolved && !resolved->allocate(width, height, color_format)) {
    unmap_pages(s.color, color_bytes);
    if (depth_bytes) unmap_pages(s.depth_stencil, depth_bytes);
    return false;
  }
  release();
  color_tiles_ = std::move(color_tiles);
  depth_tiles_ = std::move(depth_tiles);
  s.color_tile = color_tiles_.data();
  s.depth_tile = depth_tiles_.empty() ? nullptr : depth_tiles_.data();
  next_place_ = places;
  s.next_place = &next_place_;
  surface = s;
  unwritten = samples_changed = true;
  color_bytes_ = color_bytes;
  depth_bytes_ = depth_bytes;
  return true;
}

void Framebuffer::prepare(std::vector<Pages>& pages) const {
  // Three quarters of the tiles of a picture of 1024x1024 pixels: few pictures fill all of it, and more comes
  // when it is written.
  pages.push_back({surface.color, std::min(color_bytes_, 3 * kHugePage)});
  pages.push_back({surface.depth_stencil, std::min(depth_bytes_, kHugePage)});
  const Pages buffer = {client.data, size_t(surface.width) * size_t(surface.height) *
                                         size_t(bytes_per_pixel(surface.color_format))};
  prefer_huge_pages(buffer); // 4 MB of the caller's small pages take 2 to 5 ms, in huge ones 0.4
  pages.push_back(buffer);
}

} // namespace softgl
