// The manifest of reference/osmesa: softgl draws what it says. That OSMesa draws it, too, follows for the
// first seeds of each family, which conformance_test.cpp compares with the live OSMesa.
#include <catch2/catch.hpp>

#include <set>

#include "support/manifest.h"
#include "test_paths.h"

namespace softgl::test {
namespace {

const char kPath[] = SOFTGL_TEST_SOURCE_DIR "/reference/osmesa/manifest.txt";

} // namespace

TEST_CASE("the manifest names every scene and family", "[manifest]") {
  std::set<std::string> names;
  for (const ManifestRow& row : read_manifest(kPath).rows) names.insert(row.scene);
  for (const auto* scenes : {&named_scenes(), &families()})
    for (const Scene& scene : *scenes) {
      INFO(scene.name << " is missing: softgl_capture --write reference/osmesa/manifest.txt");
      CHECK(names.count(scene.name) == 1);
    }
}

TEST_CASE("softgl draws the pictures of the manifest", "[manifest]") {
  for (const ManifestRow& row : read_manifest(kPath).rows) {
    INFO("build/bin/softgl_conformance --family " << row.scene << " --seed " << row.first << " --count "
                                                  << row.count << " shows the difference");
    CHECK(draw_hash(softgl_library(), *find_scene(row.scene), row.first, row.count) == row.hash);
  }
}

} // namespace softgl::test
