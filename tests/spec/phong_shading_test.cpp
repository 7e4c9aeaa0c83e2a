// GL_WIN_phong_shading: state, errors, and what per-pixel lighting must and must not change.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "spec/state_snapshot.h"
#include "support/runner.h"

using namespace softgl::test;

namespace {

GLint integer(const Gl& gl, GLenum token) {
  GLint v = 0;
  gl.GetIntegerv(token, &v);
  return v;
}

GLenum model = GL_PHONG_WIN; // of the scenes below

// A quadrilateral with bent normals under one light that is above its middle.
void quad(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat position[4] = {0.1f, 0.05f, 0.4f, 1}, white[4] = {1, 1, 1, 1};
  gl.ShadeModel(model);
  gl.Enable(GL_LIGHT0);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.Materialfv(GL_FRONT, GL_SPECULAR, white);
  gl.Materialf(GL_FRONT, GL_SHININESS, 80);
  gl.Begin(GL_TRIANGLE_FAN);
  for (int i = 0; i < 4; ++i) {
    const float x = i == 0 || i == 3 ? -0.9f : 0.9f, y = i < 2 ? -0.9f : 0.9f;
    gl.Color3f(0.3f * float(i), 0.5f, 1);
    gl.Normal3f(x, y, 1);
    gl.Vertex2f(x, y);
  }
  gl.End();
}
void lit_quad(Stage& s) {
  s.gl.Enable(GL_LIGHTING);
  quad(s);
}

Picture picture(void (*scene)(Stage&), GLenum shade_model) {
  model = shade_model;
  return draw(softgl_library(), {"phong", scene, false, 64, 64}, 0);
}
const uint8_t* pixel(const Picture& p, int x, int y) { return &p.color[size_t(y * p.width + x) * 4]; }

} // namespace

TEST_CASE("the shade model and the hint of GL_WIN_phong_shading are set, read, saved and listed",
          "[spec][phong]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const std::string extensions = reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS));
  REQUIRE(extensions.find("GL_WIN_phong_shading ") != std::string::npos);
  REQUIRE(integer(gl, GL_PHONG_HINT_WIN) == GL_DONT_CARE);

  gl.PushAttrib(GL_LIGHTING_BIT | GL_HINT_BIT);
  gl.ShadeModel(GL_PHONG_WIN);
  gl.Hint(GL_PHONG_HINT_WIN, GL_NICEST);
  REQUIRE(integer(gl, GL_SHADE_MODEL) == GL_PHONG_WIN);
  REQUIRE(integer(gl, GL_PHONG_HINT_WIN) == GL_NICEST);
  GLfloat f = 0;
  GLdouble d = 0;
  GLboolean b = GL_FALSE;
  gl.GetFloatv(GL_SHADE_MODEL, &f);
  gl.GetDoublev(GL_PHONG_HINT_WIN, &d);
  gl.GetBooleanv(GL_SHADE_MODEL, &b);
  REQUIRE((f == GLfloat(GL_PHONG_WIN) && d == GLdouble(GL_NICEST) && b == GL_TRUE));
  gl.PopAttrib();
  REQUIRE(integer(gl, GL_SHADE_MODEL) == GL_SMOOTH);
  REQUIRE(integer(gl, GL_PHONG_HINT_WIN) == GL_DONT_CARE);

  gl.NewList(1, GL_COMPILE);
  gl.ShadeModel(GL_PHONG_WIN);
  gl.Hint(GL_PHONG_HINT_WIN, GL_FASTEST);
  gl.EndList();
  REQUIRE(integer(gl, GL_SHADE_MODEL) == GL_SMOOTH);
  gl.CallList(1);
  REQUIRE(integer(gl, GL_SHADE_MODEL) == GL_PHONG_WIN);
  REQUIRE(integer(gl, GL_PHONG_HINT_WIN) == GL_FASTEST);
  REQUIRE(gl.GetError() == GL_NO_ERROR);

  gl.ShadeModel(GL_PHONG_HINT_WIN);
  REQUIRE(gl.GetError() == GL_INVALID_ENUM);
  gl.Hint(GL_PHONG_WIN, GL_NICEST);
  REQUIRE(gl.GetError() == GL_INVALID_ENUM);
  gl.Hint(GL_PHONG_HINT_WIN, GL_SMOOTH);
  REQUIRE(gl.GetError() == GL_INVALID_ENUM);
  REQUIRE(integer(gl, GL_SHADE_MODEL) == GL_PHONG_WIN);
  REQUIRE(integer(gl, GL_PHONG_HINT_WIN) == GL_FASTEST);
}

