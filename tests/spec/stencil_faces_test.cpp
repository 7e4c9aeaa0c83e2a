// Stencil tests of two faces: glStencilFuncSeparate (GL 2.0, 4.1.4; GL_ATI_separate_stencil) and
// GL_EXT_stencil_two_side.
#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

#include "spec/state_snapshot.h"

namespace softgl::test {
namespace {

/// How many pixels have each stencil value.
std::vector<int> count_stencils(const Gl& gl) {
  std::vector<GLubyte> p(64 * 64);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, 64, 64, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, p.data());
  std::vector<int> count(256);
  for (const GLubyte v : p) ++count[v];
  return count;
}

void triangle(const Gl& gl, bool back) {
  gl.Begin(GL_TRIANGLES);
  gl.Vertex2f(-0.8f, -0.8f);
  gl.Vertex2f(back ? 0 : 0.8f, back ? 0.8f : -0.8f);
  gl.Vertex2f(back ? 0.8f : 0, back ? -0.8f : 0.8f);
  gl.End();
}

/// Front-facing polygons count up, others down.
void count_faces(const Gl& gl) {
  gl.ClearStencil(10);
  gl.Clear(GL_STENCIL_BUFFER_BIT);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
  gl.StencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
}

} // namespace

TEST_CASE("each face of a polygon has its stencil operations", "[spec][stencil]") {
  const Gl& gl = softgl_library();
  for (const GLenum smooth : {GLenum(0), GLenum(GL_POLYGON_SMOOTH)})
    for (const bool listed : {false, true}) {
      CurrentContext context(gl);
      if (smooth) gl.Enable(smooth);
      if (listed) gl.NewList(1, GL_COMPILE);
      count_faces(gl);
      for (int i = 0; i < 5; ++i) triangle(gl, i % 2 == 1);
      if (listed) gl.EndList(), gl.CallList(1);
      const std::vector<int> count = count_stencils(gl);
      CHECK(count[11] > 1000);
      CHECK(count[10] + count[11] == 64 * 64);
    }
}

TEST_CASE("a polygon that is drawn as lines or points is still a polygon to the stencil test",
          "[spec][stencil]") {
  const Gl& gl = softgl_library();
  for (const GLenum mode : {GL_LINE, GL_POINT})
    for (const bool smooth : {false, true}) {
      CurrentContext context(gl);
      count_faces(gl);
      gl.PolygonMode(GL_FRONT_AND_BACK, mode);
      gl.PointSize(5);
      gl.LineWidth(3);
      if (smooth) gl.Enable(GL_LINE_SMOOTH), gl.Enable(GL_POINT_SMOOTH);
      triangle(gl, true);
      std::vector<int> count = count_stencils(gl);
      CHECK(count[11] == 0);
      CHECK(count[9] > 20);
      gl.Clear(GL_STENCIL_BUFFER_BIT);
      triangle(gl, false);
      count = count_stencils(gl);
      CHECK(count[9] == 0);
      CHECK(count[11] > 20);
    }
}

TEST_CASE("points, lines and rectangles of pixels have the stencil test of the front", "[spec][stencil]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  count_faces(gl);
  gl.FrontFace(GL_CW);
  gl.PointSize(5);
  gl.Begin(GL_POINTS);
  gl.Vertex2f(0.5f, 0.5f);
  gl.End();
  gl.Begin(GL_LINES);
  gl.Vertex2f(-0.5f, -0.5f);
  gl.Vertex2f(0.5f, -0.5f);
  gl.End();
  const GLubyte pixel[4] = {255, 255, 255, 255};
  gl.RasterPos2f(0, 0);
  gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  const std::vector<int> count = count_stencils(gl);
  CHECK(count[9] == 0);
  CHECK(count[11] == 25 + 32 + 1);
}

TEST_CASE("the back of GL_EXT_stencil_two_side is another one, and counts while that is enabled",
          "[spec][stencil]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  count_faces(gl);
  gl.ActiveStencilFaceEXT(GL_BACK);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_ZERO);
  gl.ActiveStencilFaceEXT(GL_FRONT);
  triangle(gl, true);
  CHECK(count_stencils(gl)[9] > 1000);
  gl.Enable(GL_STENCIL_TEST_TWO_SIDE_EXT);
  triangle(gl, true);
  CHECK(count_stencils(gl)[0] > 1000);
  gl.Clear(GL_STENCIL_BUFFER_BIT);
  triangle(gl, false);
  CHECK(count_stencils(gl)[11] > 1000);
}

TEST_CASE("the raster position may lie in front of the near plane where depths are clamped",
          "[spec][depth]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLboolean valid = GL_TRUE;
  gl.RasterPos3f(0, 0, -3);
  gl.GetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
  CHECK(!valid);
  gl.Enable(GL_DEPTH_CLAMP);
  gl.DepthRange(0.25, 0.75);
  gl.RasterPos3f(0, 0, -3);
  gl.GetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
  CHECK(valid);
  GLfloat position[4] = {};
  gl.GetFloatv(GL_CURRENT_RASTER_POSITION, position);
  CHECK(position[2] == 0.25f);
}

} // namespace softgl::test
