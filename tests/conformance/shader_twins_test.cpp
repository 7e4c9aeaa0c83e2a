// shaders/glsl against softgl: the same random lighting states, drawn by OSMesa with the shaders.
#include <catch2/catch.hpp>

#include "support/environment.h"
#include "support/runner.h"
#include "support/shader_twins.h"

namespace softgl::test {
namespace {

constexpr int kStatesPerScene = 10;

// Draws the lighting states of a family from `first` on both ways: the same pixels are covered, no channel differs by more than 1/255,
// and 99.9 % of them are equal.
void compare_with_twin(const char* family, int first, int states) {
  fix_environment();
  const Gl shaders = shader_library(Twins::PhongAndGouraud);
  const Scene& scene = *find_scene(family);
  size_t channels = 0, unequal = 0;
  for (int seed = first / kStatesPerScene; seed < (first + states) / kStatesPerScene; seed++) {
    const Picture ours = draw(softgl_library(), scene, uint64_t(seed)), theirs = draw(shaders, scene, uint64_t(seed));
    const Difference d = compare(ours, theirs);
    INFO(family << " " << seed << ": " << d.text);
    CHECK_FALSE(d.size);
    CHECK_FALSE(d.errors);
    CHECK(d.depth_values == 0); // coverage
    CHECK(d.max_color <= 1);
    channels += ours.color.size(), unequal += d.color_bytes;
  }
  INFO(unequal << " of " << channels << " channels differ");
  CHECK(unequal * 1000 <= channels);
}

} // namespace

// Several cases, that they can run at the same time.
TEST_CASE("Gouraud shading is that of its GLSL twin", "[conformance][glsl][slow]") { compare_with_twin("gouraud_twin", 0, 200); }
TEST_CASE("Phong shading is that of its GLSL twin: states 0 to 249", "[conformance][glsl][slow]") { compare_with_twin("phong_twin", 0, 250); }
TEST_CASE("Phong shading is that of its GLSL twin: states 250 to 499", "[conformance][glsl][slow]") { compare_with_twin("phong_twin", 250, 250); }
TEST_CASE("Phong shading is that of its GLSL twin: states 500 to 749", "[conformance][glsl][slow]") { compare_with_twin("phong_twin", 500, 250); }
TEST_CASE("Phong shading is that of its GLSL twin: states 750 to 999", "[conformance][glsl][slow]") { compare_with_twin("phong_twin", 750, 250); }

} // namespace softgl::test
