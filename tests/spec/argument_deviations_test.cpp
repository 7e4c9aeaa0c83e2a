// Arguments that OSMesa answers otherwise than the specification does: rows of reference/DEVIATIONS.md. What
// the random calls of softgl_arguments leave out is tested here.
#include <catch2/catch.hpp>

#include <utility>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

unsigned char bytes[4096];
GLfloat floats[64];
const GLsizei counts[2] = {1, 1}, negative_counts[2] = {1, -1};
const GLint firsts[2] = {0, 0};
const void* const index_arrays[2] = {bytes, bytes};
const GLuint textures[1] = {1};

GLint integer(const Gl& gl, GLenum name) {
  GLint value = -77;
  gl.GetIntegerv(name, &value);
  return value;
}
GLfloat real(const Gl& gl, GLenum name) {
  GLfloat values[4] = {-77, -77, -77, -77};
  gl.GetFloatv(name, values);
  return values[0];
}

} // namespace

REFUSAL_TEST_CASE("Names of later versions are refused", "[spec][errors]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, BlendFunc(GL_SOURCE1_ALPHA, GL_ZERO)),
      BAD(INVALID_ENUM, BlendFunc(GL_ONE, GL_SOURCE1_ALPHA)),
      BAD(INVALID_ENUM, BlendFuncSeparate(GL_ONE, GL_ZERO, GL_SOURCE1_ALPHA, GL_ZERO)),
      BAD(INVALID_ENUM, BlendFuncSeparate(GL_ONE, GL_ZERO, GL_ONE, GL_SOURCE1_ALPHA)),
      BAD(INVALID_VALUE,
          TexImage2D(GL_TEXTURE_2D, 0, GL_STENCIL_INDEX, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, CopyTexImage2D(GL_TEXTURE_2D, 0, GL_STENCIL_INDEX, 0, 0, 4, 4, 0)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("Bad arguments in a list raise the error that they raise elsewhere",
                  "[spec][errors][lists]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, DrawElements(GL_POINTS, 1, GL_FLOAT, bytes)),
      BAD(INVALID_VALUE, Map1f(GL_MAP1_VERTEX_3, 0, 1, 2, 2, floats)),
      BAD(INVALID_VALUE, Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 1, 2, floats)),
      BAD(INVALID_VALUE, MultiDrawArrays(GL_POINTS, firsts, counts, -1)),
      BAD(INVALID_VALUE, MultiDrawArrays(GL_POINTS, firsts, negative_counts, 2)),
      BAD(INVALID_VALUE, MultiDrawElements(GL_POINTS, counts, GL_UNSIGNED_BYTE, index_arrays, -1)),
      BAD(INVALID_VALUE, PrioritizeTextures(-1, textures, floats)),
      BAD(INVALID_VALUE,
          CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 4, 4, 0, -1, bytes)),
      BAD(INVALID_VALUE, Bitmap(-1, 4, 0, 0, 1, 1, bytes)),
      BAD(INVALID_VALUE, Bitmap(4, -1, 0, 0, 1, 1, bytes)),
      BAD(INVALID_ENUM, StencilFuncSeparateATI(GL_LESS, GL_KEEP, 3, 4)),
      BAD(INVALID_ENUM, StencilFuncSeparateATI(GL_KEEP, GL_LESS, 3, 4)),
      BAD(INVALID_VALUE, CallList(0)),
      BAD(INVALID_ENUM, TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, 1048576)),
  };
  expect_refused(gl, calls); // at once
  for (const BadCall& bad : calls) {
    INFO(bad.text);
    const StateSnapshot before = take_snapshot(gl, false);
    gl.NewList(1, GL_COMPILE);
    bad.run(gl);
    gl.EndList();
    gl.CallList(1);
    CHECK(gl.GetError() == bad.error);
    CHECK(gl.GetError() == GL_NO_ERROR);
    gl.DeleteLists(1, 1);
    CHECK(compare_snapshots(before, take_snapshot(gl, false)) == "");
  }
}

