// GL_SOFTGL_phong_illumination: state, errors, the reflection vector and the terms, per vertex and per pixel.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "spec/state_snapshot.h"
#include "support/random.h"

using namespace softgl::test;

namespace {

GLint integer(const Gl& gl, GLenum token) {
  GLint v = 0;
  gl.GetIntegerv(token, &v);
  return v;
}

using Vector = std::array<double, 3>;
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector unit(const Vector& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

// The color of a point at the origin of eye coordinates.
std::array<float, 4> lit_point(const Gl& gl, const Float3& normal) {
  gl.PointSize(8);
  gl.Begin(GL_POINTS);
  gl.Normal3fv(normal.data());
  gl.Vertex3f(0, 0, 0);
  gl.End();
  std::array<float, 4> color;
  gl.ReadPixels(32, 32, 1, 1, GL_RGBA, GL_FLOAT, color.data());
  return color;
}

// One directional light of specular color only.
void highlight_only(const Gl& gl, const Float3& toward_light, float exponent) {
  const GLfloat black[4] = {0, 0, 0, 1}, white[4] = {1, 1, 1, 1},
                position[4] = {toward_light[0], toward_light[1], toward_light[2], 0};
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, black);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, exponent);
}

} // namespace

TEST_CASE("the light model's form and terms are set, read, saved and listed", "[spec][phong]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const std::string extensions = reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS));
  REQUIRE(extensions.find("GL_SOFTGL_phong_illumination ") != std::string::npos);
  const auto state = [&](GLint vector, GLint terms) {
    REQUIRE(gl.GetError() == GL_NO_ERROR);
    REQUIRE(integer(gl, GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL) == vector);
    REQUIRE(integer(gl, GL_LIGHT_MODEL_TERMS_SOFTGL) == terms);
  };
  state(GL_HALF_VECTOR_SOFTGL, GL_ALL_TERM_BITS_SOFTGL);
  gl.PushAttrib(GL_LIGHTING_BIT);
  gl.LightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL, GL_REFLECTION_VECTOR_SOFTGL);
  gl.LightModelf(GL_LIGHT_MODEL_TERMS_SOFTGL, 5);
  state(GL_REFLECTION_VECTOR_SOFTGL, 5);
  GLfloat f = 0;
  GLdouble d = 0;
  gl.GetFloatv(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL, &f);
  gl.GetDoublev(GL_LIGHT_MODEL_TERMS_SOFTGL, &d);
  REQUIRE((f == float(GL_REFLECTION_VECTOR_SOFTGL) && d == 5));
  gl.PopAttrib();
  state(GL_HALF_VECTOR_SOFTGL, GL_ALL_TERM_BITS_SOFTGL);

  gl.NewList(1, GL_COMPILE);
  const GLint reflection = GL_REFLECTION_VECTOR_SOFTGL;
  const GLfloat none = 0;
  gl.LightModeliv(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL, &reflection);
  gl.LightModelfv(GL_LIGHT_MODEL_TERMS_SOFTGL, &none);
  gl.EndList();
  state(GL_HALF_VECTOR_SOFTGL, GL_ALL_TERM_BITS_SOFTGL);
  gl.CallList(1);
  state(GL_REFLECTION_VECTOR_SOFTGL, 0);

  const auto refuses = [&](GLenum error) {
    REQUIRE(gl.GetError() == error);
    state(GL_REFLECTION_VECTOR_SOFTGL, 0);
  };
  for (GLint bad : {0, int(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL), int(GL_SINGLE_COLOR)}) {
    gl.LightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL, bad);
    refuses(GL_INVALID_ENUM);
  }
  for (float bad : {-1.0f, 16.0f, 0.5f, 1e30f, std::numeric_limits<float>::quiet_NaN(),
                    std::numeric_limits<float>::infinity()}) {
    gl.LightModelf(GL_LIGHT_MODEL_TERMS_SOFTGL, bad);
    refuses(GL_INVALID_VALUE);
  }
  gl.LightModeli(GL_REFLECTION_VECTOR_SOFTGL, 0);
  refuses(GL_INVALID_ENUM);
}

