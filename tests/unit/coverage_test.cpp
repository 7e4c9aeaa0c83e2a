// Blocks of pixels and the edges of a primitive, in the vectors that this file is compiled for.
#define SOFTGL_ISA coverage_test
#include <catch2/catch.hpp>

#include "shaders/raster/raster_coverage.inl"

namespace softgl::coverage_test {
namespace {

/// A triangle with corners at (0, 0), (200, 0) and (0, 200): c - a * x + b * y >= 0 inside.
RasterPrimitive large_triangle() {
  RasterPrimitive p{};
  p.a[0] = -1, p.b[1] = 1, p.a[2] = 1, p.b[2] = -1, p.c[2] = 199;
  p.x1 = p.y1 = 200;
  p.edges = 3;
  return p;
}

} // namespace

TEST_CASE("blocks inside a triangle are known to be whole, unless that is off", "[raster]") {
  const RasterPrimitive p = large_triangle();
  RasterDraw draw{};
  draw.whole_blocks = true;
  TileEdges edges;
  int32_t e[4];
  REQUIRE(clip_to_tile<3>(draw, p, 0, 0, edges));
  CHECK(edges.inside);
  REQUIRE(clip_to_tile<3>(draw, p, 128, 0, edges));
  CHECK_FALSE(edges.inside);
  CHECK(place_block<3>(edges, 0, 0, e) == BlockPlace::Inside);
  CHECK(place_block<3>(edges, 56, 56, e) == BlockPlace::Outside);
  for (int x = 0; x < 256; x += kTileSize) {
    TileEdges tested;
    draw.whole_blocks = true;
    const bool any = clip_to_tile<3>(draw, p, x, 0, edges);
    draw.whole_blocks = false;
    CHECK(clip_to_tile<3>(draw, p, x, 0, tested) == any);
    if (!any) continue;
    CHECK_FALSE(tested.inside);
    EdgeSteps<3> steps;
    edge_steps<3>(p, steps);
    for (int y = 0; y < kTileSize; y += 8)
      for (int dx = 0; dx < kTileSize; dx += 8) {
        CHECK(place_block<3>(tested, dx, y, e) != BlockPlace::Inside);
        const uint64_t all = edges.inside ? box_mask(edges, dx, y) : block_coverage<3>(edges, steps, dx, y);
        CHECK(block_coverage<3>(tested, steps, dx, y) == all);
      }
  }
}

} // namespace softgl::coverage_test
