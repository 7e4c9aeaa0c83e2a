// What a tile worker does with the segments of its list: primitives by 8x8 blocks, finished fragments one by
// one.
#pragma once

#include "shaders/raster/raster_direct.inl"
#include "shaders/raster/raster_multisample.inl"
#include "shaders/raster/raster_small_samples.inl"
#include "shaders/raster/raster_spans.inl"
#include "shaders/raster/raster_staged.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Draws primitives into a tile, in order.
static void tile_primitives(const TileTarget& tile, const RasterDraw& draw,
                            const RasterPrimitive* const* primitive, int32_t count, FragmentBlock& block) {
  const FragmentKey& key = draw.program->key;
  const bool depth = tile.depth_stencil &&
                     (Compare(key.depth_function) != Compare::Always || key.depth_write || key.stencil);
  if (draw.raster->samples > 1) {
    if (depth)
      multisampled_primitives<true>(tile, draw, primitive, count, block);
    else
      multisampled_primitives<false>(tile, draw, primitive, count, block);
    return;
  }
  if (draw.direct) {
    if (depth && key.stencil)
      direct_primitives<DirectTests::DepthAndStencil>(tile, draw, primitive, count);
    else if (depth)
      direct_primitives<DirectTests::Depth>(tile, draw, primitive, count);
    else
      direct_primitives<DirectTests::None>(tile, draw, primitive, count);
    return;
  }
  if (depth)
    staged_primitives<true>(tile, draw, primitive, count, block);
  else
    staged_primitives<false>(tile, draw, primitive, count, block);
}

/// Merges finished fragments into a tile, in order.
static void tile_fragments(const TileTarget& tile, const RasterDraw& draw, const SmallFragments& fragments,
                           int32_t count) {
  const FragmentProgram& program = *draw.program;
  const FragmentKey& key = program.key;
  // Whatever stages there were have run: often what is left is a depth test that can be told from whole
  // words.
  const Compare function = Compare(key.depth_function);
  const bool less = function == Compare::Less && key.depth_write,
             less_equal = function == Compare::LessEqual && key.depth_write;
  const bool words = draw.replaces_words;
  if (words && (!tile.depth_stencil || (function == Compare::Always && !key.depth_write))) {
    auto* color = static_cast<uint32_t*>(tile.color);
    for (int32_t i = 0; i < count; ++i) color[fragments.pixel[i]] = fragments.color[i];
    return;
  }
  if (words && tile.one_stencil && (less || less_equal)) {
    auto* color = static_cast<uint32_t*>(tile.color);
    uint32_t* words = tile.depth_stencil;
    const SmallFragments f = fragments;
    const uint32_t stencil = tile.stencil_bits;
    auto merge = [&](auto fails) __attribute__((always_inline)) {
      for (int32_t i = 0; i < count; ++i) {
        const uint32_t pixel = f.pixel[i], word = f.depth[i] | stencil;
        // Neighbours mostly fare alike: without a branch, by masks, all of mesh70k takes 5 % longer.
        if (fails(word, words[pixel])) continue;
        words[pixel] = word;
        color[pixel] = f.color[i];
      }
    };
    if (less)
      merge([](uint32_t word, uint32_t stored) { return word >= stored; });
    else
      merge([](uint32_t word, uint32_t stored) { return word > stored; });
    return;
  }
  merge_fragments(tile, program, fragments, count);
}

/// Shades small triangles and merges their fragments, in order.
template <bool Staged> static void shade_triangles(const TileTarget& tile, const RasterDraw& draw,
                                                   const SmallTriangle* triangle, int32_t count,
                                                   FragmentBlock& block) {
  constexpr int32_t kMost = 4 * kLanes; // fragments at a time, which so stay in the nearest cache
  SmallPixels pixels;
  alignas(64) uint16_t pixel[kMost + kWidth];
  alignas(64) uint32_t depth[kMost + kWidth], color[kMost + kWidth], live[kMost + kWidth];
  const FragmentWords words(draw, pixel, depth, color, live);
  const bool killing = Staged && draw.program->tests_alpha();
  for (; count > 0; triangle += kWidth, count -= kWidth) {
    const int lanes = count < kWidth ? count : kWidth;
    SmallTriangle padded[kWidth];
    const SmallTriangle* const group = whole_group(triangle, count, padded);
    StoredPlanes stored;
    CornerPlanes planes(group);
    list_pixels<1>(*draw.raster, tile, planes.position, lanes, pixels, nullptr);
    const int32_t all = pixels.end[lanes - 1];
    if (all == 0) continue;
    store_planes(draw, planes, stored);
    for (int i = 0; i < kWidth; ++i) pixels.place[all + i] = pixels.place[0];
    for (int32_t first = 0, number = 0; first < all; first += kMost) {
      int32_t end = all - first < kMost ? all - first : kMost;
      const uint16_t* place = pixels.place + first;
      SmallShader<Staged> shader(draw, block);
      const auto place_at = [&](int32_t f) __attribute__((always_inline)) {
        const IntV p = load_halves(place + f);
        store_halves(pixel + f, pixels_in_tile(p));
        return p;
      };
      if constexpr (Staged) {
        for (int32_t f = 0; f < end; f += kNumberedLanes) {
          const int32_t most = end - f < kNumberedLanes ? end - f : kNumberedLanes;
          alignas(64) int32_t number_of[kLanes];
          for (int32_t i = 0; i < most; i += kWidth) put_places(place_at(f + i), tile, i, number_of, block);
          interpolate_numbered(draw, stored, number_of, most, block, depth + f);
          shader.finish(words, f + most);
        }
      } else {
        auto shade = [&](int32_t f, auto&& chosen) __attribute__((always_inline)) {
          const IntV p = place_at(f);
          shader.shade(words, chosen, f, (p & 63) + tile.x, ((p >> 6) & 63) + tile.y);
        };
        if constexpr (kWidth > 4) {
          for (int32_t f = 0; f < end; f += kWidth)
            shade(f, ChosenPlanes{stored, load_halves(place + f) >> 12});
        } else {
          for (int32_t f = 0; f < end;) {
            const int32_t last = pixels.end[number] - first;
            for (; f < last && f < end; f += kWidth) shade(f, OnePlanes{stored, number});
            if (last > end) break; // the triangle has pixels beyond
            f = last, ++number;
          }
        }
      }
      if (killing) {
        int32_t living = 0;
        for (int32_t i = 0; i < end; ++i) {
          pixel[living] = pixel[i], depth[living] = depth[i], color[living] = color[i];
          living += live[i] != 0;
        }
        end = living;
      }
      tile_fragments(tile, draw, {pixel, depth, color}, end);
    }
  }
}

static void tile_triangles(const TileTarget& tile, const RasterDraw& draw, const SmallTriangle* triangle,
                           int32_t count, FragmentBlock& block) {
  if (draw.raster->per_sample)
    shade_sampled_triangles<true>(tile, draw, triangle, count, block);
  else if (draw.raster->samples > 1)
    shade_sampled_triangles<false>(tile, draw, triangle, count, block);
  else if (draw.program->step_count)
    shade_triangles<true>(tile, draw, triangle, count, block);
  else
    shade_triangles<false>(tile, draw, triangle, count, block);
}

} // namespace SOFTGL_ISA
} // namespace softgl