TEST_CASE("Phong shading finds the highlight between the vertices, smooth shading does not",
          "[spec][phong]") {
  const Picture smooth = picture(lit_quad, GL_SMOOTH), phong = picture(lit_quad, GL_PHONG_WIN);
  REQUIRE(phong.errors.empty());
  REQUIRE(pixel(phong, 35, 33)[0] > 250);
  REQUIRE(pixel(smooth, 35, 33)[0] < 150);
}

TEST_CASE("SOFTGL_SHADING=phong gives it to programs that ask for smooth shading, and leaves what they read",
          "[spec][phong]") {
  const auto expected = picture(lit_quad, GL_PHONG_WIN).hash(), flat = picture(lit_quad, GL_FLAT).hash();
  REQUIRE(picture(lit_quad, GL_SMOOTH).hash() != expected);
  setenv("SOFTGL_SHADING", "phong", 1);
  const auto upgraded = picture(lit_quad, GL_SMOOTH).hash(), still_flat = picture(lit_quad, GL_FLAT).hash();
  GLint read = 0;
  {
    CurrentContext context(softgl_library());
    read = integer(softgl_library(), GL_SHADE_MODEL);
  }
  unsetenv("SOFTGL_SHADING");
  REQUIRE(upgraded == expected);
  REQUIRE(still_flat == flat);
  REQUIRE(read == GL_SMOOTH);
}

TEST_CASE("without lighting Phong shading is smooth shading", "[spec][phong]") {
  REQUIRE(picture(quad, GL_PHONG_WIN).hash() == picture(quad, GL_SMOOTH).hash());
  REQUIRE(picture(quad, GL_FLAT).hash() != picture(quad, GL_SMOOTH).hash());
}

TEST_CASE("a normal that is the same everywhere is lit alike per vertex and per pixel", "[spec][phong]") {
  const auto scene = [](Stage& s) {
    const Gl& gl = s.gl;
    const GLfloat light[4] = {1, 2, 3, 0};
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Lightfv(GL_LIGHT0, GL_POSITION, light);
    gl.ShadeModel(model);
    gl.Normal3f(0, 0, 1);
    gl.PointSize(20);
    gl.LineWidth(7);
    gl.Begin(GL_POINTS), gl.Vertex2f(-0.5f, 0.5f), gl.End();
    gl.Begin(GL_LINES), gl.Vertex2f(-1, -1), gl.Vertex2f(1, 1), gl.End();
    gl.Begin(GL_TRIANGLES), gl.Vertex2f(0, -1), gl.Vertex2f(1, -1), gl.Vertex2f(1, 0), gl.End();
  };
  const Difference d = compare(picture(scene, GL_PHONG_WIN), picture(scene, GL_SMOOTH));
  INFO(d.text);
  REQUIRE(d.max_color <= 1); // the color is interpolated once and rounded once in either order
  REQUIRE(d.depth_values == 0);
}

TEST_CASE("degenerate input is lit per pixel with finite colors or draws nothing", "[spec][phong]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl, GL_FLOAT); // 64x64, colors kept as floats
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinite = std::numeric_limits<float>::infinity();
  const GLfloat position[4] = {0, 0, 0, 1}, ambient[4] = {0.5f, 0.5f, 0.5f, 1}, white[4] = {1, 1, 1, 1};
  gl.ShadeModel(GL_PHONG_WIN);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Lightfv(GL_LIGHT0, GL_POSITION,
             position); // at the centre of what is drawn, which is also the viewer's place
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, white);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 10);
  const float bad[] = {0, nan, infinite, 1e30f, 1e-30f, -0.0f};
  for (int pass = 0; pass < 3; ++pass) {
    if (pass == 1) gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 1);
    if (pass == 2) gl.Enable(GL_NORMALIZE), gl.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0);
    for (float x : bad)
      for (GLenum mode : {GL_TRIANGLE_STRIP, GL_LINES, GL_POINTS}) {
        gl.Normal3f(x, 0, 0);
        gl.Begin(mode);
        gl.Vertex4f(0, 0, 0, 1);
        gl.Vertex3f(0.5f, -0.5f, 0);
        gl.Normal3f(0, x, x);
        gl.Vertex4f(-0.5f, 0.5f, 0, x);
        gl.Vertex4f(x, 0.5f, 0, 1);
        gl.Vertex4f(0, 0, 0, 0);
        gl.End();
      }
  }
  std::vector<float> pixels(64 * 64 * 4);
  gl.ReadPixels(0, 0, 64, 64, GL_RGBA, GL_FLOAT, pixels.data());
  REQUIRE(gl.GetError() == GL_NO_ERROR);
  bool drawn = false;
  for (float x : pixels) {
    REQUIRE((x >= 0 && x <= 1)); // which is false of what is not a number
    drawn |= x > 0;
  }
  REQUIRE(drawn);
}

