// shaders/glsl against softgl: the same random lighting states, drawn by OSMesa with the shaders.
#include <catch2/catch.hpp>

#include <array>

#include "support/environment.h"
#include "support/runner.h"
#include "support/shader_twins.h"

namespace softgl::test {
namespace {

constexpr int kStatesPerScene = 10;

// Draws scenes of a family both ways: the same pixels are covered, no channel differs by more than 1/255,
// and 99.9 % of them are equal.
void compare_scenes(const char* family, int first, int count) {
  fix_environment();
  const Gl shaders = shader_library(Twins::PhongAndGouraud);
  const Scene& scene = *find_scene(family);
  size_t channels = 0, unequal = 0;
  for (int seed = first; seed < first + count; seed++) {
    const Picture ours = draw(softgl_library(), scene, uint64_t(seed)),
                  theirs = draw(shaders, scene, uint64_t(seed));
    const Difference d = compare(ours, theirs);
    INFO(family << " " << seed << ": " << d.text);
    CHECK_FALSE(d.size);
    CHECK_FALSE(d.errors);
    CHECK(d.depth_values == 0); // coverage
    CHECK(d.max_color <= 1);
    channels += ours.color.size(), unequal += d.color_bytes;
  }
  INFO(unequal << " of " << channels << " channels differ");
  CHECK(unequal * 1000 <= channels);
}

void compare_with_twin(const char* family, int first, int states) {
  compare_scenes(family, first / kStatesPerScene, states / kStatesPerScene);
}

// A triangle over most of the window, so brightly lit from the eye that red would be 3 and green 0.75 if they
// were not clamped.
void bright_triangle(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat diffuse[4] = {1, 0.25f, 0, 1}, black[4] = {0, 0, 0, 1}, light[4] = {3, 3, 3, 1};
  gl.ShadeModel(GL_PHONG_WIN);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, light);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
  gl.Begin(GL_TRIANGLES);
  gl.Normal3f(0, 0, 1);
  gl.TexCoord2f(0.5f, 0.5f);
  gl.Vertex3f(-1, -1, -0.5f), gl.Vertex3f(1, -1, -0.5f), gl.Vertex3f(0, 1, -0.5f);
  gl.End();
}
// Its highlight stays apart from the texture, and 0.75 and 0.5 make 1 in sum.
void set_highlight(const Gl& gl) {
  const GLfloat specular[4] = {0, 0.5f, 0, 1};
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
}
void textured_triangle(Stage& s) {
  const uint8_t texel[4] = {51, 51, 51, 255}; // 0.2
  s.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  s.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  s.gl.Enable(GL_TEXTURE_2D);
  bright_triangle(s);
}
void foggy_triangle(Stage& s) {
  s.gl.Enable(GL_FOG);
  s.gl.Fogi(GL_FOG_MODE, GL_LINEAR);
  s.gl.Fogf(GL_FOG_END, 0.625f); // what is 0.5 away is seen with 1/5 of its color
  s.gl.Fogf(GL_FOG_START, 0);
  bright_triangle(s);
}

void textured_triangle_with_highlight(Stage& s) { set_highlight(s.gl), textured_triangle(s); }
void foggy_triangle_with_highlight(Stage& s) { set_highlight(s.gl), foggy_triangle(s); }

// A triangle whose corners have materials of their own: the left one is red, the right one has a highlight,
// the upper one shines by itself.
void triangle_of_materials(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat red[4] = {1, 0, 0, 1}, black[4] = {0, 0, 0, 1}, blue[4] = {0, 0, 1, 1},
                green[4] = {0, 1, 0, 1};
  gl.ShadeModel(GL_PHONG_WIN);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  gl.Begin(GL_TRIANGLES);
  gl.Normal3f(0, 0, 1);
  gl.Materialfv(GL_FRONT, GL_DIFFUSE, red);
  gl.Vertex2f(-1, -1);
  gl.Materialfv(GL_FRONT, GL_DIFFUSE, black);
  gl.Materialfv(GL_FRONT, GL_SPECULAR, blue);
  gl.Materialf(GL_FRONT, GL_SHININESS, 5);
  gl.Vertex2f(1, -1);
  gl.Materialfv(GL_FRONT, GL_SPECULAR, black);
  gl.Materialfv(GL_FRONT, GL_EMISSION, green);
  gl.Vertex2f(0, 1);
  gl.End();
}

// softgl's color at a pixel of a 64x64 picture, which is the twin's to 1/255.
std::array<int, 3> color_beside_twin(void (*scene)(Stage&), int x, int y) {
  fix_environment();
  const Scene drawn{"phong", scene, false, 64, 64};
  const Picture ours = draw(softgl_library(), drawn, 0),
                theirs = draw(shader_library(Twins::Phong), drawn, 0);
  const Difference d = compare(ours, theirs);
  INFO(d.text);
  CHECK((d.depth_values == 0 && d.max_color <= 1));
  const uint8_t* pixel = &ours.color[size_t(y * 64 + x) * 4];
  return {pixel[0], pixel[1], pixel[2]};
}

} // namespace

