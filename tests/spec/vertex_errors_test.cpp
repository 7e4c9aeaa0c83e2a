// The errors that GL 1.5 and its extensions name for commands of vertices, arrays, buffers, matrices,
// evaluators, selection and lists. Each is raised by a call that is wrong in nothing else, and changes
// nothing.
#include <catch2/catch.hpp>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

unsigned char bytes[4096];
GLfloat floats[1024];
GLdouble doubles[1024];
GLuint names[4];
GLint numbers[16];
const GLsizei counts[2] = {1, 1}, negative_counts[2] = {1, -1};
const GLint firsts[2] = {0, 0}, negative_firsts[2] = {0, -1}, bases[2] = {0, 0};
const void* const index_arrays[2] = {bytes, bytes};

} // namespace

REFUSAL_TEST_CASE("texture coordinates have eight units", "[spec][errors]") { // 2.5, 2.7
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, MultiTexCoord1f(GL_TEXTURE0 + 8, 1)),
      BAD(INVALID_ENUM, MultiTexCoord1d(GL_TEXTURE0 - 1, 1)),
      BAD(INVALID_ENUM, MultiTexCoord1i(0, 1)),
      BAD(INVALID_ENUM, MultiTexCoord1s(GL_TEXTURE, 1)),
      BAD(INVALID_ENUM, MultiTexCoord1fv(GL_TEXTURE0 + 8, floats)),
      BAD(INVALID_ENUM, MultiTexCoord2f(GL_TEXTURE0 + 31, 1, 2)),
      BAD(INVALID_ENUM, MultiTexCoord2d(GL_TEXTURE0 + 8, 1, 2)),
      BAD(INVALID_ENUM, MultiTexCoord2i(GL_TEXTURE0 + 8, 1, 2)),
      BAD(INVALID_ENUM, MultiTexCoord2s(GL_TEXTURE0 + 8, 1, 2)),
      BAD(INVALID_ENUM, MultiTexCoord2fv(1, floats)),
      BAD(INVALID_ENUM, MultiTexCoord2dv(1, doubles)),
      BAD(INVALID_ENUM, MultiTexCoord3f(GL_TEXTURE0 + 8, 1, 2, 3)),
      BAD(INVALID_ENUM, MultiTexCoord3d(GL_TEXTURE0 + 8, 1, 2, 3)),
      BAD(INVALID_ENUM, MultiTexCoord3i(GL_TEXTURE0 + 8, 1, 2, 3)),
      BAD(INVALID_ENUM, MultiTexCoord3iv(GL_TEXTURE0 + 8, numbers)),
      BAD(INVALID_ENUM, MultiTexCoord4f(GL_TEXTURE0 + 8, 1, 2, 3, 4)),
      BAD(INVALID_ENUM, MultiTexCoord4d(GL_TEXTURE0 + 8, 1, 2, 3, 4)),
      BAD(INVALID_ENUM, MultiTexCoord4s(GL_TEXTURE0 + 8, 1, 2, 3, 4)),
      BAD(INVALID_ENUM, MultiTexCoord4dv(GL_TEXTURE0 + 8, doubles)),
      BAD(INVALID_ENUM, ClientActiveTexture(GL_TEXTURE0 - 1)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("array draws refuse what is wrong in one argument",
                  "[spec][errors]") { // 2.8 and its extensions
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_VALUE, ArrayElement(-1)),
      BAD(INVALID_ENUM, DrawElements(GL_POINTS, 1, GL_FLOAT, bytes)),
      BAD(INVALID_ENUM, DrawRangeElements(GL_POLYGON + 1, 0, 1, 1, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, MultiDrawElements(GL_POLYGON + 1, counts, GL_UNSIGNED_BYTE, index_arrays, 2)),
      BAD(INVALID_ENUM, MultiDrawElements(GL_POINTS, counts, GL_SHORT, index_arrays, 2)),
      BAD(INVALID_VALUE, MultiDrawElements(GL_POINTS, negative_counts, GL_UNSIGNED_BYTE, index_arrays, 2)),
      BAD(INVALID_VALUE, MultiDrawElements(GL_POINTS, counts, GL_UNSIGNED_BYTE, index_arrays, -1)),
      BAD(INVALID_VALUE, MultiDrawArrays(GL_POINTS, negative_firsts, counts, 2)),
      BAD(INVALID_ENUM, DrawElementsBaseVertex(GL_POLYGON + 1, 1, GL_UNSIGNED_BYTE, bytes, 0)),
      BAD(INVALID_VALUE, DrawElementsBaseVertex(GL_POINTS, -1, GL_UNSIGNED_BYTE, bytes, 0)),
      BAD(INVALID_ENUM, DrawElementsBaseVertex(GL_POINTS, 1, GL_INT, bytes, 0)),
      BAD(INVALID_ENUM, DrawRangeElementsBaseVertex(GL_POLYGON + 1, 0, 1, 1, GL_UNSIGNED_BYTE, bytes, 0)),
      BAD(INVALID_VALUE, DrawRangeElementsBaseVertex(GL_POINTS, 2, 1, 1, GL_UNSIGNED_BYTE, bytes, 0)),
      BAD(INVALID_VALUE, DrawRangeElementsBaseVertex(GL_POINTS, 0, 1, -1, GL_UNSIGNED_BYTE, bytes, 0)),
      BAD(INVALID_ENUM, DrawRangeElementsBaseVertex(GL_POINTS, 0, 1, 1, GL_BYTE, bytes, 0)),
      BAD(INVALID_ENUM,
          MultiDrawElementsBaseVertex(GL_POLYGON + 1, counts, GL_UNSIGNED_BYTE, index_arrays, 2, bases)),
      BAD(INVALID_ENUM, MultiDrawElementsBaseVertex(GL_POINTS, counts, GL_BITMAP, index_arrays, 2, bases)),
      BAD(INVALID_VALUE,
          MultiDrawElementsBaseVertex(GL_POINTS, counts, GL_UNSIGNED_BYTE, index_arrays, -1, bases)),
      BAD(INVALID_VALUE,
          MultiDrawElementsBaseVertex(GL_POINTS, negative_counts, GL_UNSIGNED_BYTE, index_arrays, 2, bases)),
      BAD(INVALID_OPERATION, PrimitiveRestartNV()), // not between Begin and End
      BAD(INVALID_ENUM, ColorPointer(3, GL_2_BYTES, 0, bytes)),
      BAD(INVALID_OPERATION, ColorPointer(GL_BGRA, GL_FLOAT, 0, bytes)),
      BAD(INVALID_OPERATION, SecondaryColorPointer(GL_BGRA, GL_SHORT, 0, bytes)),
      BAD(INVALID_VALUE, SecondaryColorPointer(2, GL_FLOAT, 0, bytes)),
      BAD(INVALID_ENUM, VertexPointer(3, GL_BYTE, 0, bytes)),
      BAD(INVALID_ENUM, InterleavedArrays(GL_T4F_C4F_N3F_V4F + 1, 0, bytes)),
      BAD(INVALID_ENUM, EnableClientState(GL_ARRAY_BUFFER)),
      BAD(INVALID_ENUM, DisableClientState(0)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("vertex array objects refuse names that nobody made",
                  "[spec][errors]") { // GL_ARB_vertex_array_object
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_OPERATION, BindVertexArray(7)),
      BAD(INVALID_VALUE, GenVertexArrays(-1, names)),
      BAD(INVALID_VALUE, DeleteVertexArrays(-1, names)),
  };
  expect_refused(gl, calls);
  gl.GenVertexArrays(1, names);
  gl.BindVertexArray(names[0]);
  static const BadCall in_object[] = {
      // an address of memory
      BAD(INVALID_OPERATION, VertexPointer(3, GL_FLOAT, 0, bytes)),
      BAD(INVALID_OPERATION, NormalPointer(GL_FLOAT, 0, bytes)),
      BAD(INVALID_OPERATION, ColorPointer(4, GL_FLOAT, 0, bytes)),
      BAD(INVALID_OPERATION, SecondaryColorPointer(3, GL_FLOAT, 0, bytes)),
      BAD(INVALID_OPERATION, FogCoordPointer(GL_FLOAT, 0, bytes)),
      BAD(INVALID_OPERATION, IndexPointer(GL_FLOAT, 0, bytes)),
      BAD(INVALID_OPERATION, EdgeFlagPointer(0, bytes)),
      BAD(INVALID_OPERATION, TexCoordPointer(2, GL_FLOAT, 0, bytes)),
  };
  expect_refused(gl, in_object);
  gl.DeleteVertexArrays(1, names);
  static const BadCall deleted[] = {BAD(INVALID_OPERATION, BindVertexArray(names[0]))};
  expect_refused(gl, deleted);
}

REFUSAL_TEST_CASE("buffer objects refuse what is wrong in one argument",
                  "[spec][errors]") { // 2.9 and its extensions
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.BindBuffer(GL_ARRAY_BUFFER, 1);
  gl.BufferData(GL_ARRAY_BUFFER, 64, bytes, GL_STATIC_DRAW);
  gl.BindBuffer(GL_COPY_READ_BUFFER, 2);
  gl.BufferData(GL_COPY_READ_BUFFER, 64, bytes, GL_STATIC_DRAW);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, BindBuffer(0, 1)),
      BAD(INVALID_ENUM, BufferSubData(GL_TEXTURE_2D, 0, 4, bytes)),
      BAD(INVALID_VALUE, BufferSubData(GL_ARRAY_BUFFER, 61, 4, bytes)),
      BAD(INVALID_ENUM, GetBufferSubData(GL_TEXTURE_2D, 0, 4, bytes)),
      BAD(INVALID_VALUE, GetBufferSubData(GL_ARRAY_BUFFER, -1, 4, bytes)),
      BAD(INVALID_VALUE, GetBufferSubData(GL_ARRAY_BUFFER, 0, -1, bytes)),
      BAD(INVALID_VALUE, GetBufferSubData(GL_ARRAY_BUFFER, 0, 65, bytes)),
      BAD(INVALID_ENUM, MapBuffer(GL_ARRAY_BUFFER, GL_STATIC_DRAW)),
      BAD(INVALID_ENUM, UnmapBuffer(GL_TEXTURE_2D)),
      BAD(INVALID_OPERATION, UnmapBuffer(GL_ARRAY_BUFFER)),
      BAD(INVALID_ENUM, GetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, numbers)),
      BAD(INVALID_ENUM,
          GetBufferPointerv(GL_TEXTURE_2D, GL_BUFFER_MAP_POINTER, reinterpret_cast<void**>(bytes))),
      BAD(INVALID_OPERATION,
          GetBufferPointerv(GL_PIXEL_PACK_BUFFER, GL_BUFFER_MAP_POINTER, reinterpret_cast<void**>(bytes))),
      // GL_ARB_map_buffer_range
      BAD(INVALID_VALUE, MapBufferRange(GL_ARRAY_BUFFER, -1, 4, GL_MAP_READ_BIT)),
      BAD(INVALID_VALUE, MapBufferRange(GL_ARRAY_BUFFER, 0, -1, GL_MAP_READ_BIT)),
      BAD(INVALID_VALUE, MapBufferRange(GL_ARRAY_BUFFER, 61, 4, GL_MAP_READ_BIT)),
      BAD(INVALID_VALUE, MapBufferRange(GL_ARRAY_BUFFER, 0, 4, 0x8000 | GL_MAP_READ_BIT)),
      BAD(INVALID_OPERATION, MapBufferRange(GL_ARRAY_BUFFER, 0, 4, 0)),
      BAD(INVALID_OPERATION,
          MapBufferRange(GL_ARRAY_BUFFER, 0, 4, GL_MAP_READ_BIT | GL_MAP_INVALIDATE_RANGE_BIT)),
      BAD(INVALID_OPERATION,
          MapBufferRange(GL_ARRAY_BUFFER, 0, 4, GL_MAP_READ_BIT | GL_MAP_INVALIDATE_BUFFER_BIT)),
      BAD(INVALID_OPERATION,
          MapBufferRange(GL_ARRAY_BUFFER, 0, 4, GL_MAP_READ_BIT | GL_MAP_UNSYNCHRONIZED_BIT)),
      BAD(INVALID_OPERATION,
          MapBufferRange(GL_ARRAY_BUFFER, 0, 4, GL_MAP_READ_BIT | GL_MAP_FLUSH_EXPLICIT_BIT)),
      // GL_ARB_copy_buffer
      BAD(INVALID_VALUE, CopyBufferSubData(GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, -1, 0, 4)),
      BAD(INVALID_VALUE, CopyBufferSubData(GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, 0, -1, 4)),
      BAD(INVALID_VALUE, CopyBufferSubData(GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, 0, 0, -1)),
      BAD(INVALID_VALUE, CopyBufferSubData(GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, 61, 0, 4)),
      BAD(INVALID_VALUE, CopyBufferSubData(GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, 0, 61, 4)),
      BAD(INVALID_VALUE, CopyBufferSubData(GL_ARRAY_BUFFER, GL_ARRAY_BUFFER, 0, 2, 4)), // they overlap
      BAD(INVALID_ENUM, CopyBufferSubData(GL_ARRAY_BUFFER, GL_FLOAT, 0, 0, 4)),
      BAD(INVALID_OPERATION, CopyBufferSubData(GL_ARRAY_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, 4)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("a mapped buffer is nobody else's",
                  "[spec][errors]") { // 2.9, GL_ARB_map_buffer_range, GL_ARB_copy_buffer
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.BindBuffer(GL_ARRAY_BUFFER, 1);
  gl.BufferData(GL_ARRAY_BUFFER, 64, bytes, GL_STATIC_DRAW);
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.BindBuffer(GL_COPY_READ_BUFFER, 2);
  gl.BufferData(GL_COPY_READ_BUFFER, 64, bytes, GL_STATIC_DRAW);
  for (GLenum target : {GL_ELEMENT_ARRAY_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER})
    gl.BindBuffer(target, 0);
  REQUIRE(gl.MapBufferRange(GL_ARRAY_BUFFER, 16, 32, GL_MAP_WRITE_BIT) != nullptr);
  static const BadCall calls[] = {
      BAD(INVALID_OPERATION, MapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY)),
      BAD(INVALID_OPERATION, MapBufferRange(GL_ARRAY_BUFFER, 0, 4, GL_MAP_READ_BIT)),
      BAD(INVALID_OPERATION, BufferSubData(GL_ARRAY_BUFFER, 0, 4, bytes)),
      BAD(INVALID_OPERATION, GetBufferSubData(GL_ARRAY_BUFFER, 0, 4, bytes)),
      BAD(INVALID_OPERATION, CopyBufferSubData(GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, 0, 0, 4)),
      BAD(INVALID_OPERATION, CopyBufferSubData(GL_COPY_READ_BUFFER, GL_ARRAY_BUFFER, 0, 0, 4)),
      BAD(INVALID_OPERATION, FlushMappedBufferRange(GL_ARRAY_BUFFER, 0, 4)), // not mapped for that
      BAD(INVALID_OPERATION, DrawArrays(GL_POINTS, 0, 1)),
      BAD(INVALID_OPERATION, DrawElements(GL_POINTS, 1, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION, DrawRangeElements(GL_POINTS, 0, 1, 1, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION, MultiDrawArrays(GL_POINTS, firsts, counts, 1)),
      BAD(INVALID_OPERATION, MultiDrawElements(GL_POINTS, counts, GL_UNSIGNED_BYTE, index_arrays, 1)),
      BAD(INVALID_OPERATION, ArrayElement(0)),
  };
  expect_refused(gl, calls);
  CHECK(gl.UnmapBuffer(GL_ARRAY_BUFFER) == GL_TRUE);
  REQUIRE(gl.MapBufferRange(GL_ARRAY_BUFFER, 16, 32, GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT) !=
          nullptr);
  static const BadCall flushes[] = {
      BAD(INVALID_VALUE, FlushMappedBufferRange(GL_ARRAY_BUFFER, -1, 4)),
      BAD(INVALID_VALUE, FlushMappedBufferRange(GL_ARRAY_BUFFER, 0, -4)),
      BAD(INVALID_VALUE, FlushMappedBufferRange(GL_ARRAY_BUFFER, 30, 4)),
      BAD(INVALID_OPERATION, FlushMappedBufferRange(GL_PIXEL_PACK_BUFFER, 0, 4)),
  };
  expect_refused(gl, flushes);
}

REFUSAL_TEST_CASE("stacks of matrices, attributes and names end", "[spec][errors]") { // 2.11.2, 5.2, 6.1.14
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const auto fill = [&](GLenum most, void (*push)(const Gl& gl), int there) {
    GLint limit = 0;
    gl.GetIntegerv(most, &limit);
    for (int i = there; i < limit; ++i) push(gl);
    CHECK(gl.GetError() == GL_NO_ERROR);
  };
  static const BadCall overflow[] = {BAD(STACK_OVERFLOW, PushMatrix())};
  for (const auto& [mode, most] : {std::pair{GL_MODELVIEW, GL_MAX_MODELVIEW_STACK_DEPTH},
                                   {GL_PROJECTION, GL_MAX_PROJECTION_STACK_DEPTH},
                                   {GL_TEXTURE, GL_MAX_TEXTURE_STACK_DEPTH}}) {
    gl.MatrixMode(GLenum(mode));
    fill(
        GLenum(most), [](const Gl& g) { g.PushMatrix(); }, 1);
    expect_refused(gl, overflow);
  }
  fill(
      GL_MAX_ATTRIB_STACK_DEPTH, [](const Gl& g) { g.PushAttrib(GL_FOG_BIT); }, 0);
  fill(
      GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, [](const Gl& g) { g.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT); },
      0);
  static const BadCall attributes[] = {BAD(STACK_OVERFLOW, PushAttrib(GL_FOG_BIT)),
                                       BAD(STACK_OVERFLOW, PushClientAttrib(0))};
  expect_refused(gl, attributes);
  gl.SelectBuffer(4, names);
  gl.RenderMode(GL_SELECT);
  static const BadCall empty[] = {BAD(INVALID_OPERATION, LoadName(1)), BAD(STACK_UNDERFLOW, PopName())};
  expect_refused(gl, empty);
  fill(
      GL_MAX_NAME_STACK_DEPTH, [](const Gl& g) { g.PushName(3); }, 0);
  static const BadCall full[] = {BAD(STACK_OVERFLOW, PushName(1))};
  expect_refused(gl, full);
}

REFUSAL_TEST_CASE("selection and feedback refuse what is wrong in one argument",
                  "[spec][errors]") { // 5.2, 5.3
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, RenderMode(GL_SELECT + 1)),
      BAD(INVALID_OPERATION, RenderMode(GL_SELECT)),
      BAD(INVALID_OPERATION, RenderMode(GL_FEEDBACK)),
      BAD(INVALID_VALUE, SelectBuffer(-1, names)),
      BAD(INVALID_VALUE, FeedbackBuffer(-1, GL_2D, floats)),
      BAD(INVALID_ENUM, FeedbackBuffer(16, GL_FLOAT, floats)),
  };
  expect_refused(gl, calls);
  gl.SelectBuffer(4, names);
  gl.FeedbackBuffer(16, GL_2D, floats);
  gl.RenderMode(GL_SELECT);
  static const BadCall selecting[] = {BAD(INVALID_OPERATION, SelectBuffer(4, names))};
  expect_refused(gl, selecting);
  gl.RenderMode(GL_FEEDBACK);
  static const BadCall feeding[] = {BAD(INVALID_OPERATION, FeedbackBuffer(16, GL_2D, floats))};
  expect_refused(gl, feeding);
}

