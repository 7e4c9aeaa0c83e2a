// GL_ARB_texture_storage: textures whose sizes and format stay.
#include <catch2/catch.hpp>

#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

GLint level_value(const Gl& gl, GLenum target, GLint level, GLenum pname) {
  GLint value = -1;
  gl.GetTexLevelParameteriv(target, level, pname, &value);
  return value;
}

GLint immutable(const Gl& gl, GLenum target) {
  GLint value = -1;
  gl.GetTexParameteriv(target, GL_TEXTURE_IMMUTABLE_FORMAT, &value);
  return value;
}

GLuint bind_new(const Gl& gl, GLenum target) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(target, name);
  return name;
}

} // namespace

TEST_CASE("all levels get their sizes and the format at once", "[spec][texture_storage]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  bind_new(gl, GL_TEXTURE_2D);
  CHECK(immutable(gl, GL_TEXTURE_2D) == GL_FALSE);
  gl.TexStorage2D(GL_TEXTURE_2D, 3, GL_RGBA8, 8, 2);
  CHECK(gl.GetError() == GL_NO_ERROR);
  CHECK(immutable(gl, GL_TEXTURE_2D) == GL_TRUE);
  for (int level = 0; level < 4; ++level) {
    CHECK(level_value(gl, GL_TEXTURE_2D, level, GL_TEXTURE_WIDTH) == (level < 3 ? 8 >> level : 0));
    CHECK(level_value(gl, GL_TEXTURE_2D, level, GL_TEXTURE_HEIGHT) == (level == 0 ? 2 : level < 3 ? 1 : 0));
  }
  CHECK(level_value(gl, GL_TEXTURE_2D, 2, GL_TEXTURE_INTERNAL_FORMAT) == GL_RGBA8);
  bind_new(gl, GL_TEXTURE_3D);
  gl.TexStorage3D(GL_TEXTURE_3D, 2, GL_LUMINANCE8, 4, 4, 6);
  CHECK(level_value(gl, GL_TEXTURE_3D, 1, GL_TEXTURE_DEPTH) == 3);
  bind_new(gl, GL_TEXTURE_1D);
  gl.TexStorage1D(GL_TEXTURE_1D, 4, GL_DEPTH_COMPONENT24, 8);
  CHECK(level_value(gl, GL_TEXTURE_1D, 3, GL_TEXTURE_WIDTH) == 1);
  bind_new(gl, GL_TEXTURE_CUBE_MAP);
  gl.TexStorage2D(GL_TEXTURE_CUBE_MAP, 3, GL_RGB5, 4, 4);
  CHECK(level_value(gl, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, 2, GL_TEXTURE_WIDTH) == 1);
  bind_new(gl, GL_TEXTURE_2D);
  gl.TexStorage2D(GL_TEXTURE_2D, 4, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 8, 8);
  CHECK(level_value(gl, GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE) == 32);
  bind_new(gl, GL_TEXTURE_RECTANGLE);
  gl.TexStorage2D(GL_TEXTURE_RECTANGLE, 1, GL_RGBA8, 5, 3);
  CHECK(level_value(gl, GL_TEXTURE_RECTANGLE, 0, GL_TEXTURE_WIDTH) == 5);
  CHECK(gl.GetError() == GL_NO_ERROR);
}

REFUSAL_TEST_CASE("an immutable texture takes texels and parameters, but no images",
                  "[spec][texture_storage]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  bind_new(gl, GL_TEXTURE_2D);
  gl.TexStorage2D(GL_TEXTURE_2D, 2, GL_RGBA8, 4, 4);
  static GLubyte bytes[256];
  // clang-format off
  static const BadCall calls[] = {
      BAD(INVALID_OPERATION, TexStorage2D(GL_TEXTURE_2D, 2, GL_RGBA8, 4, 4)),
      BAD(INVALID_OPERATION, TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION, TexImage2D(GL_TEXTURE_2D, 5, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION, CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 4, 4, 0)),
      BAD(INVALID_OPERATION, CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 0, 8, bytes)),
  };
  // clang-format on
  expect_refused(gl, calls, [&] { CHECK(level_value(gl, GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH) == 4); });
  for (int i = 0; i < 64; ++i) bytes[i] = GLubyte(i);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
  gl.CopyTexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 0, 0, 2, 2);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.GenerateMipmap(GL_TEXTURE_2D);
  CHECK(gl.GetError() == GL_NO_ERROR);
  GLubyte read[64];
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read);
  CHECK(std::vector<int>(read, read + 64) == std::vector<int>(bytes, bytes + 64));
  CHECK(level_value(gl, GL_TEXTURE_2D, 2, GL_TEXTURE_WIDTH) == 0); // no level behind the last one
}

