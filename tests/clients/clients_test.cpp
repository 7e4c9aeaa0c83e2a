// Programs that others wrote draw with softgl what they draw with OSMesa: MuJoCo (libmujoco-dev) and PyOpenGL
// with GLU (python3-opengl). Where a package is missing the case says so and is skipped.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "clients/client_runs.h"
#include "test_paths.h"

namespace softgl::test {
namespace {

float float_at(const std::string& bytes, size_t i) {
  float v;
  std::memcpy(&v, bytes.data() + 4 * i, 4);
  return v;
}

/// Between two pictures of MuJoCo: how many color components differ, and how far the depths are apart.
struct Differences {
  int colors = 0;
  float greatest_depth = 0;
};
Differences differences_of(const Pair& pair) {
  REQUIRE(pair.ours.size() == pair.theirs.size());
  int32_t size[2];
  REQUIRE(pair.ours.size() > sizeof size);
  std::memcpy(size, pair.ours.data(), sizeof size);
  const size_t pixels = size_t(size[0]) * size_t(size[1]), colors_end = 8 + 3 * pixels;
  REQUIRE(pair.ours.size() == colors_end + 4 * pixels);
  Differences d;
  for (size_t i = 8; i < colors_end; ++i) d.colors += pair.ours[i] != pair.theirs[i];
  const std::string ours = pair.ours.substr(colors_end), theirs = pair.theirs.substr(colors_end);
  for (size_t i = 0; i < pixels; ++i)
    d.greatest_depth = std::max(d.greatest_depth, std::abs(float_at(ours, i) - float_at(theirs, i)));
  return d;
}

} // namespace

TEST_CASE("MuJoCo draws what it draws with OSMesa", "[clients]") {
  const std::string client = std::string(SOFTGL_TEST_BINARY_DIR) + "/softgl_mujoco";
  if (!std::filesystem::exists(client)) {
    WARN("SKIPPED: libmujoco-dev is not installed");
    return;
  }
  for (const std::string& scene : output_lines(client + " --list")) {
    INFO(scene);
    const Pair pair = run_with_both(
        "mujoco_" + scene, [&](const std::string& library) { return client + " " + library + " " + scene; });
    const Differences d = differences_of(pair);
    CHECK(d.colors == 0);
    // OSMesa's resolve loses the last bit of depths (reference/DEVIATIONS.md).
    CHECK(d.greatest_depth <= (scene == "multisampled" ? 1.0f / 16777216.0f : 0.0f));
  }
}

TEST_CASE("PyOpenGL and GLU draw what they draw with OSMesa", "[clients]") {
  const std::string client =
      "/usr/bin/python3 " + std::string(SOFTGL_TEST_SOURCE_DIR) + "/tests/clients/pyopengl_client.py";
  int code = 0;
  output_of("/usr/bin/python3 -c 'import OpenGL, numpy'", code);
  if (code != 0) {
    WARN("SKIPPED: python3-opengl or python3-numpy is not installed");
    return;
  }
  for (const std::string& scene :
       output_lines("LD_LIBRARY_PATH=" + loader_folder(SOFTGL_TEST_LIBRARY) + " " + client + " --list"))
    for (const std::string type : {"ubyte", "ushort", "float"}) {
      INFO(scene << ", " << type);
      const Pair pair = run_with_both("pyopengl_" + scene + "_" + type, [&](const std::string& library) {
        return "LD_LIBRARY_PATH=" + loader_folder(library) + " " + client + " " + scene + " " + type;
      });
      REQUIRE(pair.theirs.size() > 8);
      if (scene != "nurbs") {
        CHECK(pair.ours == pair.theirs);
        continue;
      }
      // Points of a surface are sums of four by four products, which OSMesa adds in another order: the last
      // bit of a depth of 24 bits may differ, and a color as much as it changes over that.
      REQUIRE(pair.ours.size() == pair.theirs.size());
      float furthest = 0;
      for (size_t i = 2; i < pair.ours.size() / 4; ++i)
        furthest = std::max(furthest, std::abs(float_at(pair.ours, i) - float_at(pair.theirs, i)));
      CHECK(furthest <= 4.0f / 16777216.0f + (type == std::string("ushort") ? 1.0f / 65535.0f : 0.0f));
    }
}

} // namespace softgl::test
