#include "frame/frame.h"
#include "frame/surface_work.h"

#include <catch2/catch.hpp>

#include "surface/framebuffer.h"

using softgl::Frame;

namespace {
constexpr size_t kMebibyte = size_t(1) << 20;
}

TEST_CASE("a frame is over budget when it alone holds too many bytes of textures and buffers", "[frame]") {
  Frame frame;
  // What the client still has costs nothing, however often it is drawn with.
  const auto kept = std::make_shared<int>(1);
  for (int i = 0; i < 10000; i++) {
    frame.retain(kept, kMebibyte);
    REQUIRE_FALSE(frame.over_budget());
  }
  int count = 0;
  while (!frame.over_budget()) {
    frame.retain(std::make_shared<int>(2), kMebibyte);
    REQUIRE(++count < 1000);
  }
  CHECK(count > 100);
  frame.flush({});
  CHECK_FALSE(frame.over_budget());
  CHECK(kept.use_count() == 1);
}

TEST_CASE("an object that is abandoned after it was retained counts, too", "[frame]") {
  Frame frame;
  std::vector<std::shared_ptr<int>> objects;
  for (int i = 0; i < 400; i++) {
    objects.push_back(std::make_shared<int>(i));
    frame.retain(objects.back(), kMebibyte);
    frame.retain(objects.back(), kMebibyte);
    REQUIRE_FALSE(frame.over_budget());
  }
  objects.clear();
  for (int i = 0; i < 300; i++) frame.retain(std::make_shared<int>(i), kMebibyte);
  CHECK(frame.over_budget());
}

TEST_CASE("tiles take memory of the planes when they are written to, not when they are cleared", "[frame]") {
  using namespace softgl;
  Framebuffer framebuffer;
  framebuffer.depth_bits = 24;
  REQUIRE(framebuffer.allocate(256, 192, ColorFormat::Rgba8));
  const Surface& s = framebuffer.surface;
  Frame frame;
  const auto clear = [&](int32_t x0, int32_t y0, int32_t x1, int32_t y1, float red) {
    frame.append(frame.arena().make<ClearRecord>(ClearRecord{
        true, true, false, {true, true, true, true}, {red, 0, 0, 0}, uint32_t(red), 0, 0, x0, y0, x1, y1}));
    frame.flush(s);
  };
  const auto tiles = [&] { return *s.next_place / s.place_step; };
  clear(0, 0, 256, 192, 1);
  CHECK(tiles() == 0);
  clear(100, 70, 140, 80, 2); // two tiles
  CHECK(tiles() == 2);
  clear(192, 128, 200, 192, 3);
  CHECK(tiles() == 3);
  clear(64, 64, 128, 128, 4); // keeps its place
  CHECK(tiles() == 3);
  write_tiles(framebuffer);
  CHECK(tiles() == 12);
  const auto* color = static_cast<const uint32_t*>(s.color);
  for (int y = 0; y < 192; y++)
    for (int x = 0; x < 256; x++) {
      uint32_t red = 1;
      if (x >= 100 && x < 140 && y >= 70 && y < 80) red = 2;
      if (x >= 192 && x < 200 && y >= 128) red = 3;
      if (x >= 64 && x < 128 && y >= 64 && y < 128) red = 4;
      const size_t i = color_index(s, x, y);
      REQUIRE((color[i] == red && (s.depth_stencil[i] & 0xffffff) == red));
    }
}
