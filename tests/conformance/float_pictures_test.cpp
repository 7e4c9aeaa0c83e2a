// The same scenes into float buffers: what 8 bits would round away must be equal, too.
#include <catch2/catch.hpp>
#include <cstring>

#include "support/environment.h"
#include "support/runner.h"

using namespace softgl::test;

namespace {

constexpr int kWidth = 96, kHeight = 80;

std::vector<uint32_t> draw_floats(const Gl& gl, const Scene& scene, uint64_t seed) {
  void* context = gl.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, 0, nullptr);
  REQUIRE(context);
  std::vector<uint32_t> pixels(kWidth * kHeight * 4);
  REQUIRE(gl.OSMesaMakeCurrent(context, pixels.data(), GL_FLOAT, kWidth, kHeight));
  Random random(seed * 7919 + 17);
  Stage stage{gl, random, kWidth, kHeight};
  scene.draw(stage);
  gl.Finish();
  gl.OSMesaMakeCurrent(nullptr, nullptr, GL_FLOAT, 0, 0);
  gl.OSMesaDestroyContext(context);
  return pixels;
}

} // namespace

TEST_CASE("scenes have OSMesa's floats", "[osmesa][lighting][slow]") {
  fix_environment();
  for (const char* name : {"lit", "normals", "materials", "clip", "triangles", "fog", "lines", "points"}) {
    const Scene* scene = find_scene(name);
    REQUIRE(scene);
    size_t lit_values = 0;
    for (uint64_t seed = 0; seed < 12; ++seed) {
      const auto ours = draw_floats(softgl_library(), *scene, seed), theirs = draw_floats(osmesa_library(), *scene, seed);
      size_t different = 0, first = 0;
      for (size_t i = ours.size(); i-- > 0;) {
        if (ours[i] != theirs[i]) ++different, first = i;
        lit_values += ours[i] != ours[i & 3];
      }
      float a, b;
      std::memcpy(&a, &ours[first], 4);
      std::memcpy(&b, &theirs[first], 4);
      INFO(name << " seed " << seed << ": float " << first % 4 << " of pixel " << first / 4 % kWidth << "," << first / 4 / kWidth
                << " ours " << a << " theirs " << b);
      CHECK(different == 0);
    }
    CHECK(lit_values > 5000); // something was drawn
  }
}