REFUSAL_TEST_CASE("evaluators refuse what is wrong in one argument", "[spec][errors]") { // 5.1, 6.1.3
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, Map1f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, floats)),
      BAD(INVALID_VALUE, Map1f(GL_MAP1_VERTEX_3, 1, 1, 3, 2, floats)),
      BAD(INVALID_VALUE, Map1f(GL_MAP1_VERTEX_3, 0, 1, 2, 2, floats)),
      BAD(INVALID_VALUE, Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 0, floats)),
      BAD(INVALID_VALUE, Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 31, floats)),
      BAD(INVALID_ENUM, Map1d(GL_FLOAT, 0, 1, 3, 2, doubles)),
      BAD(INVALID_VALUE, Map1d(GL_MAP1_COLOR_4, 2, 2, 4, 2, doubles)),
      BAD(INVALID_VALUE, Map1d(GL_MAP1_COLOR_4, 0, 1, 3, 2, doubles)),
      BAD(INVALID_VALUE, Map1d(GL_MAP1_COLOR_4, 0, 1, 4, -1, doubles)),
      BAD(INVALID_ENUM, Map2f(GL_MAP1_NORMAL, 0, 1, 3, 2, 0, 1, 6, 2, floats)),
      BAD(INVALID_VALUE, Map2f(GL_MAP2_NORMAL, 1, 1, 3, 2, 0, 1, 6, 2, floats)),
      BAD(INVALID_VALUE, Map2f(GL_MAP2_NORMAL, 0, 1, 3, 2, 4, 4, 6, 2, floats)),
      BAD(INVALID_VALUE, Map2f(GL_MAP2_NORMAL, 0, 1, 2, 2, 0, 1, 6, 2, floats)),
      BAD(INVALID_VALUE, Map2f(GL_MAP2_NORMAL, 0, 1, 3, 2, 0, 1, 2, 2, floats)),
      BAD(INVALID_VALUE, Map2f(GL_MAP2_NORMAL, 0, 1, 3, 0, 0, 1, 6, 2, floats)),
      BAD(INVALID_VALUE, Map2f(GL_MAP2_NORMAL, 0, 1, 3, 2, 0, 1, 6, 31, floats)),
      BAD(INVALID_ENUM, Map2d(0, 0, 1, 3, 2, 0, 1, 6, 2, doubles)),
      BAD(INVALID_VALUE, Map2d(GL_MAP2_INDEX, 0, 1, 0, 2, 0, 1, 6, 2, doubles)),
      BAD(INVALID_VALUE, Map2d(GL_MAP2_INDEX, 0, 1, 1, 31, 0, 1, 2, 2, doubles)),
      BAD(INVALID_VALUE, MapGrid1f(0, 0, 1)),
      BAD(INVALID_VALUE, MapGrid1d(-1, 0, 1)),
      BAD(INVALID_VALUE, MapGrid2f(0, 0, 1, 1, 0, 1)),
      BAD(INVALID_VALUE, MapGrid2d(1, 0, 1, 0, 0, 1)),
      BAD(INVALID_ENUM, EvalMesh1(GL_FILL, 0, 1)),
      BAD(INVALID_ENUM, EvalMesh2(GL_POINTS, 0, 1, 0, 1)),
      BAD(INVALID_ENUM, GetMapfv(GL_FLOAT, GL_ORDER, floats)),
      BAD(INVALID_ENUM, GetMapdv(GL_MAP1_VERTEX_3, GL_MAP1_GRID_DOMAIN, doubles)),
      BAD(INVALID_ENUM, GetMapiv(0, GL_COEFF, numbers)),
  };
  expect_refused(gl, calls);
  gl.ActiveTexture(GL_TEXTURE1);
  static const BadCall in_unit_1[] = {
      BAD(INVALID_OPERATION, Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, floats)),
      BAD(INVALID_OPERATION, Map1d(GL_MAP1_VERTEX_3, 0, 1, 3, 2, doubles)),
      BAD(INVALID_OPERATION, Map2f(GL_MAP2_NORMAL, 0, 1, 3, 2, 0, 1, 6, 2, floats)),
      BAD(INVALID_OPERATION, Map2d(GL_MAP2_NORMAL, 0, 1, 3, 2, 0, 1, 6, 2, doubles)),
  };
  expect_refused(gl, in_unit_1);
}

REFUSAL_TEST_CASE("lists refuse to begin in a list, and what is wrong comes when they are played",
                  "[spec][errors]") { // 5.4
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.NewList(1, GL_COMPILE);
  gl.Viewport(0, 0, -1, 1);
  gl.CallList(0);
  gl.CallLists(-1, GL_BYTE, bytes);
  gl.CallLists(1, GL_DOUBLE, bytes);
  gl.DepthFunc(GL_FLOAT);
  gl.NewList(2, GL_COMPILE);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.EndList();
  CHECK(gl.GetError() == GL_NO_ERROR);
  CHECK(gl.IsList(2) == GL_FALSE);
  static const BadCall calls[] = {BAD(INVALID_VALUE, CallList(1)),
                                  BAD(INVALID_ENUM, CallLists(1, GL_4_BYTES + 1, bytes))};
  expect_refused(gl, calls);
}
