// The manifest of reference/osmesa: softgl draws what it says, and it says what the live OSMesa draws.
#include <catch2/catch.hpp>

#include <set>

#include "support/manifest.h"
#include "test_paths.h"

namespace softgl::test {
namespace {

const char kPath[] = SOFTGL_TEST_SOURCE_DIR "/reference/osmesa/manifest.txt";

void check_rows(const Manifest& manifest, const Gl& gl) {
  for (const ManifestRow& row : manifest.rows) {
    INFO(row.scene << " " << row.first << " to " << row.first + row.count - 1);
    CHECK(draw_hash(gl, *find_scene(row.scene), row.first, row.count) == row.hash);
  }
}

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
  check_rows(read_manifest(kPath), softgl_library());
}

TEST_CASE("the live OSMesa draws the pictures of the manifest", "[manifest][slow]") {
  const Manifest manifest = read_manifest(kPath);
  const std::string live = library_text(osmesa_library());
  if (live != manifest.library) {
    WARN("SKIPPED: the manifest is of " << manifest.library << ", and this is " << live);
    return;
  }
  check_rows(manifest, osmesa_library());
}

} // namespace softgl::test
