// GL_WIN_phong_shading: state, errors, and what per-pixel lighting must and must not change.
#include <catch2/catch.hpp>

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

TEST_CASE("the shade model and the hint of GL_WIN_phong_shading are set, read, saved and listed", "[spec][phong]") {
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

TEST_CASE("Phong shading finds the highlight between the vertices, smooth shading does not", "[spec][phong]") {
  const Picture smooth = picture(lit_quad, GL_SMOOTH), phong = picture(lit_quad, GL_PHONG_WIN);
  REQUIRE(phong.errors.empty());
  REQUIRE(pixel(phong, 35, 33)[0] > 250);
  REQUIRE(pixel(smooth, 35, 33)[0] < 150);
}

TEST_CASE("SOFTGL_SHADING=phong gives it to programs that ask for smooth shading, and leaves what they read", "[spec][phong]") {
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
  REQUIRE(d.max_color <= 1); // the colour is interpolated once and rounded once in either order
  REQUIRE(d.depth_values == 0);
}

TEST_CASE("degenerate input is lit per pixel with finite colours or draws nothing", "[spec][phong]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl, GL_FLOAT); // 64x64, colours kept as floats
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  const GLfloat position[4] = {0, 0, 0, 1}, ambient[4] = {0.5f, 0.5f, 0.5f, 1}, white[4] = {1, 1, 1, 1};
  gl.ShadeModel(GL_PHONG_WIN);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position); // at the centre of what is drawn, which is also the viewer's place
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
