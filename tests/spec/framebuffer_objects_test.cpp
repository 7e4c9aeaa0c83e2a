// GL_ARB_framebuffer_object and GL_EXT_framebuffer_object: names, completeness, errors, what draws and copies
// do to attached images.
#include <catch2/catch.hpp>

#include <cstring>
#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

GLuint make_framebuffer(const Gl& gl) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  gl.BindFramebuffer(GL_FRAMEBUFFER, name);
  return name;
}

GLuint make_renderbuffer(const Gl& gl, GLenum format, int width, int height) {
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  gl.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  return name;
}

void attach(const Gl& gl, GLenum attachment, GLuint renderbuffer) {
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

GLuint make_texture(const Gl& gl, GLint format, int width, int height, const void* texels = nullptr) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  return name;
}

uint32_t pixel(const Gl& gl, int x, int y) {
  uint32_t word = 0x12345678;
  gl.ReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &word);
  return word;
}

void clear(const Gl& gl, float red, float green, float blue, float alpha) {
  gl.ClearColor(red, green, blue, alpha);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

constexpr uint32_t kRed = 0xff0000ff, kGreen = 0xff00ff00, kBlue = 0xffff0000;

GLint get(const Gl& gl, GLenum pname) {
  GLint value = -1;
  gl.GetIntegerv(pname, &value);
  return value;
}

GLenum status(const Gl& gl) { return gl.CheckFramebufferStatus(GL_FRAMEBUFFER); }

} // namespace

