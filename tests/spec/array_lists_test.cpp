// GL 1.5, 2.8 and 5.4: array draws in display lists.
#include <catch2/catch.hpp>

#include <functional>
#include <vector>

#include "spec/state_snapshot.h"

namespace softgl::test {
namespace {

constexpr GLfloat kVertices[3][2] = {{-1, -1}, {3, -1}, {-1, 3}};
constexpr GLfloat kColors[3][4] = {{0, 1, 0, 1}, {0, 1, 0, 1}, {0, 1, 0, 1}};
constexpr GLfloat kNormals[3][3] = {{1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
constexpr GLubyte kIndices[3] = {0, 1, 2};

void enable_arrays(const Gl& gl) {
  gl.VertexPointer(2, GL_FLOAT, 0, kVertices);
  gl.ColorPointer(4, GL_FLOAT, 0, kColors);
  gl.NormalPointer(GL_FLOAT, 0, kNormals);
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY}) gl.EnableClientState(array);
}
const std::vector<std::function<void(const Gl&)>> kDraws = {
    [](const Gl& gl) { gl.DrawArrays(GL_TRIANGLES, 0, 3); },
    [](const Gl& gl) { gl.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, kIndices); },
    [](const Gl& gl) { gl.DrawRangeElements(GL_TRIANGLES, 0, 2, 3, GL_UNSIGNED_BYTE, kIndices); }};

std::vector<GLubyte> pixels(const Gl& gl) {
  std::vector<GLubyte> p(64 * 64 * 4);
  gl.ReadPixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, p.data());
  return p;
}
std::vector<GLfloat> current(const Gl& gl) {
  std::vector<GLfloat> v(7);
  gl.GetFloatv(GL_CURRENT_COLOR, v.data());
  gl.GetFloatv(GL_CURRENT_NORMAL, v.data() + 4);
  return v;
}

} // namespace

TEST_CASE("a list of an array draw draws nothing between Begin and End", "[spec][lists][arrays]") {
  const Gl& gl = softgl_library();
  for (const auto& draw : kDraws)
    for (const GLenum mode : {GL_POINTS, GL_TRIANGLES}) {
      CurrentContext context(gl);
      enable_arrays(gl);
      gl.NewList(1, GL_COMPILE);
      draw(gl);
      gl.EndList();
      gl.Begin(mode);
      gl.CallList(1);
      gl.End();
      CHECK(gl.GetError() == GL_INVALID_OPERATION);
      CHECK((pixels(gl) == std::vector<GLubyte>(64 * 64 * 4)));
      gl.CallList(1);
      CHECK(gl.GetError() == GL_NO_ERROR);
      CHECK(pixels(gl)[1] == 255);
    }
}

// 2.8 leaves them undefined; OSMesa keeps them, too, where the list is only compiled.
TEST_CASE("the current values stay behind a list of array draws", "[spec][lists][arrays]") {
  const Gl& gl = softgl_library();
  for (const auto& draw : kDraws)
    for (const bool in_list : {false, true}) {
      CurrentContext context(gl);
      enable_arrays(gl);
      const auto set = [&] { gl.Color4f(0.1f, 0.2f, 0.3f, 0.4f), gl.Normal3f(0.5f, 0.6f, 0.7f); };
      gl.NewList(1, GL_COMPILE);
      if (in_list) set();
      draw(gl);
      draw(gl);
      gl.EndList();
      if (!in_list) set();
      const std::vector<GLfloat> expected{0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, 0.7f};
      gl.CallList(1);
      CHECK(current(gl) == expected);
    }
}

TEST_CASE("attributes and primitives between array draws of a list are the list's", "[spec][lists][arrays]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  enable_arrays(gl);
  gl.NewList(1, GL_COMPILE);
  kDraws[0](gl);
  gl.Color4f(1, 0, 0, 1);
  kDraws[1](gl);
  gl.Begin(GL_POINTS); // takes the red one
  gl.Vertex2f(0, 0);
  gl.End();
  kDraws[2](gl);
  gl.Normal3f(0, 0, 0.25f);
  gl.EndList();
  gl.CallList(1);
  CHECK(current(gl) == std::vector<GLfloat>{1, 0, 0, 1, 0, 0, 0.25f});
  CHECK(pixels(gl)[1] == 255);
  gl.DisableClientState(GL_COLOR_ARRAY);
  gl.NewList(2, GL_COMPILE);
  gl.Color4f(0, 0, 1, 1);
  kDraws[0](gl); // all blue
  gl.Begin(GL_POINTS);
  gl.Vertex2f(0, 0);
  gl.End();
  gl.EndList();
  gl.CallList(2);
  const std::vector<GLubyte> p = pixels(gl);
  for (size_t i = 0; i < p.size(); i += 4) REQUIRE((p[i] == 0 && p[i + 1] == 0 && p[i + 2] == 255));
  CHECK(gl.GetError() == GL_NO_ERROR);
}

// OSMesa draws what lies in front of the array (reference/DEVIATIONS.md).
TEST_CASE("arrays have no element before the first", "[spec][errors][arrays]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  enable_arrays(gl);
  const GLint first = -1;
  const GLsizei count = 3;
  gl.DrawArrays(GL_TRIANGLES, first, count);
  CHECK(gl.GetError() == GL_INVALID_VALUE);
  gl.MultiDrawArrays(GL_TRIANGLES, &first, &count, 1);
  CHECK(gl.GetError() == GL_INVALID_VALUE);
  CHECK((pixels(gl) == std::vector<GLubyte>(64 * 64 * 4)));
}

} // namespace softgl::test