TEST_CASE("The images of proxies are asked for while a list is compiled", "[spec][lists]") { // 5.4
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    gl->NewList(1, GL_COMPILE);
    gl->TexImage1D(GL_PROXY_TEXTURE_1D, 0, GL_RGBA, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl->CompressedTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 8, 8, 0, 64, nullptr);
    gl->TexImage3D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                   nullptr); // not its own
    gl->EndList();
    CHECK(gl->GetError() == GL_NO_ERROR);
    GLint width[2] = {};
    gl->GetTexLevelParameteriv(GL_PROXY_TEXTURE_1D, 0, GL_TEXTURE_WIDTH, &width[0]);
    gl->GetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width[1]);
    CHECK(width[0] == 8);
    CHECK(width[1] == 8);
    gl->CallList(1);
    CHECK(gl->GetError() == GL_INVALID_ENUM);
  }
}

TEST_CASE("A blit is no part of a list", "[spec][lists]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.NewList(1, GL_COMPILE);
  gl.BlitFramebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_FOG_BIT, GL_NEAREST);
  CHECK(gl.GetError() == GL_INVALID_VALUE);
  gl.EndList();
  gl.CallList(1);
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("Mipmaps of no image are none", "[spec][errors]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D}) gl.GenerateMipmap(target);
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("Colors are clamped whatever is bound", "[spec]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const GLfloat color[4] = {-1, 2, 0.5f, 1};
  gl.AlphaFunc(GL_LESS, -1);
  gl.Fogfv(GL_FOG_COLOR, color);
  gl.BlendColor(-1, 2, 0.5f, 1);
  for (GLenum name : {GL_ALPHA_TEST_REF, GL_FOG_COLOR, GL_BLEND_COLOR}) CHECK(real(gl, name) == 0);
}

TEST_CASE("Bits of a deleted renderbuffer are none", "[spec]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLuint framebuffer = 0, renderbuffers[2] = {};
  gl.GenFramebuffers(1, &framebuffer);
  gl.GenRenderbuffers(2, renderbuffers);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  for (int i = 0; i < 2; ++i) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffers[i]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, i == 0 ? GL_RGBA8 : GL_DEPTH24_STENCIL8, 16, 16);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, i == 0 ? GL_COLOR_ATTACHMENT0 : GL_DEPTH_STENCIL_ATTACHMENT,
                               GL_RENDERBUFFER, renderbuffers[i]);
  }
  CHECK(integer(gl, GL_DEPTH_BITS) == 24);
  CHECK(integer(gl, GL_STENCIL_BITS) == 8);
  gl.DeleteRenderbuffers(1, &renderbuffers[1]);
  CHECK(integer(gl, GL_DEPTH_BITS) == 0);
  CHECK(integer(gl, GL_STENCIL_BITS) == 0);
}

TEST_CASE("Bits of colors are those of the first image, whatever the draw buffer is", "[spec]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    GLuint framebuffer = 0, renderbuffer = 0;
    gl->GenFramebuffers(1, &framebuffer);
    gl->GenRenderbuffers(1, &renderbuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    gl->RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 16, 16);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
    gl->DrawBuffer(GL_NONE);
    for (GLenum name : {GL_RED_BITS, GL_GREEN_BITS, GL_BLUE_BITS, GL_ALPHA_BITS})
      CHECK(integer(*gl, name) == 8);
  }
}

TEST_CASE("Levels given as floats are rounded", "[spec]") { // 3.8.4
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    for (GLenum name : {GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL}) {
      GLint level = -1;
      for (const auto& [given, taken] : {std::pair{254.5f, 255}, {3.4f, 3}, {-0.4f, 0}}) {
        gl->TexParameterf(GL_TEXTURE_2D, name, given);
        gl->GetTexParameteriv(GL_TEXTURE_2D, name, &level);
        CHECK(level == taken);
      }
      CHECK(gl->GetError() == GL_NO_ERROR);
      gl->TexParameterf(GL_TEXTURE_2D, name, -0.6f);
      CHECK(gl->GetError() == GL_INVALID_VALUE);
    }
  }
}

TEST_CASE("A large list base is no negative number", "[spec]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.ListBase(0x80000000u);
  GLdouble base = 0;
  gl.GetDoublev(GL_LIST_BASE, &base);
  CHECK(base == 2147483648.0);
}
