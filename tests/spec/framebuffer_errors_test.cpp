// The errors that GL_ARB_framebuffer_object and its relatives name. Each is raised by a call that is wrong in
// nothing else, and changes nothing.
#include <catch2/catch.hpp>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

unsigned char bytes[4096];
GLuint names[4];
GLint numbers[16];
constexpr GLenum kColor = GL_COLOR_ATTACHMENT0;
GLuint framebuffer, renderbuffer, texture, cube, volume;

// A framebuffer object is bound, with a renderbuffer of 16 x 16 as its color; textures are there.
void make_objects(const Gl& gl) {
  gl.GenFramebuffers(1, &framebuffer);
  gl.GenRenderbuffers(1, &renderbuffer);
  for (GLuint* name : {&texture, &cube, &volume}) gl.GenTextures(1, name);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube);
  gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.BindTexture(GL_TEXTURE_3D, volume);
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 16, 16, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 16, 16);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, kColor, GL_RENDERBUFFER, renderbuffer);
  REQUIRE(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

} // namespace

REFUSAL_TEST_CASE("framebuffer objects and renderbuffers refuse what is wrong in one argument",
                  "[spec][errors]") { // 4.4.1, 4.4.2
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  make_objects(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, BindFramebuffer(GL_RENDERBUFFER, 0)),
      BAD(INVALID_OPERATION, BindFramebuffer(GL_FRAMEBUFFER, 77)),
      BAD(INVALID_OPERATION, BindFramebuffer(GL_READ_FRAMEBUFFER, 77)),
      BAD(INVALID_ENUM, BindFramebufferEXT(GL_TEXTURE_2D, 0)),
      BAD(INVALID_VALUE, GenFramebuffers(-1, names)),
      BAD(INVALID_VALUE, DeleteFramebuffers(-1, names)),
      BAD(INVALID_ENUM, BindRenderbuffer(GL_FRAMEBUFFER, 0)),
      BAD(INVALID_OPERATION, BindRenderbuffer(GL_RENDERBUFFER, 77)),
      BAD(INVALID_ENUM, BindRenderbufferEXT(GL_TEXTURE_2D, 0)),
      BAD(INVALID_VALUE, GenRenderbuffers(-1, names)),
      BAD(INVALID_VALUE, DeleteRenderbuffers(-1, names)),
      BAD(INVALID_ENUM, RenderbufferStorage(GL_FRAMEBUFFER, GL_RGBA8, 4, 4)),
      BAD(INVALID_ENUM, RenderbufferStorage(GL_RENDERBUFFER, GL_FLOAT, 4, 4)),
      BAD(INVALID_ENUM, RenderbufferStorage(GL_RENDERBUFFER, 4, 4, 4)),
      BAD(INVALID_VALUE, RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, -1, 4)),
      BAD(INVALID_VALUE, RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 4, 16385)),
      BAD(INVALID_ENUM, RenderbufferStorageMultisample(0, 0, GL_RGBA8, 4, 4)),
      BAD(INVALID_ENUM, RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_BLEND, 4, 4)),
      BAD(INVALID_VALUE, RenderbufferStorageMultisample(GL_RENDERBUFFER, -1, GL_RGBA8, 4, 4)),
      BAD(INVALID_VALUE, RenderbufferStorageMultisample(GL_RENDERBUFFER, 5, GL_RGBA8, 4, 4)),
      BAD(INVALID_VALUE, RenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, 4, -1)),
      BAD(INVALID_ENUM, GetRenderbufferParameteriv(GL_FRAMEBUFFER, GL_RENDERBUFFER_WIDTH, numbers)),
      BAD(INVALID_ENUM, GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_TEXTURE_WIDTH, numbers)),
      BAD(INVALID_ENUM, CheckFramebufferStatus(GL_RENDERBUFFER)),
  };
  expect_refused(gl, calls);
  gl.BindRenderbuffer(GL_RENDERBUFFER, 0);
  static const BadCall without[] = {
      BAD(INVALID_OPERATION, RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 4, 4)),
      BAD(INVALID_OPERATION, RenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, 4, 4)),
      BAD(INVALID_OPERATION, GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, numbers)),
  };
  expect_refused(gl, without);
}