TEST_CASE("lit fragments are clamped before a texture", "[conformance][glsl]") {
  CHECK(color_beside_twin(textured_triangle, 32, 32) == std::array{51, 38, 0}); // 0.2, 0.15
}
TEST_CASE("lit fragments are clamped before the fog", "[conformance][glsl]") {
  CHECK(color_beside_twin(foggy_triangle, 32, 32) == std::array{51, 38, 0}); // 0.2, 0.15
}
TEST_CASE("the highlight is added behind the texture and before the fog, and the sum clamped",
          "[conformance][glsl]") {
  CHECK(color_beside_twin(textured_triangle_with_highlight, 32, 32) ==
        std::array{51, 166, 0});                                                            // 0.2, 0.15 + 0.5
  CHECK(color_beside_twin(foggy_triangle_with_highlight, 32, 32) == std::array{51, 51, 0}); // 0.2, 0.2
}
TEST_CASE("materials of vertices are interpolated", "[conformance][glsl]") {
  // The weights of the corners are 0.238, 0.254 and 0.508.
  CHECK(color_beside_twin(triangle_of_materials, 32, 32) == std::array{61, 129, 65});
}

// Several cases, that they can run at the same time.
TEST_CASE("Gouraud shading is that of its GLSL twin", "[conformance][glsl][slow]") {
  compare_with_twin("gouraud_twin", 0, 200);
}
TEST_CASE("Phong shading is that of its GLSL twin: states 0 to 249", "[conformance][glsl][slow]") {
  compare_with_twin("phong_twin", 0, 250);
}
TEST_CASE("Phong shading is that of its GLSL twin: states 250 to 499", "[conformance][glsl][slow]") {
  compare_with_twin("phong_twin", 250, 250);
}
TEST_CASE("Phong shading is that of its GLSL twin: states 500 to 749", "[conformance][glsl][slow]") {
  compare_with_twin("phong_twin", 500, 250);
}
TEST_CASE("Phong shading is that of its GLSL twin: states 750 to 999", "[conformance][glsl][slow]") {
  compare_with_twin("phong_twin", 750, 250);
}
// Fog, a texture, materials of vertices, lines, points, flat shading, several primitives over each other.
TEST_CASE("Phong-lit scenes are those of the GLSL twins: 0 to 39", "[conformance][glsl][slow]") {
  compare_scenes("phong", 0, 40);
}
TEST_CASE("Phong-lit scenes are those of the GLSL twins: 40 to 79", "[conformance][glsl][slow]") {
  compare_scenes("phong", 40, 40);
}
TEST_CASE("Gouraud-lit scenes of the extension are those of the GLSL twin", "[conformance][glsl][slow]") {
  compare_scenes("illumination", 0, 40);
}

} // namespace softgl::test
