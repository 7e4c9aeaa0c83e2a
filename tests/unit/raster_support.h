// Drives set-up, tile lists and tile worker without the vertex side: triangles in window space in, a surface
// out.
#pragma once

#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include "base/float_environment.h"
#include "draw/draw_record.h"
#include "frame/tile_worker.h"
#include "raster/raster_draws.h"
#include "raster/tile_binner.h"

namespace raster_test {

using namespace softgl;

struct Canvas {
  std::vector<uint32_t> color, depth;
  std::vector<TileWords> color_tiles, depth_tiles;
  Surface surface{};
  Canvas(int width, int height, ColorFormat format = ColorFormat::Rgba8, int samples = 1) {
    surface.width = width, surface.height = height;
    surface.tiles_x = (width + 63) / 64, surface.tiles_y = (height + 63) / 64;
    surface.color_format = format;
    surface.depth_format = DepthFormat::Z24S8;
    const size_t pixels = size_t(surface.tiles_x) * size_t(surface.tiles_y) * kTilePixels * size_t(samples);
    color.assign(pixels * size_t(bytes_per_pixel(format)) / 4, 0x20406080u);
    depth.assign(pixels, 0x00ffffffu);
    surface.plane_width = width, surface.plane_height = height;
    surface.samples = surface.pixel_step = samples, surface.place_step = uint32_t(samples);
    surface.color_columns = surface.depth_columns = surface.tiles_x;
    color_tiles.resize(size_t(surface.tiles_x) * size_t(surface.tiles_y));
    for (size_t i = 0; i < color_tiles.size(); ++i) color_tiles[i].place = uint32_t(i) * surface.place_step;
    depth_tiles = color_tiles;
    surface.color_tile = color_tiles.data();
    surface.depth_tile = depth_tiles.data();
    surface.color = color.data();
    surface.depth_stencil = depth.data();
  }
  uint32_t at(int x, int y) const { return color[color_index(surface, x, y)]; }
  uint32_t depth_at(int x, int y) const { return depth[depth_index(surface, x, y)]; }
  bool operator==(const Canvas& o) const { return color == o.color && depth == o.depth; }
};

/// A draw of plain colored triangles; members may be changed before use.
struct Draw {
  FragmentConstants constants{};
  FragmentProgram program{};
  RasterConstants raster{};
  DrawRecord record{};
  RasterDraw derived{};
  explicit Draw(const Surface& surface) {
    program.constants = &constants;
    program.key.depth_function = uint64_t(Compare::Less);
    program.key.depth_write = 1;
    program.key.alpha_function = uint64_t(Compare::Always);
    program.key.color_mask = 15;
    program.key.color_format = uint64_t(surface.color_format);
    program.key.depth_format = uint64_t(surface.depth_format);
    raster.x1 = surface.width, raster.y1 = surface.height;
    raster.line_width = raster.point_size = 1;
    raster.samples = surface.samples;
    raster.per_sample = surface.samples > 1;
    raster.pixel_center = raster.per_sample ? 0.0f : 0.5f;
    raster.to_first_pixel = raster.per_sample ? 0 : 255;
    raster.edge_shift = raster.per_sample ? 0 : 8;
    raster.sample_mask = 15;
    record.layout.color = 1;
    record.layout.slots = 2;
    record.raster = &raster;
    record.fragment = &program;
  }
  void derive() { derived = make_raster_draw(record); }
};

/// Vertices of two slots: x y z 1/w, r g b a; three per triangle.
using Vertices = std::vector<ShadedVertices::Slot>;

inline void draw_triangles(const Canvas& canvas, const Draw& draw, const Vertices& v,
                           const Kernels& k = kernels(), size_t unit = 5000) {
  const FloatEnvironment environment;
  static auto scratch = std::make_unique<BinnerScratch>();
  static auto block = std::make_unique<FragmentBlock>();
  Arena arena;
  TileLists lists;
  std::vector<uint32_t> no_colors(canvas.surface.color ? 0 : kNoColorWords);
  const Surface& s = canvas.surface;
  const size_t triangles = v.size() / 6;
  for (size_t begin = 0; begin < triangles; begin += unit) {
    lists.begin(size_t(s.tiles_x) * size_t(s.tiles_y), arena);
    TileBinner binner(s, lists, arena, *scratch, k);
    binner.set_draw(&draw.derived);
    AssembledTriangles batch;
    for (size_t i = begin; i < std::min(triangles, begin + unit); ++i) {
      for (size_t c = 0; c < 3; ++c) batch.corner[c][batch.count] = &v[i * 6 + c * 2];
      if (++batch.count == kAssemblyBatch) binner.triangles(draw.record, batch), batch.count = 0;
    }
    if (batch.count) binner.triangles(draw.record, batch);
    for (const auto& t : lists.finish())
      execute_tile(s, t.tile, t.first, *k.raster, *block, no_colors.data());
    arena.reset();
  }
}

/// Kinds of random triangles.
enum Category {
  Tiny,
  Small,
  Medium,
  Large,
  Huge,
  Sliver,
  HalfPixelGrid,
  FineGrid,
  AxisAligned,
  OffScreen,
  Mixed,
  kCategories
};

inline Vertices random_triangles(uint32_t seed, Category category, size_t count, float width, float height) {
  std::mt19937 random(seed);
  auto uniform = [&](float lo, float hi) {
    return lo + (hi - lo) * float(random() >> 8) * (1.0f / 16777216.0f);
  };
  Vertices v;
  for (size_t i = 0; i < count; ++i) {
    Category kind = category == Mixed ? Category(random() % (kCategories - 1)) : category;
    float x[3], y[3];
    const float cx = uniform(-8, width + 8), cy = uniform(-8, height + 8);
    float extent = kind == Tiny     ? 1.0f
                   : kind == Small  ? 5.0f
                   : kind == Medium ? 20.0f
                   : kind == Huge   ? 16000.0f
                                    : 150.0f;
    for (int k = 0; k < 3; ++k) {
      x[k] = cx + uniform(-extent, extent);
      y[k] = cy + uniform(-extent, extent);
    }
    if (kind == Sliver) {
      x[2] = x[0] + (x[1] - x[0]) * uniform(0, 1) + uniform(-0.5f, 0.5f);
      y[2] = y[0] + (y[1] - y[0]) * uniform(0, 1) + uniform(-0.5f, 0.5f);
    }
    if (kind == HalfPixelGrid || kind == FineGrid) {
      const float grid = kind == HalfPixelGrid ? 2.0f : 256.0f;
      const float size = random() & 1 ? 4.0f : 40.0f;
      for (int k = 0; k < 3; ++k)
        x[k] = std::floor((cx + uniform(-size, size)) * grid) / grid,
        y[k] = std::floor((cy + uniform(-size, size)) * grid) / grid;
    }
    if (kind == AxisAligned) x[1] = x[0], y[2] = y[1];
    if (kind == OffScreen) x[0] -= width, y[1] += height;
    for (int k = 0; k < 3; ++k) {
      v.push_back({{x[k], y[k], uniform(0, 1), random() & 1 ? 1.0f : uniform(0.1f, 3.0f)}});
      v.push_back({{uniform(0, 1), uniform(0, 1), uniform(0, 1), uniform(0, 1)}});
    }
  }
  return v;
}

} // namespace raster_test