REFUSAL_TEST_CASE("attachments refuse what is wrong in one argument", "[spec][errors]") { // 4.4.2, 6.1.3
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  make_objects(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, FramebufferRenderbuffer(GL_RENDERBUFFER, kColor, GL_RENDERBUFFER, renderbuffer)),
      BAD(INVALID_ENUM, FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR, GL_RENDERBUFFER, renderbuffer)),
      BAD(INVALID_ENUM, FramebufferRenderbuffer(GL_FRAMEBUFFER, kColor, GL_FRAMEBUFFER, renderbuffer)),
      BAD(INVALID_OPERATION, FramebufferRenderbuffer(GL_FRAMEBUFFER, kColor, GL_RENDERBUFFER, 77)),
      BAD(INVALID_ENUM, FramebufferTexture1D(GL_TEXTURE_1D, kColor, GL_TEXTURE_1D, 0, 0)),
      BAD(INVALID_OPERATION, FramebufferTexture1D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_1D, texture, 0)),
      BAD(INVALID_OPERATION, FramebufferTexture1D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_1D, 77, 0)),
      BAD(INVALID_ENUM, FramebufferTexture2D(0, kColor, GL_TEXTURE_2D, texture, 0)),
      BAD(INVALID_ENUM, FramebufferTexture2D(GL_FRAMEBUFFER, GL_BACK, GL_TEXTURE_2D, texture, 0)),
      BAD(INVALID_OPERATION, FramebufferTexture2D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_2D, 77, 0)),
      BAD(INVALID_OPERATION, FramebufferTexture2D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_2D, cube, 0)),
      BAD(INVALID_OPERATION,
          FramebufferTexture2D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_CUBE_MAP_POSITIVE_X, texture, 0)),
      BAD(INVALID_OPERATION, FramebufferTexture2D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_RECTANGLE, texture, 0)),
      BAD(INVALID_VALUE, FramebufferTexture2D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_2D, texture, -1)),
      BAD(INVALID_VALUE, FramebufferTexture2D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_2D, texture, 15)),
      BAD(INVALID_ENUM, FramebufferTexture3D(GL_RENDERBUFFER, kColor, GL_TEXTURE_3D, volume, 0, 0)),
      BAD(INVALID_OPERATION, FramebufferTexture3D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_3D, texture, 0, 0)),
      BAD(INVALID_VALUE, FramebufferTexture3D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_3D, volume, 12, 0)),
      BAD(INVALID_VALUE, FramebufferTexture3D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_3D, volume, 0, -1)),
      BAD(INVALID_VALUE, FramebufferTexture3D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_3D, volume, 0, 2048)),
      BAD(INVALID_ENUM, FramebufferTextureLayer(GL_TEXTURE_3D, kColor, volume, 0, 0)),
      BAD(INVALID_OPERATION, FramebufferTextureLayer(GL_FRAMEBUFFER, kColor, 77, 0, 0)),
      BAD(INVALID_OPERATION, FramebufferTextureLayer(GL_FRAMEBUFFER, kColor, texture, 0, 0)),
      BAD(INVALID_VALUE, FramebufferTextureLayer(GL_FRAMEBUFFER, kColor, volume, -1, 0)),
      BAD(INVALID_VALUE, FramebufferTextureLayer(GL_FRAMEBUFFER, kColor, volume, 0, -1)),
      BAD(INVALID_ENUM, GetFramebufferAttachmentParameteriv(GL_RENDERBUFFER, kColor,
                                                            GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, numbers)),
      BAD(INVALID_ENUM, GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_FRONT_AND_BACK,
                                                            GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, numbers)),
      BAD(INVALID_ENUM,
          GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, kColor, GL_RENDERBUFFER_WIDTH, numbers)),
      BAD(INVALID_ENUM, GetFramebufferAttachmentParameteriv(
                            GL_FRAMEBUFFER, kColor, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL, numbers)),
      BAD(INVALID_OPERATION, DrawBuffer(GL_FRONT)),
      BAD(INVALID_OPERATION, ReadBuffer(GL_FRONT)),
      BAD(INVALID_ENUM, GenerateMipmap(GL_TEXTURE_CUBE_MAP_POSITIVE_X)),
      BAD(INVALID_ENUM, GenerateMipmap(GL_TEXTURE_RECTANGLE)),
      BAD(INVALID_OPERATION, GenerateMipmap(GL_TEXTURE_CUBE_MAP)), // five faces are missing
  };
  expect_refused(gl, calls);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  static const BadCall window[] = {
      BAD(INVALID_OPERATION, FramebufferRenderbuffer(GL_FRAMEBUFFER, kColor, GL_RENDERBUFFER, renderbuffer)),
      BAD(INVALID_OPERATION, FramebufferTexture1D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_1D, 0, 0)),
      BAD(INVALID_OPERATION, FramebufferTexture2D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_2D, texture, 0)),
      BAD(INVALID_OPERATION, FramebufferTexture3D(GL_FRAMEBUFFER, kColor, GL_TEXTURE_3D, volume, 0, 0)),
      BAD(INVALID_OPERATION, FramebufferTextureLayer(GL_FRAMEBUFFER, kColor, volume, 0, 0)),
      BAD(INVALID_OPERATION, DrawBuffer(GL_COLOR_ATTACHMENT0)),
      BAD(INVALID_OPERATION, ReadBuffer(GL_COLOR_ATTACHMENT0)),
  };
  expect_refused(gl, window);
}

