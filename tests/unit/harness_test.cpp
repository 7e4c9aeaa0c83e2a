// The test harness itself: a comparison that cannot fail would prove nothing.
#include <catch2/catch.hpp>

#include "support/runner.h"

using namespace softgl::test;

TEST_CASE("random numbers are the same everywhere", "[harness]") {
  Random random(7);
  const uint64_t first = random.bits();
  Random again(7);
  CHECK(again.bits() == first);
  Random other(8);
  CHECK(other.bits() != first);
  for (int i = 0; i < 1000; i++) {
    const float x = random.real(-2, 3);
    CHECK((x >= -2 && x < 3));
    const int n = random.integer(-1, 1);
    CHECK((n >= -1 && n <= 1));
  }
}

TEST_CASE("a comparison sees one byte, one depth and one error", "[harness]") {
  Picture a;
  a.width = 3, a.height = 2;
  a.color.assign(24, 9), a.depth.assign(6, 5), a.stencil.assign(6, 0);
  Picture b = a;
  CHECK_FALSE(compare(a, b).any());
  CHECK(a.hash() == b.hash());
  b.color[4 * 4 + 2] = 12;
  Difference d = compare(a, b);
  CHECK((d.color_bytes == 1 && d.max_color == 3 && d.x == 1 && d.y == 1 && d.depth_values == 0));
  CHECK(a.hash() != b.hash());
  b = a;
  b.floats = a.floats = std::vector<float>(24, 0.5f);
  b.floats[7] = 0.50000006f;
  d = compare(a, b);
  CHECK((d.floats == 1 && d.color_bytes == 0 && d.x == 1 && d.y == 0));
  CHECK(a.hash() != b.hash());
  b = a;
  b.depth[5]++;
  CHECK(compare(a, b).depth_values == 1);
  b = a;
  b.errors.push_back(GL_INVALID_ENUM);
  CHECK(compare(a, b).any());
}