TEST_CASE("highlights of the reflection vector are (v.r)^a, for light and viewer before the surface",
          "[spec][phong]") {
  const Gl& gl = softgl_library();
  Random random(3);
  int lit = 0, unlit = 0;
  for (int i = 0; i < 400; ++i) {
    CurrentContext context(gl, GL_FLOAT);
    const Float3 normal = random.direction(), light = random.direction();
    const float exponent = random.chance(20) ? 0.0f : random.real(0, 128);
    gl.ShadeModel(i & 1 ? GL_PHONG_WIN : GL_SMOOTH);
    gl.LightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL, GL_REFLECTION_VECTOR_SOFTGL);
    highlight_only(gl, light, exponent);
    const Vector n = unit({normal[0], normal[1], normal[2]}), s = unit({light[0], light[1], light[2]});
    const double vr = 2 * dot(n, s) * n[2] - s[2];
    const double expected = dot(n, s) > 0 && vr > 0 ? std::pow(vr, double(exponent)) : 0;
    const auto color = lit_point(gl, normal);
    INFO(i << ": exponent " << exponent << ", n.s " << dot(n, s) << ", v.r " << vr);
    // 128 times the rounding of v.r (1e-7) and the error of the power (1.2e-5).
    REQUIRE(std::fabs(double(color[0]) - expected) < 3e-5);
    ++(expected > 0 ? lit : unlit);
  }
  REQUIRE((lit > 50 && unlit > 50));
}

TEST_CASE("single terms add up to the whole, per vertex and per pixel, in both forms", "[spec][phong]") {
  const Gl& gl = softgl_library();
  for (GLenum shade_model : {GL_FLAT, GL_SMOOTH, GL_PHONG_WIN})
    for (GLint vector : {GL_HALF_VECTOR_SOFTGL, GL_REFLECTION_VECTOR_SOFTGL})
      for (bool varies : {false, true}) {
        CurrentContext context(gl, GL_FLOAT);
        const GLfloat emission[4] = {0.02f, 0.03f, 0.04f, 1}, ambient[4] = {0.1f, 0.2f, 0.3f, 1},
                      diffuse[4] = {0.2f, 0.1f, 0.3f, 0.625f};
        const GLfloat specular[4] = {0.2f, 0.1f, 0.05f, 1}, position[4] = {0.3f, 0.2f, 2, 1};
        gl.Enable(GL_LIGHTING);
        gl.Enable(GL_LIGHT0);
        gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
        gl.Lightfv(GL_LIGHT0, GL_AMBIENT, ambient);
        gl.Materialfv(GL_FRONT, GL_EMISSION, emission);
        gl.Materialfv(GL_FRONT, GL_AMBIENT, ambient);
        gl.Materialfv(GL_FRONT, GL_DIFFUSE, diffuse);
        gl.Materialfv(GL_FRONT, GL_SPECULAR, specular);
        gl.Materialf(GL_FRONT, GL_SHININESS, 6);
        gl.ShadeModel(shade_model);
        gl.LightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL, vector);
        if (varies) gl.ColorMaterial(GL_FRONT, GL_EMISSION), gl.Enable(GL_COLOR_MATERIAL);
        const auto color = [&](GLint terms) {
          gl.LightModeli(GL_LIGHT_MODEL_TERMS_SOFTGL, terms);
          gl.Color4fv(emission);
          gl.Begin(GL_TRIANGLES);
          for (const Float2 v : {Float2{-1, -1}, Float2{1, -1}, Float2{0, 1}}) {
            if (varies) gl.Color4fv(emission);
            gl.Normal3f(0.2f * v[0], 0.1f, 1);
            gl.Vertex2fv(v.data());
          }
          gl.End();
          std::array<float, 4> c;
          gl.ReadPixels(32, 32, 1, 1, GL_RGBA, GL_FLOAT, c.data());
          // A float's unit is 1.2e-7 of it; interpolation and sums round it up to eight times, 1e-6.
          REQUIRE(c[3] == Approx(0.625f).epsilon(1e-6)); // the diffuse material's, whatever the terms
          return c;
        };
        const auto all = color(GL_ALL_TERM_BITS_SOFTGL), none = color(0);
        std::array<float, 4> sum{};
        for (GLint term : {1, 2, 4, 8}) {
          const auto c = color(term);
          for (size_t i = 0; i < 3; ++i) {
            REQUIRE(c[i] > 0);
            sum[i] += c[i];
          }
        }
        const auto emitted = color(GL_EMISSION_TERM_BIT_SOFTGL),
                   surroundings = color(GL_AMBIENT_TERM_BIT_SOFTGL);
        for (size_t i = 0; i < 3; ++i) {
          INFO("shade model " << shade_model << ", vector " << vector << ", component " << i);
          REQUIRE(none[i] == 0);
          REQUIRE(emitted[i] == Approx(emission[i]).epsilon(1e-6));
          REQUIRE(surroundings[i] == Approx(ambient[i] * (0.2f + ambient[i])).epsilon(1e-6));
          // Four such terms, each a part of the whole, against a sum rounded in another order.
          REQUIRE(sum[i] == Approx(all[i]).epsilon(1e-5));
        }
      }
}

