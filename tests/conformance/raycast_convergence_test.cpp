// Phong shading of a tessellated shape becomes the ray-cast picture; Gouraud shading does too, but later.
#include <catch2/catch.hpp>

#include <cstdio>

#include "support/environment.h"
#include "support/raycast_comparison.h"

using namespace softgl::test;

namespace {

void check_convergence(const char* shape, bool reflection) {
  fix_environment();
  REQUIRE(raycast_setups() >= 20);
  const std::vector<int> slices{8, 32, 128, 512};
  const std::vector<ConvergencePoint> points = compare_with_raycast(shape, reflection, slices);
  std::printf("%s, %s vector: mean error in 1/255, Phong | Gouraud, with slices", shape,
              reflection ? "reflection" : "half");
  for (int n : slices) std::printf(" %9d    ", n);
  for (size_t i = 0; i < points.size(); i++) {
    const ConvergencePoint& p = points[i];
    INFO(p.setup << ", " << p.slices << " slices, " << p.pixels << " pixels: within 1/255 Phong "
                 << p.phong_equal << ", Gouraud " << p.gouraud_equal);
    if (i % slices.size() == 0) std::printf("\n  %-70s", p.setup.c_str());
    std::printf(" %6.3f|%6.3f", p.phong_mean, p.gouraud_mean);
    CHECK(p.pixels > 2000);
    // Each step has a sixteenth of the error, until only rounding is left.
    if (i % slices.size()) CHECK(p.phong_mean <= std::max(points[i - 1].phong_mean / 2, 0.05));
    // The shape of eight slices itself is wrong, whatever shades it; a value may lie where rounding turns.
    if (p.slices > 8) CHECK(p.phong_mean <= p.gouraud_mean + 0.001);
    if (p.slices == 512) CHECK(p.phong_equal >= 0.999);
  }
  std::printf("\n");
}

} // namespace

TEST_CASE("Phong shading of a sphere becomes the ray-cast picture: half vector",
          "[conformance][reference][slow]") {
  check_convergence("sphere", false);
}
TEST_CASE("Phong shading of a plane becomes the ray-cast picture: half vector",
          "[conformance][reference][slow]") {
  check_convergence("plane", false);
}
TEST_CASE("Phong shading of a box becomes the ray-cast picture: half vector",
          "[conformance][reference][slow]") {
  check_convergence("box", false);
}
TEST_CASE("Phong shading of a sphere becomes the ray-cast picture: reflection vector",
          "[conformance][reference][slow]") {
  check_convergence("sphere", true);
}
TEST_CASE("Phong shading of a plane becomes the ray-cast picture: reflection vector",
          "[conformance][reference][slow]") {
  check_convergence("plane", true);
}
TEST_CASE("Phong shading of a box becomes the ray-cast picture: reflection vector",
          "[conformance][reference][slow]") {
  check_convergence("box", true);
}
