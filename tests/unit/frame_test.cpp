#include "frame/frame.h"

#include <catch2/catch.hpp>

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
