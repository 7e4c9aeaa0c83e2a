// Where OSMesa's lists and vertices leave the specification (reference/DEVIATIONS.md).
#include <catch2/catch.hpp>

#include <array>

#include "support/runner.h"

namespace softgl::test {
namespace {

GLenum mode; // read by the scenes
bool in_list, execute, behind_another;

void polygon_colors(Stage& s, bool late) {
  static constexpr GLfloat kVertices[8][2] = {{-0.9f, -0.9f}, {0.9f, -0.7f}, {-0.8f, 0.1f}, {0.7f, 0.3f},
                                              {-0.6f, 0.8f},  {0.5f, 0.9f},  {0.1f, 0.2f},  {-0.3f, -0.4f}};
  s.gl.Begin(mode);
  for (int i = 0; i < 8; i++) {
    if (i >= (late ? 3 : 0)) s.gl.Color3f(0.1f * float(i), 0.5f, 1);
    s.gl.Vertex2fv(kVertices[i]);
  }
  s.gl.End();
}

void draw_late(Stage& s) {
  if (in_list)
    s.gl.NewList(1, GL_COMPILE);
  else
    s.gl.Color3f(1, 0, 0);
  if (behind_another) {
    s.gl.Begin(GL_POINTS);
    s.gl.Vertex2f(0.5f, -0.95f);
    s.gl.End();
  }
  polygon_colors(s, true);
  if (!in_list) return;
  s.gl.EndList();
  s.gl.Color3f(1, 0, 0);
  s.gl.CallList(1);
}

void draw_then_flat(Stage& s) {
  if (execute) s.gl.NewList(1, GL_COMPILE_AND_EXECUTE);
  polygon_colors(s, false);
  s.gl.ShadeModel(GL_FLAT);
  if (execute) s.gl.EndList();
}

void draw_three_after_four(Stage& s) {
  s.gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3; i++) {
    s.gl.Color4f(1, 0, 0, 0.25f);
    s.gl.Color3f(0, 1, 0);
    s.gl.Vertex2f(i == 1 ? 3.0f : -1.0f, i == 2 ? 3.0f : -1.0f);
  }
  s.gl.End();
}

// The forms and lengths grow and shrink from one primitive to the next, with no other call between them.
void draw_three_after_double_and_four(Stage& s) {
  const Gl& gl = s.gl;
  const auto triangle = [&] {
    gl.Vertex2f(-1, -1);
    gl.Vertex2f(3, -1);
    gl.Vertex2f(-1, 3);
  };
  gl.Begin(GL_TRIANGLES);
  gl.Color3d(1, 0, 0);
  triangle();
  gl.Color3f(1, 0, 0);
  triangle();
  gl.Color4f(1, 0, 0, 0.25f);
  gl.End();
  gl.Begin(GL_TRIANGLE_STRIP);
  gl.Color3f(0, 1, 0);
  triangle();
  gl.End();
}

void draw_empty_first(Stage& s) {
  static constexpr GLfloat kVertices[3][2] = {{-1, -1}, {3, -1}, {-1, 3}};
  static constexpr GLint kFirst[2] = {0, 0};
  static constexpr GLsizei kCount[2] = {0, 3};
  s.gl.EnableClientState(GL_VERTEX_ARRAY);
  s.gl.VertexPointer(2, GL_FLOAT, 0, kVertices);
  s.gl.MultiDrawArrays(GL_TRIANGLES, kFirst, kCount, 2);
  s.gl.Finish();
}

void draw_material_behind_new_list(Stage& s) {
  const Gl& gl = s.gl;
  gl.Enable(GL_LIGHTING);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, std::array<GLfloat, 4>{1, 1, 1, 1}.data());
  gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT);
  gl.Enable(GL_COLOR_MATERIAL);
  gl.Color4f(0, 1, 0, 1);
  gl.NewList(1, GL_COMPILE);
  gl.Begin(GL_TRIANGLES);
  gl.Normal3f(0, 0, 1);
  gl.Vertex2f(-1, -1);
  gl.Vertex2f(3, -1);
  gl.Vertex2f(-1, 3);
  gl.End();
  gl.EndList();
  gl.CallList(1);
}

} // namespace

TEST_CASE("a color that is set before glNewList is the material", "[conformance][deviation]") {
  const Picture picture =
      draw(softgl_library(), {"material_behind_new_list", draw_material_behind_new_list}, 0);
  CHECK(picture.color[0] == 0);
  CHECK(picture.color[1] == 255);
}

TEST_CASE("a color of three components has alpha 1", "[conformance][deviation]") {
  for (const Scene& scene : {Scene{"three_after_four", draw_three_after_four},
                             Scene{"three_after_double", draw_three_after_double_and_four}}) {
    INFO(scene.name);
    const Picture picture = draw(softgl_library(), scene, 0);
    CHECK(picture.color[0] == 0);
    CHECK(picture.color[1] == 255);
    CHECK(picture.color[3] == 255);
  }
}

TEST_CASE("a first count of 0 does not stop glMultiDrawArrays", "[conformance][deviation]") {
  CHECK(draw(softgl_library(), {"empty_first", draw_empty_first}, 0).color[0] == 255);
}

TEST_CASE("an attribute may come late in a list", "[conformance][deviation]") {
  const Scene scene{"late", draw_late};
  for (bool behind : {false, true})
    for (mode = GL_POINTS; mode <= GL_POLYGON; mode++) {
      behind_another = behind;
      in_list = false;
      const Picture expected = draw(softgl_library(), scene, 0);
      in_list = true;
      const Difference d = compare(draw(softgl_library(), scene, 0), expected);
      INFO("mode " << mode << (behind ? " behind a point: " : ": ") << d.text);
      CHECK_FALSE(d.any());
    }
}

TEST_CASE("state after a primitive does not change it while a list is compiled and executed",
          "[conformance][deviation]") {
  const Scene scene{"then_flat", draw_then_flat};
  for (mode = GL_POINTS; mode <= GL_POLYGON; mode++) {
    execute = false;
    const Picture expected = draw(softgl_library(), scene, 0);
    execute = true;
    const Difference d = compare(draw(softgl_library(), scene, 0), expected);
    INFO("mode " << mode << ": " << d.text);
    CHECK_FALSE(d.any());
  }
}

} // namespace softgl::test
