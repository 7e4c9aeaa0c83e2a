// The accumulation buffer with every kind of color buffer: each rounds in its own way, as OSMesa's does.
#include <catch2/catch.hpp>

#include <cstring>
#include <vector>

#include "support/environment.h"
#include "support/scene.h"

namespace softgl::test {
namespace {

struct Kind {
  const char* name;
  GLenum format, type;
  size_t bytes;
};
// Not GL_RGB with GL_UNSIGNED_BYTE: OSMesa writes over the neighbors there (reference/DEVIATIONS.md).
const Kind kKinds[] = {{"bgra ubyte", kOSMesaBgra, GL_UNSIGNED_BYTE, 4},
                       {"argb ubyte", kOSMesaArgb, GL_UNSIGNED_BYTE, 4},
                       {"rgba ushort", kOSMesaRgba, GL_UNSIGNED_SHORT, 8},
                       {"rgba float", kOSMesaRgba, GL_FLOAT, 16},
                       {"rgb float", kOSMesaRgb, GL_FLOAT, 12},
                       {"rgb 565", kOSMesaRgb565, GL_UNSIGNED_SHORT_5_6_5, 2}};
constexpr int kWidth = 97, kHeight = 70;

/// Colors by glClear, so that nothing but the accumulation buffer rounds, then a few operations.
std::vector<unsigned char> draw(const Gl& gl, const Kind& kind, uint64_t seed) {
  std::vector<unsigned char> buffer(size_t(kWidth) * kHeight * kind.bytes);
  void* context = gl.OSMesaCreateContextExt(kind.format, 24, 8, 16, nullptr);
  REQUIRE(context);
  REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), kind.type, kWidth, kHeight));
  Random random(seed);
  const auto clear = [&](GLbitfield what) {
    gl.Enable(GL_SCISSOR_TEST);
    for (int x = 0; x < kWidth; ++x) {
      const Float4 c = random.color();
      const float sign = random.chance(50) ? -1.0f : 1.0f;
      gl.Scissor(x, random.integer(0, 20), 1, kHeight);
      gl.ClearColor(c[0], c[1], c[2], c[3]);
      gl.ClearAccum(sign * c[3], c[2], -c[1], sign * c[0]);
      gl.Clear(what);
    }
    gl.Disable(GL_SCISSOR_TEST);
  };
  gl.Clear(GL_ACCUM_BUFFER_BIT); // OSMesa finds in a new one what its memory held before
  clear(GL_COLOR_BUFFER_BIT);
  clear(GL_ACCUM_BUFFER_BIT);
  for (int i = 0; i < 4; ++i) {
    const GLenum op = GLenum(random.pick({GL_ACCUM, GL_ACCUM, GL_LOAD, GL_MULT, GL_ADD}));
    gl.Accum(op, random.real(-1, 1));
    const bool red = random.chance(70), green = random.chance(70), blue = random.chance(70),
               alpha = random.chance(70);
    gl.ColorMask(red, green, blue, alpha);
    gl.Accum(GL_RETURN, random.chance(50) ? 1.0f : random.real(-2, 2));
    gl.ColorMask(1, 1, 1, 1);
    if (i == 1) clear(GL_COLOR_BUFFER_BIT);
  }
  gl.Finish();
  CHECK(gl.GetError() == GL_NO_ERROR);
  gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl.OSMesaDestroyContext(context);
  return buffer;
}

} // namespace

TEST_CASE("the accumulation buffer rounds to every format as OSMesa does", "[osmesa][accumulation]") {
  fix_environment();
  for (const Kind& kind : kKinds)
    for (uint64_t seed = 0; seed < uint64_t(seed_count(60)); ++seed) {
      INFO(kind.name << ", seed " << seed);
      const auto ours = draw(softgl_library(), kind, seed), theirs = draw(osmesa_library(), kind, seed);
      size_t differ = 0;
      for (size_t i = 0; i < ours.size(); ++i) differ += ours[i] != theirs[i];
      CHECK(differ == 0);
    }
}

} // namespace softgl::test
