// The errors that GL 1.5, 3.8 and 6.1.4, and the extensions of textures name. Each is raised by a call that
// is wrong in nothing else, and changes nothing.
#include <catch2/catch.hpp>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

unsigned char bytes[1 << 16];
GLfloat floats[16];
GLint numbers[16];
GLuint names[4];
GLboolean flags[4];
constexpr GLenum kDxt5 = GL_COMPRESSED_RGBA_S3TC_DXT5_EXT;

// 8 x 8 in every target but GL_TEXTURE_RECTANGLE, and S3TC in level 0 of GL_TEXTURE_2D.
void make_images(const Gl& gl) {
  gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GLint(kDxt5), 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
  gl.TexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
  gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
  REQUIRE(gl.GetError() == GL_NO_ERROR);
}

} // namespace

REFUSAL_TEST_CASE("images of textures refuse what is wrong in one argument", "[spec][errors]") { // 3.8.1
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  make_images(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, TexImage1D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexImage1D(GL_TEXTURE_1D, -1, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexImage1D(GL_TEXTURE_1D, 15, GL_RGBA, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexImage1D(GL_TEXTURE_1D, 0, GL_FLOAT, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, -1, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 2, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA8, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_DOUBLE, bytes)),
      BAD(INVALID_ENUM, TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_BITMAP, bytes)),
      BAD(INVALID_OPERATION,
          TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGB, GL_UNSIGNED_INT_8_8_8_8, bytes)),
      BAD(INVALID_OPERATION,
          TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT, bytes)),
      BAD(INVALID_OPERATION,
          TexImage1D(GL_TEXTURE_1D, 0, GL_DEPTH_COMPONENT, 4, 0, GL_RGBA, GL_FLOAT, bytes)),
      BAD(INVALID_ENUM,
          TexImage2D(GL_TEXTURE_CUBE_MAP, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, TexImage2D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE,
          TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 4, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, -1, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE,
          TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 20000, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
      BAD(INVALID_VALUE, TexImage2D(GL_TEXTURE_2D, 14, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, -1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION,
          TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, bytes)),
      BAD(INVALID_ENUM,
          TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, 4, 4, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT, bytes)),
      BAD(INVALID_OPERATION,
          TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_INT_24_8, bytes)),
      BAD(INVALID_ENUM, TexImage3D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE,
          TexImage3D(GL_TEXTURE_3D, 12, GL_RGBA, 1, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexImage3D(GL_TEXTURE_3D, 0, 0, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE,
          TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4096, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
      BAD(INVALID_VALUE, TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 2, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION,
          TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 0, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4, bytes)),
      BAD(INVALID_OPERATION,
          TexImage3D(GL_TEXTURE_3D, 0, GL_DEPTH_COMPONENT, 4, 4, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT, bytes)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("parts of images refuse what is wrong in one argument", "[spec][errors]") { // 3.8.2
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  make_images(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, TexSubImage1D(GL_TEXTURE_2D, 0, 0, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, TexSubImage1D(GL_PROXY_TEXTURE_1D, 0, 0, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage1D(GL_TEXTURE_1D, -1, 0, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage1D(GL_TEXTURE_1D, 15, 0, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION, TexSubImage1D(GL_TEXTURE_1D, 3, 0, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage1D(GL_TEXTURE_1D, 0, -1, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage1D(GL_TEXTURE_1D, 0, 5, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage1D(GL_TEXTURE_1D, 0, 0, -4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, TexSubImage1D(GL_TEXTURE_1D, 0, 0, 4, GL_INTENSITY, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, TexSubImage1D(GL_TEXTURE_1D, 0, 0, 4, GL_RGBA, GL_2_BYTES, bytes)),
      BAD(INVALID_OPERATION, TexSubImage1D(GL_TEXTURE_1D, 0, 0, 4, GL_RGBA, GL_UNSIGNED_BYTE_3_3_2, bytes)),
      BAD(INVALID_OPERATION, TexSubImage1D(GL_TEXTURE_1D, 0, 0, 4, GL_DEPTH_COMPONENT, GL_FLOAT, bytes)),
      BAD(INVALID_ENUM, TexSubImage2D(GL_TEXTURE_CUBE_MAP, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, TexSubImage2D(GL_PROXY_TEXTURE_2D, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION,
          TexSubImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_X, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage2D(GL_TEXTURE_2D, 1, 1, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage2D(GL_TEXTURE_2D, 1, 0, 1, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 4, -4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, TexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 4, 4, GL_RGBA, GL_BITMAP, bytes)),
      BAD(INVALID_OPERATION,
          TexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 4, 4, GL_BGR, GL_UNSIGNED_SHORT_5_6_5, bytes)),
      BAD(INVALID_ENUM,
          TexSubImage3D(GL_PROXY_TEXTURE_3D, 0, 0, 0, 0, 4, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 5, 4, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE,
          TexSubImage3D(GL_TEXTURE_3D, 0, 0, -1, 0, 4, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE,
          TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 4, 4, -1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE,
          TexSubImage3D(GL_TEXTURE_3D, 12, 0, 0, 0, 4, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION,
          TexSubImage3D(GL_TEXTURE_3D, 1, 0, 0, 0, 4, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION,
          TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 4, 4, 4, GL_RGB, GL_UNSIGNED_INT_8_8_8_8, bytes)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("copies into textures refuse what is wrong in one argument", "[spec][errors]") { // 3.8.2
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  make_images(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, CopyTexImage1D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 0)),
      BAD(INVALID_ENUM, CopyTexImage1D(GL_PROXY_TEXTURE_1D, 0, GL_RGBA, 0, 0, 4, 0)),
      BAD(INVALID_VALUE, CopyTexImage1D(GL_TEXTURE_1D, -1, GL_RGBA, 0, 0, 4, 0)),
      BAD(INVALID_VALUE, CopyTexImage1D(GL_TEXTURE_1D, 15, GL_RGBA, 0, 0, 4, 0)),
      BAD(INVALID_ENUM, CopyTexImage1D(GL_TEXTURE_1D, 0, 4, 0, 0, 4, 0)),
      BAD(INVALID_ENUM, CopyTexImage1D(GL_TEXTURE_1D, 0, GL_FLOAT, 0, 0, 4, 0)),
      BAD(INVALID_VALUE, CopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 0, 0, -4, 0)),
      BAD(INVALID_VALUE, CopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 0, 0, 4, 2)),
      BAD(INVALID_ENUM, CopyTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0)),
      BAD(INVALID_ENUM, CopyTexImage2D(GL_TEXTURE_2D, 0, 1, 0, 0, 4, 4, 0)),
      BAD(INVALID_ENUM, CopyTexImage2D(GL_TEXTURE_2D, 0, 3, 0, 0, 4, 4, 0)),
      BAD(INVALID_VALUE, CopyTexImage2D(GL_TEXTURE_2D, 15, GL_RGBA, 0, 0, 4, 4, 0)),
      BAD(INVALID_VALUE, CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, -4, 0)),
      BAD(INVALID_VALUE, CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 20000, 4, 0)),
      BAD(INVALID_VALUE, CopyTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Y, 0, GL_RGBA, 0, 0, 4, 8, 0)),
      BAD(INVALID_ENUM, CopyTexSubImage1D(GL_TEXTURE_2D, 0, 0, 0, 0, 4)),
      BAD(INVALID_VALUE, CopyTexSubImage1D(GL_TEXTURE_1D, -1, 0, 0, 0, 4)),
      BAD(INVALID_VALUE, CopyTexSubImage1D(GL_TEXTURE_1D, 0, 5, 0, 0, 4)),
      BAD(INVALID_VALUE, CopyTexSubImage1D(GL_TEXTURE_1D, 0, -1, 0, 0, 4)),
      BAD(INVALID_VALUE, CopyTexSubImage1D(GL_TEXTURE_1D, 0, 0, 0, 0, -4)),
      BAD(INVALID_OPERATION, CopyTexSubImage1D(GL_TEXTURE_1D, 2, 0, 0, 0, 1)),
      BAD(INVALID_ENUM, CopyTexSubImage2D(GL_TEXTURE_CUBE_MAP, 0, 0, 0, 0, 0, 4, 4)),
      BAD(INVALID_VALUE, CopyTexSubImage2D(GL_TEXTURE_2D, 15, 0, 0, 0, 0, 4, 4)),
      BAD(INVALID_VALUE, CopyTexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 0, 0, 4, 5)),
      BAD(INVALID_VALUE, CopyTexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 0, 0, -1, 4)),
      BAD(INVALID_ENUM, CopyTexSubImage3D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 0, 4, 4)),
      BAD(INVALID_VALUE, CopyTexSubImage3D(GL_TEXTURE_3D, 12, 0, 0, 0, 0, 0, 4, 4)),
      BAD(INVALID_VALUE, CopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 8, 0, 0, 4, 4)),
      BAD(INVALID_VALUE, CopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, -1, 0, 0, 4, 4)),
      BAD(INVALID_VALUE, CopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 0, 0, -4, 4)),
      BAD(INVALID_OPERATION, CopyTexSubImage3D(GL_TEXTURE_3D, 1, 0, 0, 0, 0, 0, 4, 4)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("compressed images refuse what is wrong in one argument", "[spec][errors]") { // 3.8.3, S3TC
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  make_images(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, CompressedTexImage1D(GL_TEXTURE_1D, 0, kDxt5, 4, 0, 16, bytes)),
      BAD(INVALID_ENUM, CompressedTexImage1D(GL_TEXTURE_1D, 0, GL_COMPRESSED_RGBA, 4, 0, 16, bytes)),
      BAD(INVALID_ENUM, CompressedTexImage2D(GL_TEXTURE_3D, 0, kDxt5, 4, 4, 0, 16, bytes)),
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_TEXTURE_2D, -1, kDxt5, 4, 4, 0, 16, bytes)),
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_TEXTURE_2D, 15, kDxt5, 4, 4, 0, 16, bytes)),
      BAD(INVALID_ENUM, CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB, 4, 4, 0, 16, bytes)),
      BAD(INVALID_ENUM, CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, 16, bytes)),
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_TEXTURE_2D, 0, kDxt5, -4, 4, 0, 16, bytes)),
      BAD(INVALID_OPERATION, CompressedTexImage2D(GL_TEXTURE_2D, 0, kDxt5, 4, 4, 1, 16, bytes)),
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_TEXTURE_2D, 0, kDxt5, 4, 4, 0, 15, bytes)),
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_TEXTURE_2D, 0, kDxt5, 4, 4, 0, 32, bytes)),
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_TEXTURE_2D, 0, kDxt5, 4, 4, 0, -1, bytes)),
      BAD(INVALID_ENUM, CompressedTexImage3D(GL_TEXTURE_3D, 0, GL_COMPRESSED_RGBA, 4, 4, 4, 0, 16, bytes)),
      BAD(INVALID_ENUM, CompressedTexSubImage1D(GL_TEXTURE_1D, 0, 0, 4, GL_COMPRESSED_RGBA, 16, bytes)),
      BAD(INVALID_ENUM, CompressedTexSubImage2D(GL_PROXY_TEXTURE_2D, 0, 0, 0, 4, 4, kDxt5, 16, bytes)),
      BAD(INVALID_VALUE, CompressedTexSubImage2D(GL_TEXTURE_2D, -1, 0, 0, 4, 4, kDxt5, 16, bytes)),
      BAD(INVALID_VALUE, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, kDxt5, 8, bytes)),
      BAD(INVALID_VALUE, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 8, 0, 4, 4, kDxt5, 16, bytes)),
      BAD(INVALID_VALUE, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, -4, 4, kDxt5, 16, bytes)),
      BAD(INVALID_OPERATION, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 2, 0, 4, 4, kDxt5, 16, bytes)),
      BAD(INVALID_OPERATION, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 3, 4, kDxt5, 16, bytes)),
      BAD(INVALID_OPERATION,
          CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, 16, bytes)),
      BAD(INVALID_OPERATION, CompressedTexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 4, 4, kDxt5, 16, bytes)),
      BAD(INVALID_OPERATION, CompressedTexSubImage2D(GL_TEXTURE_2D, 2, 0, 0, 4, 4, kDxt5, 16, bytes)),
      BAD(INVALID_ENUM, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_COMPRESSED_RGB, 16, bytes)),
      BAD(INVALID_ENUM,
          CompressedTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 4, 4, 4, GL_COMPRESSED_RGBA, 16, bytes)),
      BAD(INVALID_ENUM, GetCompressedTexImage(GL_PROXY_TEXTURE_2D, 0, bytes)),
      BAD(INVALID_ENUM, GetCompressedTexImage(GL_TEXTURE_CUBE_MAP, 0, bytes)),
      BAD(INVALID_VALUE, GetCompressedTexImage(GL_TEXTURE_2D, -1, bytes)),
      BAD(INVALID_VALUE, GetCompressedTexImage(GL_TEXTURE_2D, 15, bytes)),
      BAD(INVALID_OPERATION, GetCompressedTexImage(GL_TEXTURE_2D, 1, bytes)),
      BAD(INVALID_OPERATION, GetCompressedTexImage(GL_TEXTURE_2D, 2, bytes)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("objects and parameters of textures refuse what is wrong in one argument",
                  "[spec][errors]") { // 3.8.4, 3.8.12
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  make_images(gl);
  gl.BindTexture(GL_TEXTURE_2D, 5);
  static const BadCall calls[] = {
      BAD(INVALID_OPERATION, BindTexture(GL_TEXTURE_1D, 5)),
      BAD(INVALID_OPERATION, BindTexture(GL_TEXTURE_CUBE_MAP, 5)),
      BAD(INVALID_ENUM, BindTexture(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 1)),
      BAD(INVALID_ENUM, BindTexture(GL_PROXY_TEXTURE_2D, 1)),
      BAD(INVALID_VALUE, AreTexturesResident(1, names, flags)), // 0 is no texture
      BAD(INVALID_ENUM, TexParameterf(GL_PROXY_TEXTURE_2D, GL_TEXTURE_PRIORITY, 1)),
      BAD(INVALID_ENUM, TexParameterf(GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_PRIORITY, 1)),
      BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_REPEAT)),
      BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST_MIPMAP_NEAREST)),
      BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_R, GL_NEAREST)),
      BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_LEQUAL)),
      BAD(INVALID_ENUM, TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, 1048576)),
      BAD(INVALID_ENUM, TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, -1)),
      BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_NONE)),
      BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_RGB)),
      BAD(INVALID_VALUE, TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_BASE_LEVEL, -1)),
      BAD(INVALID_VALUE, TexParameterf(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, -1)),
      BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WIDTH, 1)),
      BAD(INVALID_ENUM, TexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_RESIDENT, numbers)),
      BAD(INVALID_ENUM, TexParameterfv(GL_TEXTURE_ENV, GL_TEXTURE_BORDER_COLOR, floats)),
      BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, GL_TRUE)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("queries of textures refuse what is wrong in one argument",
                  "[spec][errors]") { // 6.1.3, 6.1.4
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  make_images(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, GetTexParameterfv(GL_PROXY_TEXTURE_2D, GL_TEXTURE_PRIORITY, floats)),
      BAD(INVALID_ENUM, GetTexParameteriv(GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_PRIORITY, numbers)),
      BAD(INVALID_ENUM, GetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_ENV_COLOR, floats)),
      BAD(INVALID_ENUM, GetTexLevelParameteriv(GL_TEXTURE_CUBE_MAP, 0, GL_TEXTURE_WIDTH, numbers)),
      BAD(INVALID_ENUM, GetTexLevelParameterfv(GL_TEXTURE_ENV, 0, GL_TEXTURE_WIDTH, floats)),
      BAD(INVALID_VALUE, GetTexLevelParameterfv(GL_TEXTURE_2D, -1, GL_TEXTURE_WIDTH, floats)),
      BAD(INVALID_VALUE, GetTexLevelParameteriv(GL_TEXTURE_2D, 15, GL_TEXTURE_WIDTH, numbers)),
      BAD(INVALID_VALUE, GetTexLevelParameteriv(GL_TEXTURE_3D, 12, GL_TEXTURE_WIDTH, numbers)),
      BAD(INVALID_ENUM, GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_PRIORITY, numbers)),
      BAD(INVALID_OPERATION,
          GetTexLevelParameteriv(GL_TEXTURE_2D, 1, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, numbers)),
      BAD(INVALID_OPERATION,
          GetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, numbers)),
      BAD(INVALID_ENUM, GetTexImage(GL_TEXTURE_CUBE_MAP, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, GetTexImage(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, GetTexImage(GL_TEXTURE_2D, 15, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, GetTexImage(GL_TEXTURE_2D, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, GetTexImage(GL_TEXTURE_2D, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION,
          GetTexImage(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT, GL_FLOAT, bytes)), // GL_ARB_depth_texture
      BAD(INVALID_OPERATION, GetTexImage(GL_TEXTURE_2D, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, bytes)),
      BAD(INVALID_ENUM, GetTexImage(GL_TEXTURE_2D, 1, GL_RGBA8, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, GetTexImage(GL_TEXTURE_2D, 1, GL_RGBA, GL_BITMAP, bytes)),
      BAD(INVALID_OPERATION, GetTexImage(GL_TEXTURE_2D, 1, GL_RGBA, GL_UNSIGNED_BYTE_2_3_3_REV, bytes)),
      BAD(INVALID_ENUM, GetTexEnviv(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, numbers)),
      BAD(INVALID_ENUM, GetTexEnvfv(GL_TEXTURE_ENV, GL_COORD_REPLACE, floats)),
      BAD(INVALID_ENUM, GetTexEnviv(GL_POINT_SPRITE, GL_TEXTURE_ENV_MODE, numbers)),
      BAD(INVALID_ENUM, GetTexGeniv(GL_TEXTURE_2D, GL_TEXTURE_GEN_MODE, numbers)),
      BAD(INVALID_ENUM, GetTexGenfv(GL_S, GL_TEXTURE_GEN_S, floats)),
  };
  expect_refused(gl, calls);
}