TEST_CASE("Names of framebuffer objects and renderbuffers become objects when they are bound",
          "[spec][framebuffers]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  GLuint framebuffer = 0, renderbuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.GenRenderbuffers(1, &renderbuffer);
  CHECK((!gl.IsFramebuffer(framebuffer) && !gl.IsRenderbuffer(renderbuffer)));
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  CHECK((gl.IsFramebuffer(framebuffer) && gl.IsRenderbuffer(renderbuffer)));
  CHECK((get(gl, GL_READ_FRAMEBUFFER_BINDING) == GLint(framebuffer) &&
         get(gl, GL_DRAW_FRAMEBUFFER_BINDING) == 0));
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  CHECK((get(gl, GL_FRAMEBUFFER_BINDING) == GLint(framebuffer)));
  CHECK((get(gl, GL_DRAW_BUFFER) == GL_COLOR_ATTACHMENT0 && get(gl, GL_READ_BUFFER) == GL_COLOR_ATTACHMENT0));
  // Only GL_EXT_framebuffer_object binds names that nobody has generated.
  gl.BindFramebuffer(GL_FRAMEBUFFER, 77);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.BindRenderbuffer(GL_RENDERBUFFER, 78);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.BindFramebufferEXT(GL_FRAMEBUFFER, 77);
  gl.BindRenderbufferEXT(GL_RENDERBUFFER, 78);
  CHECK((gl.GetError() == GL_NO_ERROR && gl.IsFramebuffer(77) && gl.IsRenderbuffer(78)));
  const GLuint both[2] = {77, framebuffer};
  gl.DeleteFramebuffers(2, both);
  CHECK((get(gl, GL_FRAMEBUFFER_BINDING) == 0 && get(gl, GL_READ_FRAMEBUFFER_BINDING) == 0));
  CHECK(get(gl, GL_DRAW_BUFFER) == GL_FRONT);
  const GLuint name = 78;
  gl.DeleteRenderbuffers(1, &name);
  CHECK((get(gl, GL_RENDERBUFFER_BINDING) == 0 && !gl.IsRenderbuffer(78)));
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("Each rule of completeness is checked", "[spec][framebuffers]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  CHECK(status(gl) == GL_FRAMEBUFFER_COMPLETE); // the window
  make_framebuffer(gl);
  CHECK(status(gl) == GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
  const GLuint color = make_renderbuffer(gl, GL_RGBA8, 8, 8),
               depth = make_renderbuffer(gl, GL_DEPTH_COMPONENT16, 8, 8),
               both = make_renderbuffer(gl, GL_DEPTH24_STENCIL8, 8, 8),
               stencil = make_renderbuffer(gl, GL_STENCIL_INDEX8, 8, 8),
               empty = make_renderbuffer(gl, GL_RGBA8, 0, 8);
  attach(gl, GL_COLOR_ATTACHMENT0, empty);
  CHECK(status(gl) == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  attach(gl, GL_COLOR_ATTACHMENT0, depth);
  CHECK(status(gl) == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  attach(gl, GL_COLOR_ATTACHMENT0, color);
  CHECK(status(gl) == GL_FRAMEBUFFER_COMPLETE);
  for (GLuint wrong : {color, stencil}) {
    attach(gl, GL_DEPTH_ATTACHMENT, wrong);
    CHECK(status(gl) == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  }
  attach(gl, GL_DEPTH_ATTACHMENT, depth);
  CHECK(status(gl) == GL_FRAMEBUFFER_COMPLETE);
  attach(gl, GL_STENCIL_ATTACHMENT, depth);
  CHECK(status(gl) == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  attach(gl, GL_STENCIL_ATTACHMENT, both); // two planes
  CHECK(status(gl) == GL_FRAMEBUFFER_UNSUPPORTED);
  attach(gl, GL_DEPTH_STENCIL_ATTACHMENT, both);
  CHECK(status(gl) == GL_FRAMEBUFFER_COMPLETE);
  attach(gl, GL_DEPTH_ATTACHMENT, 0);
  attach(gl, GL_STENCIL_ATTACHMENT, stencil);
  CHECK((status(gl) == GL_FRAMEBUFFER_COMPLETE && get(gl, GL_STENCIL_BITS) == 8 &&
         get(gl, GL_DEPTH_BITS) == 0));
  // Images of textures: missing levels, slices that are not there, formats that cannot be drawn to.
  const GLuint texture = make_texture(gl, GL_RGBA8, 8, 8), shared = make_texture(gl, GL_RGB9_E5, 8, 8);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 1);
  CHECK(status(gl) == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  CHECK(status(gl) == GL_FRAMEBUFFER_COMPLETE);
  gl.BindTexture(GL_TEXTURE_2D, texture); // another image in its place
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 8, 8, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                nullptr);
  CHECK(status(gl) == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, shared, 0);
  CHECK(status(gl) == GL_FRAMEBUFFER_UNSUPPORTED);
  GLuint volume = 0;
  gl.GenTextures(1, &volume);
  gl.BindTexture(GL_TEXTURE_3D, volume);
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 8, 8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.FramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, volume, 0, 3);
  CHECK(status(gl) == GL_FRAMEBUFFER_COMPLETE);
  gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, volume, 0, 4);
  CHECK(status(gl) == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("Draw and read buffers name color attachments", "[spec][framebuffers]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  make_framebuffer(gl);
  attach(gl, GL_COLOR_ATTACHMENT3, make_renderbuffer(gl, GL_RGBA8, 8, 8));
  CHECK(status(gl) == GL_FRAMEBUFFER_COMPLETE);
  gl.DrawBuffer(GL_COLOR_ATTACHMENT3);
  gl.ReadBuffer(GL_COLOR_ATTACHMENT3);
  CHECK(status(gl) == GL_FRAMEBUFFER_COMPLETE);
  attach(gl, GL_COLOR_ATTACHMENT0, make_renderbuffer(gl, GL_RGBA8, 8, 8));
  clear(gl, 0, 0, 1, 1);
  gl.DrawBuffer(GL_COLOR_ATTACHMENT0);
  clear(gl, 1, 0, 0, 1);
  gl.DrawBuffer(GL_NONE);
  clear(gl, 0, 1, 0, 1);
  CHECK(pixel(gl, 1, 1) == kBlue);
  gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
  CHECK(pixel(gl, 1, 1) == kRed);
  gl.ReadBuffer(GL_NONE);
  pixel(gl, 1, 1);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  for (GLenum absent : {GL_FRONT, GL_BACK, GL_AUX0, GL_COLOR_ATTACHMENT8}) {
    gl.DrawBuffer(absent);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    gl.ReadBuffer(absent);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
  }
  gl.DrawBuffer(GL_RGBA);
  CHECK(gl.GetError() == GL_INVALID_ENUM);
  CHECK((get(gl, GL_DRAW_BUFFER) == GL_NONE && get(gl, GL_READ_BUFFER) == GL_NONE));
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  CHECK((get(gl, GL_DRAW_BUFFER) == GL_FRONT && get(gl, GL_READ_BUFFER) == GL_FRONT));
  gl.DrawBuffer(GL_COLOR_ATTACHMENT0);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
}

namespace {

GLint values[4];
GLuint words[16];
GLubyte bytes[64];
GLuint texture_2d, texture_3d, a_renderbuffer;

const BadCall bad_calls[] = {
    BAD(INVALID_VALUE, GenFramebuffers(-1, words)),
    BAD(INVALID_VALUE, DeleteFramebuffers(-1, words)),
    BAD(INVALID_VALUE, GenRenderbuffers(-1, words)),
    BAD(INVALID_VALUE, DeleteRenderbuffers(-1, words)),
    BAD(INVALID_ENUM, BindFramebuffer(GL_RENDERBUFFER, 0)),
    BAD(INVALID_ENUM, BindRenderbuffer(GL_FRAMEBUFFER, 0)),
    BAD(INVALID_ENUM, CheckFramebufferStatus(GL_RENDERBUFFER)),
    BAD(INVALID_ENUM, RenderbufferStorage(GL_FRAMEBUFFER, GL_RGBA8, 4, 4)),
    BAD(INVALID_ENUM, RenderbufferStorage(GL_RENDERBUFFER, GL_UNSIGNED_BYTE, 4, 4)),
    BAD(INVALID_ENUM, RenderbufferStorage(GL_RENDERBUFFER, 4, 4, 4)),
    BAD(INVALID_VALUE, RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, -1, 4)),
    BAD(INVALID_VALUE, RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 4, 16385)),
    BAD(INVALID_VALUE, RenderbufferStorageMultisample(GL_RENDERBUFFER, 5, GL_RGBA8, 4, 4)),
    BAD(INVALID_VALUE, RenderbufferStorageMultisample(GL_RENDERBUFFER, -1, GL_RGBA8, 4, 4)),
    BAD(INVALID_ENUM, GetRenderbufferParameteriv(GL_FRAMEBUFFER, GL_RENDERBUFFER_WIDTH, values)),
    BAD(INVALID_ENUM, GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_TEXTURE_WIDTH, values)),
    BAD(INVALID_ENUM, FramebufferRenderbuffer(GL_TEXTURE_2D, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 0)),
    BAD(INVALID_ENUM, FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_FRONT, GL_RENDERBUFFER, 0)),
    BAD(INVALID_ENUM, FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT8, GL_RENDERBUFFER, 0)),
    BAD(INVALID_ENUM,
        FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, a_renderbuffer)),
    BAD(INVALID_OPERATION,
        FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 999)),
    BAD(INVALID_OPERATION, FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 999, 0)),
    BAD(INVALID_OPERATION,
        FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_3d, 0)),
    BAD(INVALID_OPERATION,
        FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_1D, texture_2d, 0)),
    BAD(INVALID_OPERATION, FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                                GL_TEXTURE_CUBE_MAP_POSITIVE_X, texture_2d, 0)),
    BAD(INVALID_OPERATION,
        FramebufferTexture1D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_1D, texture_2d, 0)),
    BAD(INVALID_OPERATION,
        FramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, texture_2d, 0, 0)),
    BAD(INVALID_OPERATION, FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture_2d, 0, 0)),
    BAD(INVALID_ENUM, FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RGBA, texture_2d, 0)),
    BAD(INVALID_VALUE,
        FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_2d, -1)),
    BAD(INVALID_VALUE,
        FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_2d, 15)),
    BAD(INVALID_VALUE,
        FramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, texture_3d, 0, 2048)),
    BAD(INVALID_VALUE, FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture_3d, 0, -1)),
    BAD(INVALID_ENUM, GetFramebufferAttachmentParameteriv(GL_RENDERBUFFER, GL_COLOR_ATTACHMENT0,
                                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, values)),
    BAD(INVALID_ENUM, GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_FRONT_LEFT,
                                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, values)),
    BAD(INVALID_OPERATION, GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1,
                                                               GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, values)),
    BAD(INVALID_ENUM, GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                                          GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL, values)),
    BAD(INVALID_OPERATION,
        GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT,
                                            GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, values)),
    BAD(INVALID_ENUM, GenerateMipmap(GL_TEXTURE_RECTANGLE)),
    BAD(INVALID_OPERATION, GenerateMipmap(GL_TEXTURE_CUBE_MAP)),
    BAD(INVALID_VALUE, BlitFramebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_ACCUM_BUFFER_BIT, GL_NEAREST)),
    BAD(INVALID_ENUM, BlitFramebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_LINEAR_MIPMAP_LINEAR)),
    BAD(INVALID_OPERATION, BlitFramebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_DEPTH_BUFFER_BIT, GL_LINEAR)),
    BAD(INVALID_ENUM, ReadPixels(0, 0, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT, bytes)),
    BAD(INVALID_OPERATION, ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_INT_24_8, bytes)),
    BAD(INVALID_OPERATION, ReadPixels(0, 0, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, bytes)),
    BAD(INVALID_OPERATION, DrawPixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, bytes)),
    BAD(INVALID_OPERATION, CopyPixels(0, 0, 1, 1, GL_DEPTH_STENCIL)),
    BAD(INVALID_OPERATION, TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 1, 1, 0, GL_DEPTH_COMPONENT,
                                      GL_UNSIGNED_INT, bytes)),
    BAD(INVALID_OPERATION,
        TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, bytes)),
};

} // namespace

