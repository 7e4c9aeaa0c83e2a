// Phong shading against the specification's equations in double: the lighting states of the family
// phong_twin.
#include <catch2/catch.hpp>

#include "support/environment.h"
#include "support/spec_picture.h"

namespace softgl::test {
namespace {

constexpr int kStatesPerScene = 10;

void compare_with_spec(int first, int states) {
  fix_environment();
  const Scene& scene = *find_scene("phong_twin");
  size_t pixels = 0, certain = 0, covered = 0;
  for (int seed = first / kStatesPerScene; seed < (first + states) / kStatesPerScene; seed++) {
    const SpecPicture p = draw_with_spec(scene, uint64_t(seed));
    size_t wrong = 0, where = 0;
    for (size_t i = 0; i < p.certain.size(); i++) {
      pixels++, certain += p.certain[i], covered += p.covered[i];
      if (!p.certain[i]) continue;
      for (size_t c = 4 * i; c < 4 * i + 4; c++)
        if (std::abs(p.drawn.color[c] - p.color[c]) > 1) wrong++, where = c;
    }
    INFO("seed " << seed << ": " << wrong << " channels, one of them " << where % 4 << " of pixel "
                 << where / 4 % p.drawn.width << "," << where / 4 / p.drawn.width << ": "
                 << int(p.drawn.color[where]) << " instead of " << int(p.color[where]));
    CHECK(wrong == 0);
  }
  INFO(certain << " of " << pixels << " pixels are certain, " << covered << " covered");
  CHECK(certain > pixels * 9 / 10);
  CHECK(covered > pixels / 5);
}

} // namespace

TEST_CASE("Phong shading is the specification's: states 0 to 249", "[conformance][reference][slow]") {
  compare_with_spec(0, 250);
}
TEST_CASE("Phong shading is the specification's: states 250 to 499", "[conformance][reference][slow]") {
  compare_with_spec(250, 250);
}
TEST_CASE("Phong shading is the specification's: states 500 to 749", "[conformance][reference][slow]") {
  compare_with_spec(500, 250);
}
TEST_CASE("Phong shading is the specification's: states 750 to 999", "[conformance][reference][slow]") {
  compare_with_spec(750, 250);
}

} // namespace softgl::test
