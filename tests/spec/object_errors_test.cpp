// GL 1.5: arguments that the commands of primitives, arrays, buffers, textures, pixels and lists must refuse.
#include <catch2/catch.hpp>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

unsigned char bytes[4096];
GLuint names[4];
GLint numbers[16];
GLboolean flags[4];
const GLsizei negative_count[2] = {3, -1};
const GLint firsts[2] = {0, 0};
constexpr GLsizei kHuge = 0x7fffffff;

const BadCall bad_calls[] = {
    // 2.6 Begin and End
    BAD(INVALID_ENUM, Begin(GL_POLYGON + 1)),
    BAD(INVALID_ENUM, Begin(GLenum(-1))),
    BAD(INVALID_OPERATION, End()),
    // 2.8 vertex arrays
    BAD(INVALID_VALUE, VertexPointer(1, GL_FLOAT, 0, bytes)),
    BAD(INVALID_VALUE, VertexPointer(5, GL_FLOAT, 0, bytes)),
    BAD(INVALID_VALUE, VertexPointer(3, GL_FLOAT, -1, bytes)),
    BAD(INVALID_ENUM, VertexPointer(3, GL_UNSIGNED_BYTE, 0, bytes)),
    BAD(INVALID_VALUE, NormalPointer(GL_FLOAT, -1, bytes)),
    BAD(INVALID_ENUM, NormalPointer(GL_UNSIGNED_BYTE, 0, bytes)),
    BAD(INVALID_VALUE, ColorPointer(2, GL_FLOAT, 0, bytes)),
    BAD(INVALID_VALUE, ColorPointer(5, GL_FLOAT, 0, bytes)),
    BAD(INVALID_VALUE, ColorPointer(4, GL_FLOAT, -4, bytes)),
    BAD(INVALID_ENUM, ColorPointer(4, GL_BITMAP, 0, bytes)),
    BAD(INVALID_VALUE, SecondaryColorPointer(4, GL_FLOAT, 0, bytes)),
    BAD(INVALID_ENUM, SecondaryColorPointer(3, GL_2_BYTES, 0, bytes)),
    BAD(INVALID_VALUE, SecondaryColorPointer(3, GL_FLOAT, -1, bytes)),
    BAD(INVALID_ENUM, FogCoordPointer(GL_INT, 0, bytes)),
    BAD(INVALID_VALUE, FogCoordPointer(GL_FLOAT, -1, bytes)),
    BAD(INVALID_ENUM, IndexPointer(GL_BYTE, 0, bytes)),
    BAD(INVALID_VALUE, IndexPointer(GL_INT, -1, bytes)),
    BAD(INVALID_VALUE, EdgeFlagPointer(-1, bytes)),
    BAD(INVALID_VALUE, TexCoordPointer(0, GL_FLOAT, 0, bytes)),
    BAD(INVALID_VALUE, TexCoordPointer(5, GL_FLOAT, 0, bytes)),
    BAD(INVALID_ENUM, TexCoordPointer(2, GL_UNSIGNED_INT, 0, bytes)),
    BAD(INVALID_VALUE, TexCoordPointer(2, GL_FLOAT, -1, bytes)),
    BAD(INVALID_ENUM, InterleavedArrays(GL_FLOAT, 0, bytes)),
    BAD(INVALID_VALUE, InterleavedArrays(GL_V3F, -1, bytes)),
    BAD(INVALID_VALUE, LockArraysEXT(-1, 4)),
    BAD(INVALID_VALUE, LockArraysEXT(0, 0)),
    BAD(INVALID_OPERATION, UnlockArraysEXT()),
    BAD(INVALID_ENUM, DrawArrays(GL_POLYGON + 1, 0, 3)),
    BAD(INVALID_VALUE, DrawArrays(GL_POINTS, 0, -1)),
    BAD(INVALID_VALUE, DrawArrays(GL_POINTS, -1, 1)),
    BAD(INVALID_ENUM, DrawElements(GL_POLYGON + 1, 3, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_VALUE, DrawElements(GL_POINTS, -1, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_ENUM, DrawElements(GL_POINTS, 1, GL_INT, bytes)),
    BAD(INVALID_VALUE, DrawRangeElements(GL_POINTS, 2, 1, 1, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_VALUE, DrawRangeElements(GL_POINTS, 0, 1, -1, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_ENUM, DrawRangeElements(GL_POINTS, 0, 1, 1, GL_FLOAT, bytes)),
    BAD(INVALID_ENUM, DrawRangeElements(10, 0, 1, 1, GL_UNSIGNED_INT, bytes)),
    BAD(INVALID_VALUE, MultiDrawArrays(GL_POINTS, firsts, negative_count, 2)),
    BAD(INVALID_VALUE, MultiDrawArrays(GL_POINTS, firsts, negative_count, -1)),
    BAD(INVALID_ENUM, MultiDrawArrays(10, firsts, negative_count, 1)),
    BAD(INVALID_ENUM, GetPointerv(GL_VERTEX_ARRAY, reinterpret_cast<void**>(bytes))),
    // 2.9 buffer objects
    BAD(INVALID_ENUM, BindBuffer(GL_TEXTURE_2D, 1)),
    BAD(INVALID_VALUE, GenBuffers(-1, names)),
    BAD(INVALID_VALUE, DeleteBuffers(-1, names)),
    BAD(INVALID_OPERATION, BufferData(GL_ARRAY_BUFFER, 4, bytes, GL_STATIC_DRAW)),
    BAD(INVALID_ENUM, BufferData(GL_FLOAT, 4, bytes, GL_STATIC_DRAW)),
    BAD(INVALID_OPERATION, BufferSubData(GL_ARRAY_BUFFER, 0, 4, bytes)),
    BAD(INVALID_OPERATION, GetBufferSubData(GL_ARRAY_BUFFER, 0, 4, bytes)),
    BAD(INVALID_OPERATION, MapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY)),
    BAD(INVALID_OPERATION, UnmapBuffer(GL_ELEMENT_ARRAY_BUFFER)),
    BAD(INVALID_ENUM, MapBuffer(GL_FLOAT, GL_READ_ONLY)),
    BAD(INVALID_ENUM, GetBufferParameteriv(GL_FLOAT, GL_BUFFER_SIZE, numbers)),
    BAD(INVALID_OPERATION, MapBufferRange(GL_PIXEL_PACK_BUFFER, 0, 4, GL_MAP_READ_BIT)),
    BAD(INVALID_ENUM, MapBufferRange(GL_FLOAT, 0, 4, GL_MAP_READ_BIT)),
    BAD(INVALID_OPERATION, FlushMappedBufferRange(GL_ARRAY_BUFFER, 0, 4)),
    BAD(INVALID_ENUM, FlushMappedBufferRange(GL_FLOAT, 0, 4)),
    BAD(INVALID_OPERATION, CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, 4)),
    BAD(INVALID_ENUM, CopyBufferSubData(GL_FLOAT, GL_COPY_WRITE_BUFFER, 0, 0, 4)),
    // 3.6, 4.3 pixels
    BAD(INVALID_ENUM, PixelStorei(GL_FLOAT, 1)),
    BAD(INVALID_VALUE, PixelStorei(GL_PACK_ALIGNMENT, 3)),
    BAD(INVALID_VALUE, PixelStorei(GL_UNPACK_ALIGNMENT, 0)),
    BAD(INVALID_VALUE, PixelStorei(GL_UNPACK_ROW_LENGTH, -1)),
    BAD(INVALID_VALUE, PixelStorei(GL_PACK_SKIP_ROWS, -1)),
    BAD(INVALID_VALUE, ReadPixels(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_VALUE, ReadPixels(0, 0, 1, -1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_ENUM, ReadPixels(0, 0, 1, 1, GL_FLOAT, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_ENUM, ReadPixels(0, 0, 1, 1, GL_RGBA, GL_RGBA, bytes)),
    BAD(INVALID_OPERATION, ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, bytes)),
    BAD(INVALID_VALUE, Clear(GL_CURRENT_BIT)),
    // 3.8 textures
    BAD(INVALID_ENUM, BindTexture(GL_TEXTURE_1D - 1, 1)),
    BAD(INVALID_VALUE, GenTextures(-1, names)),
    BAD(INVALID_VALUE, DeleteTextures(-1, names)),
    BAD(INVALID_VALUE, PrioritizeTextures(-1, names, nullptr)),
    BAD(INVALID_VALUE, AreTexturesResident(-1, names, flags)),
    BAD(INVALID_ENUM, TexImage2D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_VALUE, TexImage2D(GL_TEXTURE_2D, -1, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_VALUE, TexImage2D(GL_TEXTURE_2D, 40, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_VALUE, TexImage2D(GL_TEXTURE_2D, 0, 5, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_VALUE, TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, -1, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_VALUE,
        TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kHuge, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
    BAD(INVALID_VALUE, TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 2, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_ENUM, TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_BLEND, bytes)),
    BAD(INVALID_ENUM,
        TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_STENCIL_INDEX8_EXT, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_ENUM,
        TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 4, 4, 0, GL_STENCIL_INDEX, GL_INT, bytes)),
    BAD(INVALID_OPERATION,
        TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, bytes)),
    BAD(INVALID_VALUE, TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, kHuge, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
    BAD(INVALID_VALUE,
        TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, -1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
    BAD(INVALID_OPERATION,
        TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)), // no image yet
    BAD(INVALID_VALUE, TexSubImage2D(GL_TEXTURE_2D, -1, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_VALUE, CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, -4, 4, 0)),
    BAD(INVALID_VALUE, CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 3)),
    BAD(INVALID_ENUM, CopyTexImage2D(GL_TEXTURE_1D, 0, GL_RGBA, 0, 0, 4, 4, 0)),
    BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, 1)),
    BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_ENV, GL_TEXTURE_WRAP_S, GL_REPEAT)),
    BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_LINEAR)),
    BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR)),
    BAD(INVALID_VALUE, TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, -1)),
    BAD(INVALID_VALUE, TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, -1)),
    BAD(INVALID_ENUM, TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1)),
    // GL_ARB_texture_rectangle
    BAD(INVALID_VALUE,
        TexImage2D(GL_TEXTURE_RECTANGLE, 1, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_VALUE,
        TexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_RGBA, 4, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_VALUE,
        TexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_RGBA, -1, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_VALUE, CopyTexImage2D(GL_TEXTURE_RECTANGLE, 1, GL_RGBA, 0, 0, 4, 4, 0)),
    BAD(INVALID_VALUE, GetTexImage(GL_TEXTURE_RECTANGLE, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_WRAP_S, GL_REPEAT)),
    BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT)),
    BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST)),
    BAD(INVALID_VALUE, TexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_BASE_LEVEL, 1)),
    BAD(INVALID_ENUM, GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WIDTH, numbers)),
    BAD(INVALID_ENUM, GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WRAP_S, numbers)),
    BAD(INVALID_VALUE, GetTexLevelParameteriv(GL_TEXTURE_2D, -1, GL_TEXTURE_WIDTH, numbers)),
    BAD(INVALID_ENUM, GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_RGB, bytes)),
    BAD(INVALID_VALUE, GetTexImage(GL_TEXTURE_2D, -1, GL_RGBA, GL_FLOAT, bytes)),
    // 5.4 display lists
    BAD(INVALID_VALUE, NewList(0, GL_COMPILE)),
    BAD(INVALID_ENUM, NewList(1, GL_STATIC_DRAW)),
    BAD(INVALID_OPERATION, EndList()),
    BAD(INVALID_VALUE, CallList(0)),
    BAD(INVALID_VALUE, CallLists(-1, GL_UNSIGNED_BYTE, bytes)),
    BAD(INVALID_ENUM, CallLists(1, GL_DOUBLE, bytes)),
    BAD(INVALID_VALUE, GenLists(-1)),
    BAD(OUT_OF_MEMORY, GenLists(kHuge)),
    BAD(INVALID_VALUE, DeleteLists(1, -1)),
    // 6.1 queries
    BAD(INVALID_ENUM, GetString(GL_RGBA)),
};

} // namespace