TEST_CASE("degenerate input gives no negative color and none that is not a number", "[spec][phong]") {
  const Gl& gl = softgl_library();
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinite = std::numeric_limits<float>::infinity();
  const float values[] = {0, -0.0f, 1, -1, 1e-30f, 1e30f, nan, infinite, -infinite};
  Random random(5);
  const auto any = [&] { return values[random.integer(0, 8)]; };
  for (int round = 0; round < 60; ++round) {
    CurrentContext context(gl, GL_FLOAT);
    gl.ShadeModel(round & 1 ? GL_PHONG_WIN : GL_SMOOTH);
    gl.LightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL,
                   round & 2 ? GL_HALF_VECTOR_SOFTGL : GL_REFLECTION_VECTOR_SOFTGL);
    gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, random.chance(50));
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, random.chance(50));
    gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                   random.chance(50) ? GL_SINGLE_COLOR : GL_SEPARATE_SPECULAR_COLOR);
    highlight_only(gl, {0, 0, 1}, float(random.integer(0, 128)));
    for (GLenum light : {GL_LIGHT0, GL_LIGHT1}) {
      gl.Enable(light);
      for (GLenum parameter : {GL_POSITION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_SPOT_DIRECTION}) {
        const Float4 v{any(), any(), any(), any()};
        gl.Lightfv(light, parameter, v.data());
      }
      if (random.chance(50)) gl.Lightf(light, GL_SPOT_CUTOFF, 30);
      if (random.chance(50)) gl.Lightf(light, GL_CONSTANT_ATTENUATION, 0);
    }
    const Float4 material{any(), any(), any(), any()};
    gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, material.data());
    for (int i = 0; i < 20; ++i) {
      gl.Begin(GLenum(random.pick({GL_POINTS, GL_LINES, GL_TRIANGLES})));
      for (int k = 0; k < 6; ++k) {
        const Float3 normal{any(), any(), any()};
        gl.Normal3fv(normal.data());
        gl.Vertex3f(random.real(-1, 1), random.real(-1, 1), random.chance(50) ? 0 : random.real(-1, 1));
      }
      gl.End();
    }
    std::vector<float> pixels(64 * 64 * 4);
    gl.ReadPixels(0, 0, 64, 64, GL_RGBA, GL_FLOAT, pixels.data());
    REQUIRE(gl.GetError() == GL_NO_ERROR);
    // Primary and secondary color are clamped one by one: their sum may reach 2.
    REQUIRE(std::all_of(pixels.begin(), pixels.end(), [](float x) { return x >= 0 && x <= 2; }));
  }
}
