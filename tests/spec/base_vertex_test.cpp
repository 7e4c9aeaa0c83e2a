// GL_ARB_draw_elements_base_vertex: a number that is added to all indices of a draw.
#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "spec/state_snapshot.h"
#include "support/random.h"

namespace softgl::test {
namespace {

std::string draw_scene(const Gl& gl, unsigned seed) {
  CurrentContext context(gl);
  Random r(seed);
  std::vector<GLfloat> positions(60), colors(90);
  for (GLfloat& v : positions) v = r.real(-1, 1);
  for (GLfloat& v : colors) v = r.real(0, 1);
  gl.VertexPointer(2, GL_FLOAT, 0, positions.data());
  gl.ColorPointer(3, GL_FLOAT, 0, colors.data());
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  const bool in_buffer = r.chance(50), in_list = r.chance(30);
  const int base = r.integer(-5, 15);
  const GLenum type = r.pick<GLenum>({GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT});
  std::vector<GLubyte> bytes(12);
  std::vector<GLushort> shorts(12);
  std::vector<GLuint> ints(12);
  for (size_t i = 0; i < 12; ++i) {
    const int index = r.integer(std::max(0, -base), std::min(29, 29 - base));
    bytes[i] = GLubyte(index), shorts[i] = GLushort(index), ints[i] = GLuint(index);
  }
  const bool small = type == GL_UNSIGNED_BYTE, middle = type == GL_UNSIGNED_SHORT;
  const void* indices = small    ? static_cast<void*>(bytes.data())
                        : middle ? static_cast<void*>(shorts.data())
                                 : ints.data();
  const size_t size = small ? 1 : middle ? 2 : 4;
  if (in_buffer) {
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 1);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(12 * size), indices, GL_STATIC_DRAW);
    indices = nullptr;
  }
  if (in_list) gl.NewList(1, GL_COMPILE);
  const GLenum mode = r.pick<GLenum>({GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_LINES, GL_POINTS});
  switch (r.integer(0, 2)) {
  case 0: gl.DrawElementsBaseVertex(mode, 12, type, indices, base); break;
  case 1: gl.DrawRangeElementsBaseVertex(mode, 0, 29, 12, type, indices, base); break;
  default: {
    const GLsizei counts[2] = {6, 6};
    const void* const parts[2] = {indices, static_cast<const GLubyte*>(indices) + (indices ? 6 * size : 0)};
    const GLint bases[2] = {base, base};
    gl.MultiDrawElementsBaseVertex(mode, counts, type, parts, 2, bases);
  }
  }
  if (in_list) gl.EndList(), gl.CallList(1);
  std::string picture(32 * 32 * 4, 0);
  gl.ReadPixels(0, 0, 32, 32, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
  picture += std::to_string(gl.GetError());
  return picture;
}

TEST_CASE("a base vertex is added to the indices as OSMesa adds it", "[spec][arrays]") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    INFO("seed " << seed);
    CHECK((draw_scene(softgl_library(), seed) == draw_scene(osmesa_library(), seed)));
  }
}

TEST_CASE("a draw with a base vertex has the errors of the draw without", "[spec][errors]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLubyte index[3] = {0, 1, 2};
  const auto error_of = [&](auto call) {
    call();
    return gl.GetError();
  };
  CHECK(error_of([&] { gl.DrawElementsBaseVertex(10, 3, GL_UNSIGNED_BYTE, index, 1); }) == GL_INVALID_ENUM);
  CHECK(error_of([&] { gl.DrawElementsBaseVertex(GL_POINTS, 3, GL_FLOAT, index, 1); }) == GL_INVALID_ENUM);
  CHECK(error_of([&] { gl.DrawElementsBaseVertex(GL_POINTS, -1, GL_UNSIGNED_BYTE, index, 1); }) ==
        GL_INVALID_VALUE);
  CHECK(error_of([&] { gl.DrawRangeElementsBaseVertex(GL_POINTS, 2, 1, 3, GL_UNSIGNED_BYTE, index, 1); }) ==
        GL_INVALID_VALUE);
  CHECK(error_of([&] {
          gl.Begin(GL_POINTS);
          gl.DrawElementsBaseVertex(GL_POINTS, 3, GL_UNSIGNED_BYTE, index, 1);
          gl.End();
        }) == GL_INVALID_OPERATION);
}

} // namespace
} // namespace softgl::test