TEST_CASE("a light at the fragment itself leaves its ambient term, attenuated by its constant part",
          "[spec][phong]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl, GL_FLOAT);
  const GLfloat position[4] = {0, 0, 0, 1}, sun[4] = {0, 0, 1, 0},
                model_ambient[4] = {0.125f, 0.125f, 0.125f, 1}, white[4] = {1, 1, 1, 1};
  const GLfloat ambient[4] = {0.5f, 0, 0.25f, 1}, sunlight[4] = {0, 0, 0.25f, 1};
  gl.ShadeModel(GL_PHONG_WIN);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_LIGHT1);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.Lightfv(GL_LIGHT0, GL_AMBIENT, ambient);
  gl.Lightfv(GL_LIGHT1, GL_POSITION, sun);
  gl.Lightfv(GL_LIGHT1, GL_DIFFUSE, sunlight);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, model_ambient);
  gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, white);
  gl.Materialfv(GL_FRONT, GL_SPECULAR, white);
  gl.PointSize(8);
  // A point is lit as if all of it were at its vertex.
  const auto color = [&](float constant, float linear, float quadratic, float exponent) {
    gl.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, constant);
    gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, linear);
    gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, quadratic);
    gl.Materialf(GL_FRONT, GL_SHININESS, exponent);
    gl.Normal3f(0, 0, 1);
    gl.Begin(GL_POINTS), gl.Vertex3f(0, 0, 0), gl.End();
    std::array<float, 3> rgb;
    gl.ReadPixels(32, 32, 1, 1, GL_RGB, GL_FLOAT, rgb.data());
    return rgb;
  };
  for (float exponent : {0.0f, 1.0f, 128.0f}) {
    CAPTURE(exponent);
    CHECK(color(1, 0, 0, exponent) == std::array{0.625f, 0.125f, 0.625f});
    CHECK(color(1, 1, 1, exponent) == std::array{0.625f, 0.125f, 0.625f});
    CHECK(color(2, 0, 1, exponent) == std::array{0.375f, 0.125f, 0.5f});
    // 1/0 of a color is white, of black it is black.
    CHECK(color(0, 1, 0, exponent) == std::array{1.0f, 0.125f, 1.0f});
    CHECK(color(0, 0, 1, exponent) == std::array{1.0f, 0.125f, 1.0f});
    CHECK(color(0, 0, 0, exponent) == std::array{1.0f, 0.125f, 1.0f});
    gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 60); // nothing is in the cone's direction
    CHECK(color(0, 1, 0, exponent) == std::array{0.125f, 0.125f, 0.375f});
    gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 180);
    gl.LightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL, GL_REFLECTION_VECTOR_SOFTGL);
    CHECK(color(0, 1, 0, exponent) == std::array{1.0f, 0.125f, 1.0f});
    gl.LightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL, GL_HALF_VECTOR_SOFTGL);
    const GLfloat negative[4] = {-0.5f, 0.25f, 0, 1};
    gl.Lightfv(GL_LIGHT0, GL_AMBIENT, negative);
    CHECK(color(0, 1, 0, exponent) == std::array{0.0f, 1.0f, 0.375f});
    gl.Lightfv(GL_LIGHT0, GL_AMBIENT, ambient);
  }
}

TEST_CASE("a vertex without a normal is lit by its neighbours' normals under GL_NORMALIZE", "[spec][phong]") {
  const auto one_zero = [](Stage& s) {
    const Gl& gl = s.gl;
    const GLfloat white[4] = {1, 1, 1, 1}, black[4] = {0, 0, 0, 1};
    gl.ShadeModel(model);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_NORMALIZE);
    gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
    gl.Materialfv(GL_FRONT, GL_DIFFUSE, white);
    gl.Begin(GL_TRIANGLES);
    gl.Normal3f(0, 0, 0), gl.Vertex2f(-1, -1);
    gl.Normal3f(0, 0, 7), gl.Vertex2f(3, -1);
    gl.Normal3f(0, 0, 7), gl.Vertex2f(-1, 3);
    gl.End();
  };
  const Picture p = picture(one_zero, GL_PHONG_WIN);
  REQUIRE(int(pixel(p, 0, 0)[0]) == 255);
  REQUIRE(int(pixel(p, 32, 32)[0]) == 255);
}