REFUSAL_TEST_CASE("blits refuse what is wrong in one argument", "[spec][errors]") { // 4.3.3
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  make_objects(gl);
  static const BadCall calls[] = {
      BAD(INVALID_VALUE, BlitFramebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_FOG_BIT, GL_NEAREST)),
      BAD(INVALID_ENUM,
          BlitFramebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST_MIPMAP_NEAREST)),
      BAD(INVALID_OPERATION, BlitFramebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_DEPTH_BUFFER_BIT, GL_LINEAR)),
      BAD(INVALID_OPERATION, BlitFramebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_STENCIL_BUFFER_BIT, GL_LINEAR)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("what is not complete is neither drawn to nor read", "[spec][errors]") { // 4.4.4.3
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  make_objects(gl);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, kColor, GL_RENDERBUFFER, 0);
  REQUIRE(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
  gl.Enable(GL_MAP1_VERTEX_3);
  gl.Enable(GL_MAP2_VERTEX_3);
  static const GLsizei counts[2] = {1, 1};
  static const GLint firsts[2] = {0, 0}, bases[2] = {0, 0};
  static const void* const indices[2] = {bytes, bytes};
  static const BadCall calls[] = {
      BAD(INVALID_FRAMEBUFFER_OPERATION, Begin(GL_POINTS)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, Rectf(0, 0, 1, 1)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, DrawArrays(GL_POINTS, 0, 1)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, DrawElements(GL_POINTS, 1, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, DrawRangeElements(GL_POINTS, 0, 1, 1, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, MultiDrawArrays(GL_POINTS, firsts, counts, 2)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, MultiDrawElements(GL_POINTS, counts, GL_UNSIGNED_BYTE, indices, 2)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, DrawElementsBaseVertex(GL_POINTS, 1, GL_UNSIGNED_BYTE, bytes, 0)),
      BAD(INVALID_FRAMEBUFFER_OPERATION,
          DrawRangeElementsBaseVertex(GL_POINTS, 0, 1, 1, GL_UNSIGNED_BYTE, bytes, 0)),
      BAD(INVALID_FRAMEBUFFER_OPERATION,
          MultiDrawElementsBaseVertex(GL_POINTS, counts, GL_UNSIGNED_BYTE, indices, 2, bases)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, RasterPos2f(0, 0)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, WindowPos2f(0, 0)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, CopyPixels(0, 0, 1, 1, GL_COLOR)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, Bitmap(1, 1, 0, 0, 1, 1, bytes)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, Clear(GL_COLOR_BUFFER_BIT)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, EvalMesh1(GL_POINT, 0, 1)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, EvalMesh2(GL_FILL, 0, 1, 0, 1)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 4, 4)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, CopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 0, 0, 4, 0)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, CopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 0, 0, 4, 4)),
      BAD(INVALID_FRAMEBUFFER_OPERATION,
          BlitFramebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST)),
  };
  expect_refused(gl, calls);
}