REFUSAL_TEST_CASE("Wrong arguments of framebuffer objects change nothing", "[spec][framebuffers]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  make_framebuffer(gl);
  a_renderbuffer = make_renderbuffer(gl, GL_RGBA8, 8, 8);
  attach(gl, GL_COLOR_ATTACHMENT0, a_renderbuffer);
  attach(gl, GL_DEPTH_ATTACHMENT, make_renderbuffer(gl, GL_DEPTH_COMPONENT24, 8, 8));
  texture_2d = make_texture(gl, GL_RGBA8, 4, 4);
  gl.GenTextures(1, &texture_3d);
  gl.BindTexture(GL_TEXTURE_3D, texture_3d);
  clear(gl, 1, 0, 0, 1);
  const StateSnapshot before = take_snapshot(gl, false);
  expect_refused(gl, bad_calls, [&] {
    CHECK(compare_snapshots(before, take_snapshot(gl, false)).empty());
    CHECK((status(gl) == GL_FRAMEBUFFER_COMPLETE && pixel(gl, 2, 2) == kRed));
  });
  gl.Begin(GL_POINTS);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  gl.BlitFramebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.End();
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  CHECK(get(gl, GL_FRAMEBUFFER_BINDING) != 0);
  // Nothing is bound.
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.BindRenderbuffer(GL_RENDERBUFFER, 0);
  static const BadCall unbound[] = {
      BAD(INVALID_OPERATION, RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 4, 4)),
      BAD(INVALID_OPERATION, GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, values)),
      BAD(INVALID_OPERATION,
          FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 0)),
      BAD(INVALID_OPERATION, FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0)),
  };
  expect_refused(gl, unbound, [] {});
}

