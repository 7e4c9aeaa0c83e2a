// Lighting that has no answer: light and viewer at the vertex, normals of no length, not a number, infinite,
// or so long that the highlight is infinite. softgl draws OSMesa's bytes here, too, and they are finite.
#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

#include "support/environment.h"
#include "support/gl.h"

using namespace softgl::test;

namespace {

std::vector<float> draw_all(const Gl& gl) {
  constexpr int kSize = 16;
  void* context = gl.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, 0, nullptr);
  REQUIRE(context);
  std::vector<float> picture(kSize * kSize * 4), all;
  REQUIRE(gl.OSMesaMakeCurrent(context, picture.data(), GL_FLOAT, kSize, kSize));
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  for (int i = 0; i < 512; i++) {
    const auto bit = [&](int n) { return ((i >> n) & 1) != 0; };
    const GLfloat specular[4] = {bit(1) ? 0.5f : 0, 0, 0.2f, 1},
                  position[4] = {0, 0, bit(2) ? 0.0f : 1.0f, bit(2) ? 1.0f : 0.0f};
    gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, bit(0) ? 20.0f : bit(6) ? 128.0f : 0.0f);
    gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
    gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, bit(3));
    (bit(4) ? gl.Enable : gl.Disable)(GL_NORMALIZE);
    gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, bit(5));
    gl.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION,
              bit(8) ? 0.0f : 1.0f); // 0: infinitely bright where it is, without the linear one everywhere
    gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, bit(7) ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    static const GLfloat kNormals[6][3] = {{0, 0, 1},        {0, 0, 0},     {NAN, 0, 1},
                                           {INFINITY, 0, 1}, {0, 0, 1e30f}, {0, 0, 7}};
    for (const auto& normal : kNormals) {
      gl.Clear(GL_COLOR_BUFFER_BIT);
      gl.Begin(GL_TRIANGLES);
      gl.Normal3fv(normal);
      gl.Vertex3f(0, 0, 0); // where the light and the eye are
      gl.Vertex3f(3, 0, 0);
      gl.Vertex3f(0, 3, 0);
      gl.End();
      gl.Finish();
      all.insert(all.end(), &picture[(9 * kSize + 9) * 4], &picture[(9 * kSize + 9) * 4] + 4);
    }
  }
  gl.OSMesaMakeCurrent(nullptr, nullptr, GL_FLOAT, 0, 0);
  gl.OSMesaDestroyContext(context);
  return all;
}

} // namespace

TEST_CASE("lighting without an answer has OSMesa's floats", "[conformance][lighting][slow]") {
  fix_environment();
  const std::vector<float> ours = draw_all(softgl_library()), theirs = draw_all(osmesa_library());
  size_t different = 0, finite = 0;
  for (size_t i = 0; i < ours.size(); i++)
    different += ours[i] != theirs[i], finite += std::isfinite(ours[i]);
  CHECK(different == 0);
  CHECK(finite == ours.size());
}