REFUSAL_TEST_CASE(
    "a refused argument of an object's command gives the specification's error and changes nothing",
    "[spec][errors]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const StateSnapshot before = take_snapshot(gl, false);
  expect_refused(gl, bad_calls, [&] {
    CHECK(compare_snapshots(before, take_snapshot(gl, false)) == "");
    CHECK(gl.IsList(1) + gl.IsTexture(1) + gl.IsBuffer(1) == 0);
  });
}

REFUSAL_TEST_CASE("a refused change of a buffer or of a texture image leaves its contents",
                  "[spec][errors]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLubyte data[16] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  gl.BindBuffer(GL_ARRAY_BUFFER, 1);
  gl.BufferData(GL_ARRAY_BUFFER, 16, data, GL_STATIC_DRAW);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
  REQUIRE(gl.GetError() == GL_NO_ERROR);
  const BadCall calls[] = {
      BAD(INVALID_VALUE, BufferData(GL_ARRAY_BUFFER, -1, bytes, GL_STATIC_DRAW)),
      BAD(INVALID_ENUM, BufferData(GL_ARRAY_BUFFER, 4, bytes, GL_FLOAT)),
      BAD(OUT_OF_MEMORY, BufferData(GL_ARRAY_BUFFER, GLsizeiptr(1) << 60, nullptr, GL_STATIC_DRAW)),
      BAD(INVALID_VALUE, BufferSubData(GL_ARRAY_BUFFER, -1, 4, bytes)),
      BAD(INVALID_VALUE, BufferSubData(GL_ARRAY_BUFFER, 0, -4, bytes)),
      BAD(INVALID_VALUE, BufferSubData(GL_ARRAY_BUFFER, 13, 4, bytes)),
      BAD(INVALID_VALUE, GetBufferSubData(GL_ARRAY_BUFFER, 13, 4, bytes)),
      BAD(INVALID_VALUE, GetBufferSubData(GL_ARRAY_BUFFER, GLintptr(1) << 62, GLsizeiptr(1) << 62, bytes)),
      BAD(INVALID_ENUM, MapBuffer(GL_ARRAY_BUFFER, GL_FLOAT)),
      BAD(INVALID_OPERATION, UnmapBuffer(GL_ARRAY_BUFFER)),
      BAD(INVALID_ENUM, GetBufferParameteriv(GL_ARRAY_BUFFER, GL_FLOAT, numbers)),
      BAD(INVALID_ENUM, GetBufferPointerv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, reinterpret_cast<void**>(bytes))),
      BAD(INVALID_VALUE, TexSubImage2D(GL_TEXTURE_2D, 0, 1, 0, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage2D(GL_TEXTURE_2D, 0, -1, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE,
          TexSubImage2D(GL_TEXTURE_2D, 0, kHuge, 0, kHuge, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_FLOAT, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, CopyTexSubImage2D(GL_TEXTURE_2D, 0, 1, 1, 0, 0, 2, 2)),
      BAD(INVALID_OPERATION, CopyTexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 0, 0, 1, 1)),
      BAD(INVALID_VALUE, TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, -2, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
  };
  expect_refused(gl, calls, [&] {
    GLubyte buffer[16] = {}, texels[16] = {};
    gl.GetBufferSubData(GL_ARRAY_BUFFER, 0, 16, buffer);
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    CHECK(std::string(buffer, buffer + 16) == std::string(data, data + 16));
    CHECK(std::string(texels, texels + 16) == std::string(data, data + 16));
    CHECK(gl.GetError() == GL_NO_ERROR);
  });
  REQUIRE(gl.MapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY) !=
          nullptr); // while it is mapped nobody else may touch it (2.9)
  const BadCall mapped[] = {BAD(INVALID_OPERATION, BufferSubData(GL_ARRAY_BUFFER, 0, 4, bytes)),
                            BAD(INVALID_OPERATION, GetBufferSubData(GL_ARRAY_BUFFER, 0, 4, bytes)),
                            BAD(INVALID_OPERATION, MapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY))};
  expect_refused(gl, mapped, [] {});
  CHECK(gl.UnmapBuffer(GL_ARRAY_BUFFER) == GL_TRUE);
}

TEST_CASE("a buffer without bytes cannot be mapped", "[spec][errors]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    for (const bool never_filled : {true, false}) {
      gl->BindBuffer(GL_ARRAY_BUFFER, never_filled ? 1 : 2);
      if (!never_filled) gl->BufferData(GL_ARRAY_BUFFER, 0, nullptr, GL_STATIC_DRAW);
      CHECK(gl->MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY) == nullptr);
      CHECK(gl->GetError() == GL_INVALID_OPERATION);
      GLint mapped = 1;
      gl->GetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_MAPPED, &mapped);
      CHECK(mapped == 0);
    }
  }
}