TEST_CASE("normals of no length between opposite ones leave the ambient light", "[spec][phong]") {
  const auto opposite = [](Stage& s) {
    const Gl& gl = s.gl;
    // So short that their squares are zero, and pointing nowhere between the corners of the upper edge.
    const float tiny = 1e-30f;
    gl.ShadeModel(model);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    const GLfloat white[4] = {1, 1, 1, 1}, position[4] = {1, 2, 3, 0};
    gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
    gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, white);
    gl.Materialfv(GL_FRONT, GL_SPECULAR, white);
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
      const float x = i & 1 ? tiny : -tiny;
      gl.Normal3f(x, x, x), gl.Vertex2f(i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f);
    }
    gl.End();
  };
  const Picture p = picture(opposite, GL_PHONG_WIN);
  for (int i = 0; i < 64; ++i) REQUIRE(int(pixel(p, i, 32)[0]) == 51); // 0.2
}

TEST_CASE("a fragment at the eye has the highlight of a viewer in no direction", "[spec][phong]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl, GL_FLOAT);
  const GLfloat white[4] = {1, 1, 1, 1}, black[4] = {0, 0, 0, 1}, position[4] = {0, 3, 4, 0};
  gl.ShadeModel(GL_PHONG_WIN);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
  gl.Materialfv(GL_FRONT, GL_DIFFUSE, black);
  gl.Materialfv(GL_FRONT, GL_SPECULAR, white);
  gl.Materialf(GL_FRONT, GL_SHININESS, 1);
  gl.PointSize(8);
  gl.Normal3f(0, 0, 1);
  gl.Begin(GL_POINTS), gl.Vertex3f(0, 0, 0), gl.End();
  float red = 0;
  gl.ReadPixels(32, 32, 1, 1, GL_RED, GL_FLOAT, &red);
  REQUIRE(red == Approx(0.8f).margin(1e-5)); // the half vector is that to the light: n.h = 4/5
}

TEST_CASE("primitives with a vertex that is nowhere draw nothing, and their neighbours as ever",
          "[spec][phong]") {
  static GLfloat bad[4];
  static GLenum mode;
  const auto scene = [](Stage& s) {
    const Gl& gl = s.gl;
    gl.ShadeModel(model);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_COLOR_MATERIAL);
    gl.LineWidth(3), gl.PointSize(9);
    gl.Begin(mode);
    const int corners = mode == GL_TRIANGLES ? 3 : mode == GL_LINES ? 2 : 1;
    for (int primitive = 0; primitive < 3; ++primitive)
      for (int i = 0; i < corners; ++i) {
        const float x = i == 1 ? 0.9f : -0.9f, y = (i == 2 ? 0.2f : -0.2f) + 0.6f * float(primitive - 1);
        gl.Color3f(x, y, 1);
        if (primitive == 1 && i == corners - 1 && bad[0] != 7)
          gl.Vertex4fv(bad);
        else if (primitive != 1 || bad[0] != 7)
          gl.Vertex2f(x, y);
      }
    gl.End();
  };
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinite = std::numeric_limits<float>::infinity();
  const GLfloat vertices[][4] = {{nan, 0, 0, 1},       {0, nan, 0, 1},       {0, 0, nan, 1},
                                 {0, 0, 0, nan},       {nan, nan, nan, nan}, {infinite, 0, 0, 1},
                                 {0, -infinite, 0, 1}, {0, 0, 0, infinite},  {0, 0, 0, 0}};
  for (GLenum m : {GL_TRIANGLES, GL_LINES, GL_POINTS})
    for (GLenum shading : {GL_PHONG_WIN, GL_SMOOTH}) {
      mode = m;
      bad[0] = 7; // without the primitive in the middle
      const Picture expected = picture(scene, shading);
      for (const auto& v : vertices) {
        std::copy(v, v + 4, bad);
        const Difference d = compare(picture(scene, shading), expected);
        INFO(m << " " << shading << ": " << v[0] << " " << v[1] << " " << v[2] << " " << v[3] << ": "
               << d.text);
        CHECK_FALSE(d.any());
      }
    }
}

TEST_CASE("a normal of zero leaves emission and ambient light", "[spec][phong]") {
  const auto zero = [](Stage& s) {
    const Gl& gl = s.gl;
    const GLfloat white[4] = {1, 1, 1, 1};
    gl.ShadeModel(model);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, white);
    gl.Normal3f(0, 0, 0);
    gl.Rectf(-1, -1, 1, 1);
  };
  REQUIRE(int(pixel(picture(zero, GL_PHONG_WIN), 32, 32)[0]) == 51);
}