REFUSAL_TEST_CASE("An incomplete framebuffer object is neither drawn to nor read", "[spec][framebuffers]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  clear(gl, 0, 1, 0, 1);
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  gl.Rectf(-1, -1, 1, 1);
  gl.EndList();
  make_framebuffer(gl);
  static const BadCall calls[] = {
      BAD(INVALID_FRAMEBUFFER_OPERATION, Begin(GL_POINTS)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, Rectf(-1, -1, 1, 1)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, CallList(1)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, Clear(GL_COLOR_BUFFER_BIT)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, RasterPos2f(0, 0)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, Bitmap(1, 1, 0, 0, 0, 0, bytes)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, CopyPixels(0, 0, 1, 1, GL_COLOR)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 1, 1, 0)),
      BAD(INVALID_FRAMEBUFFER_OPERATION,
          BlitFramebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_NEAREST)),
  };
  REQUIRE(list == 1);
  expect_refused(gl, calls, [] {});
  const GLfloat corners[] = {-1, -1, 1, -1, 1, 1};
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(2, GL_FLOAT, 0, corners);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  CHECK(gl.GetError() == GL_INVALID_FRAMEBUFFER_OPERATION);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  CHECK(pixel(gl, 5, 5) == kGreen);
}

TEST_CASE("A deleted image is detached from what is bound alone", "[spec][framebuffers]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  const GLuint renderbuffer = make_renderbuffer(gl, GL_RGBA8, 8, 8),
               texture = make_texture(gl, GL_RGBA8, 8, 8);
  const GLuint first = make_framebuffer(gl);
  attach(gl, GL_COLOR_ATTACHMENT0, renderbuffer);
  clear(gl, 1, 0, 0, 1);
  make_framebuffer(gl);
  attach(gl, GL_COLOR_ATTACHMENT0, renderbuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, texture, 0);
  gl.DeleteRenderbuffers(1, &renderbuffer);
  gl.DeleteTextures(1, &texture);
  GLint type = -1;
  for (GLenum attachment : {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1}) {
    gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE,
                                           &type);
    CHECK(type == GL_NONE);
  }
  CHECK(status(gl) == GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
  gl.BindFramebuffer(GL_FRAMEBUFFER, first);
  CHECK((status(gl) == GL_FRAMEBUFFER_COMPLETE && pixel(gl, 3, 3) == kRed));
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("glPopAttrib sets draw and read buffer in what is bound", "[spec][framebuffers][osmesa]") {
  for (const Gl* library : {&softgl_library(), &osmesa_library()}) {
    const Gl& gl = *library;
    const CurrentContext current{gl};
    make_framebuffer(gl);
    attach(gl, GL_COLOR_ATTACHMENT0, make_renderbuffer(gl, GL_RGBA8, 8, 8));
    gl.DrawBuffer(GL_COLOR_ATTACHMENT3);
    gl.ReadBuffer(GL_COLOR_ATTACHMENT2);
    gl.PushAttrib(GL_COLOR_BUFFER_BIT | GL_PIXEL_MODE_BIT);
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
    gl.PopAttrib();
    CHECK(
        (get(gl, GL_DRAW_BUFFER) == GL_COLOR_ATTACHMENT3 && get(gl, GL_READ_BUFFER) == GL_COLOR_ATTACHMENT2));
    CHECK(gl.GetError() == GL_NO_ERROR);
    // The buffers of the one are not those of the other.
    gl.PushAttrib(GL_COLOR_BUFFER_BIT | GL_PIXEL_MODE_BIT);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.PopAttrib();
    CHECK(gl.GetError() == GL_NO_ERROR);
    CHECK((get(gl, GL_DRAW_BUFFER) == GL_FRONT && get(gl, GL_READ_BUFFER) == GL_FRONT));
  }
}

TEST_CASE("The back buffer of a window with one buffer is its front buffer", "[spec][framebuffers][osmesa]") {
  for (const Gl* library : {&softgl_library(), &osmesa_library()}) {
    const Gl& gl = *library;
    const CurrentContext current{gl};
    const auto parameter = [&](GLenum attachment, GLenum pname) {
      GLint value = -1;
      gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, attachment, pname, &value);
      return value;
    };
    CHECK(parameter(GL_BACK_LEFT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_FRAMEBUFFER_DEFAULT);
    CHECK(parameter(GL_BACK_LEFT, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) == 8);
    CHECK(parameter(GL_FRONT_RIGHT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE);
    CHECK(gl.GetError() == GL_NO_ERROR);
  }
}
