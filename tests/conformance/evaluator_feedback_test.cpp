// What evaluators feed back, value for value with OSMesa: the bits that 8 bits of a picture would round away.
#include <catch2/catch.hpp>

#include <cstring>
#include <vector>

#include "spec/state_snapshot.h"
#include "support/random.h"

namespace softgl::test {
namespace {

void random_points(Random& r, std::vector<GLfloat>& points) {
  for (GLfloat& p : points) p = r.real(-0.9f, 0.9f);
}

/// Points, lines and triangles of random maps of all targets; the bits of what is fed back.
std::vector<uint32_t> evaluated(const Gl& gl, unsigned seed) {
  CurrentContext context(gl);
  Random r(seed);
  std::vector<GLfloat> values(1 << 14);
  gl.FeedbackBuffer(GLsizei(values.size()), GL_4D_COLOR_TEXTURE, values.data());
  const bool lit = r.chance(60), automatic = r.chance(60);
  if (lit) {
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, r.chance(50));
    if (r.chance(50)) gl.Enable(GL_NORMALIZE);
  }
  if (automatic) gl.Enable(GL_AUTO_NORMAL);
  static constexpr int kComponents[9] = {4, 1, 3, 1, 2, 3, 4, 3, 4};
  for (GLenum t = 0; t < 9; t++) {
    const int k = kComponents[t];
    const int least = t >= 7 ? 3 : 1; // triangles of a straight line have no side that one can rely on
    const int u = r.integer(least, r.chance(30) ? 30 : 5), v = r.integer(least, r.chance(30) ? 30 : 5);
    std::vector<GLfloat> points(size_t(u * v * k));
    random_points(r, points);
    if (t == 8)
      for (size_t i = 3; i < points.size(); i += 4) points[i] = 1 + 0.3f * points[i];
    const float u1 = r.real(-1, 0), u2 = r.real(0.5f, 2), v1 = r.real(-1, 0), v2 = r.real(0.5f, 2);
    gl.Map1f(GL_MAP1_COLOR_4 + t, u1, u2, k, u, points.data());
    gl.Map2f(GL_MAP2_COLOR_4 + t, u1, u2, k * v, u, v1, v2, k, v, points.data());
    if (t == 7 || r.chance(40)) {
      gl.Enable(GL_MAP1_COLOR_4 + t);
      gl.Enable(GL_MAP2_COLOR_4 + t);
    }
  }
  gl.RenderMode(GL_FEEDBACK);
  gl.MapGrid1f(8, 0, 0.5f);
  gl.MapGrid2f(8, 0, 0.5f, 4, 0, 0.5f);
  const bool curve = seed & 1; // not both: OSMesa forgets what was current (reference/DEVIATIONS.md)
  if (r.chance(40)) curve ? gl.EvalMesh1(GL_POINT, 0, 8) : gl.EvalMesh2(GL_POINT, 0, 8, -1, 4);
  for (const GLenum mode : {GL_POINTS, GL_TRIANGLES, GL_TRIANGLE_STRIP}) {
    gl.Begin(mode);
    for (int i = 0; i < 12; i++) {
      const float a = r.real(-1.2f, 2), b = r.real(-1.2f, 2);
      if (curve)
        gl.EvalCoord1f(a);
      else
        gl.EvalCoord2f(a, b);
    }
    gl.End();
  }
  const GLint count = gl.RenderMode(GL_RENDER);
  REQUIRE(gl.GetError() == GL_NO_ERROR);
  REQUIRE(count >= 0);
  std::vector<uint32_t> bits(static_cast<size_t>(count));
  std::memcpy(bits.data(), values.data(), bits.size() * sizeof(GLfloat));
  return bits;
}

TEST_CASE("Evaluators feed back OSMesa's bits", "[conformance][evaluators]") {
  size_t total = 0;
  for (unsigned seed = 0; seed < 400; seed++) {
    INFO("seed " << seed);
    const std::vector<uint32_t> ours = evaluated(softgl_library(), seed),
                                theirs = evaluated(osmesa_library(), seed);
    total += ours.size();
    REQUIRE(ours.size() == theirs.size());
    for (size_t i = 0; i < ours.size(); i++) {
      INFO("value " << i);
      REQUIRE(ours[i] == theirs[i]);
    }
  }
  CHECK(total > 50000);
}

} // namespace
} // namespace softgl::test
