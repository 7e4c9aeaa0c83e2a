// One picture, whichever way the vertices come: immediate mode, display list, vertex arrays, indices, buffer
// objects.
#include <catch2/catch.hpp>

#include "conformance/families/paths.h"
#include "support/environment.h"
#include "support/runner.h"

namespace softgl::test {
namespace {

Path path = Path::Immediate; // read by the scene while it draws

void check_path(Path other) {
  const Scene scene{"paths", [](Stage& s) { draw_by_path(s, path, false); }, true};
  for (uint64_t seed = 0; seed < uint64_t(seed_count(60)); seed++) {
    path = Path::Immediate;
    const Picture expected = draw(softgl_library(), scene, seed);
    path = other;
    const Picture got = draw(softgl_library(), scene, seed);
    const Difference d = compare(got, expected);
    INFO("seed " << seed << ": " << d.text);
    CHECK_FALSE(d.any());
  }
  path = Path::Immediate;
}

} // namespace

TEST_CASE("a display list draws what immediate mode draws", "[identity][slow]") { check_path(Path::List); }
TEST_CASE("a list in a list draws what immediate mode draws", "[identity][slow]") {
  check_path(Path::NestedList);
}
TEST_CASE("vertex arrays draw what immediate mode draws", "[identity][slow]") { check_path(Path::Arrays); }
TEST_CASE("indexed arrays draw what immediate mode draws", "[identity][slow]") { check_path(Path::Elements); }
TEST_CASE("glArrayElement draws what immediate mode draws", "[identity][slow]") {
  check_path(Path::ArrayElement);
}
TEST_CASE("buffer objects draw what immediate mode draws", "[identity][slow]") { check_path(Path::Buffers); }
TEST_CASE("arrays compiled into a list draw what immediate mode draws", "[identity][slow]") {
  check_path(Path::ArraysInList);
}

} // namespace softgl::test