TEST_CASE("the levels of an immutable texture are clamped when they are set", "[spec][texture_storage]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    const auto set = [&](GLenum pname, GLint level) { gl->TexParameteri(GL_TEXTURE_2D, pname, level); };
    const auto levels = [&] {
      GLint base = -1, max = -1;
      gl->GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, &base);
      gl->GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, &max);
      return std::vector<GLint>{base, max};
    };
    bind_new(*gl, GL_TEXTURE_2D);
    set(GL_TEXTURE_BASE_LEVEL, 7);
    gl->TexStorage2D(GL_TEXTURE_2D, 3, GL_RGBA8, 64, 64);
    CHECK(levels() == std::vector<GLint>{7, 1000}); // what was set before stays
    set(GL_TEXTURE_BASE_LEVEL, 9);
    set(GL_TEXTURE_MAX_LEVEL, 4);
    CHECK(levels() == std::vector<GLint>{2, 2});
    set(GL_TEXTURE_MAX_LEVEL, 1); // not below the base level
    CHECK(levels() == std::vector<GLint>{2, 2});
    set(GL_TEXTURE_BASE_LEVEL, 0);
    set(GL_TEXTURE_MAX_LEVEL, 1);
    CHECK(levels() == std::vector<GLint>{0, 1});
    CHECK(gl->GetError() == GL_NO_ERROR);
  }
}

TEST_CASE("levels beyond those of an immutable texture are not asked for", "[spec][texture_storage]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  bind_new(gl, GL_TEXTURE_2D);
  gl.TexStorage2D(GL_TEXTURE_2D, 2, GL_RGBA8, 8, 8); // two of four levels
  const std::vector<GLubyte> red(8 * 8, 255);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RED, GL_UNSIGNED_BYTE, red.data());
  gl.TexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 4, 4, GL_RED, GL_UNSIGNED_BYTE, red.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 7);
  gl.Enable(GL_TEXTURE_2D);
  gl.Rectf(-1, -1, 1, 1);
  GLubyte rgba[4] = {};
  gl.ReadPixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  CHECK(std::vector<int>(rgba, rgba + 4) == std::vector<int>{255, 0, 0, 255});
}

REFUSAL_TEST_CASE("TexStorage refuses what its text refuses", "[spec][texture_storage]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  // clang-format off
  static const BadCall of_default[] = {BAD(INVALID_OPERATION, TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 4, 4))};
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, TexStorage2D(GL_TEXTURE_1D, 1, GL_RGBA8, 4, 4)),
      BAD(INVALID_ENUM, TexStorage1D(GL_TEXTURE_2D, 1, GL_RGBA8, 4)),
      BAD(INVALID_ENUM, TexStorage3D(GL_TEXTURE_2D, 1, GL_RGBA8, 4, 4, 4)),
      BAD(INVALID_ENUM, TexStorage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 1, GL_RGBA8, 4, 4)),
      BAD(INVALID_ENUM, TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA, 4, 4)),
      BAD(INVALID_ENUM, TexStorage2D(GL_TEXTURE_2D, 1, 4, 4, 4)),
      BAD(INVALID_ENUM, TexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT, 4, 4)),
      BAD(INVALID_ENUM, TexStorage2D(GL_TEXTURE_2D, 1, GL_COMPRESSED_RGB, 4, 4)),
      BAD(INVALID_VALUE, TexStorage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4)),
      BAD(INVALID_VALUE, TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 0, 4)),
      BAD(INVALID_VALUE, TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 4, -1)),
      BAD(INVALID_VALUE, TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 1 << 20, 1)),
      BAD(INVALID_OPERATION, TexStorage2D(GL_TEXTURE_2D, 4, GL_RGBA8, 4, 4)),
  };
  // clang-format on
  expect_refused(gl, of_default, [&] { CHECK(level_value(gl, GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH) == 0); });
  bind_new(gl, GL_TEXTURE_2D);
  expect_refused(gl, calls, [&] { CHECK(immutable(gl, GL_TEXTURE_2D) == GL_FALSE); });
  // A proxy says whether it would work.
  gl.TexStorage2D(GL_PROXY_TEXTURE_2D, 2, GL_RGBA8, 8, 8);
  CHECK(level_value(gl, GL_PROXY_TEXTURE_2D, 1, GL_TEXTURE_WIDTH) == 4);
  gl.TexStorage2D(GL_PROXY_TEXTURE_2D, 2, GL_RGBA8, 1 << 20, 8);
  CHECK(level_value(gl, GL_PROXY_TEXTURE_2D, 1, GL_TEXTURE_WIDTH) == 0);
  CHECK(gl.GetError() == GL_NO_ERROR);
}
