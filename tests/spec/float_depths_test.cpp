// Depth buffers and textures of floats (GL_ARB_depth_buffer_float).
#include <catch2/catch.hpp>

#include <cstring>
#include <vector>

#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

/// A framebuffer object of 8x8 pixels with a renderbuffer of depths, bound.
GLuint make_target(const Gl& gl, GLenum format, GLenum attachment) {
  GLuint framebuffer = 0, names[2] = {};
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.GenRenderbuffers(2, names);
  gl.BindRenderbuffer(GL_RENDERBUFFER, names[0]);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 8, 8);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[0]);
  gl.BindRenderbuffer(GL_RENDERBUFFER, names[1]);
  gl.RenderbufferStorage(GL_RENDERBUFFER, format, 8, 8);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, names[1]);
  gl.Viewport(0, 0, 8, 8);
  return framebuffer;
}

GLint renderbuffer_parameter(const Gl& gl, GLenum pname) {
  GLint value = -1;
  gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, pname, &value);
  return value;
}

float depth(const Gl& gl, int x, int y) {
  float value = -1;
  gl.ReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &value);
  return value;
}

struct DepthStencil {
  float depth;
  uint32_t stencil;
  bool operator==(const DepthStencil& o) const { return depth == o.depth && stencil == o.stencil; }
};

DepthStencil both(const Gl& gl, int x, int y) {
  DepthStencil value = {-1, 77};
  gl.ReadPixels(x, y, 1, 1, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, &value);
  return value;
}

void square(const Gl& gl, float z) {
  gl.Begin(GL_QUADS);
  gl.Vertex3f(-1, -1, z), gl.Vertex3f(1, -1, z), gl.Vertex3f(1, 1, z), gl.Vertex3f(-1, 1, z);
  gl.End();
}

template <class Test> void with_both_libraries(Test test) {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    const CurrentContext current{*gl};
    test(*gl);
    CHECK(gl->GetError() == GL_NO_ERROR);
  }
}

} // namespace

TEST_CASE("Buffers of float depths say what they are", "[spec][framebuffers][osmesa]") {
  with_both_libraries([](const Gl& gl) {
    make_target(gl, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
    CHECK(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    CHECK(renderbuffer_parameter(gl, GL_RENDERBUFFER_DEPTH_SIZE) == 32);
    CHECK(renderbuffer_parameter(gl, GL_RENDERBUFFER_STENCIL_SIZE) == 0);
    make_target(gl, GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
    CHECK(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    CHECK(renderbuffer_parameter(gl, GL_RENDERBUFFER_DEPTH_SIZE) == 32);
    CHECK(renderbuffer_parameter(gl, GL_RENDERBUFFER_STENCIL_SIZE) == 8);
    CHECK(renderbuffer_parameter(gl, GL_RENDERBUFFER_INTERNAL_FORMAT) == GL_DEPTH32F_STENCIL8);
    GLint type = 0, bits = 0;
    gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                           GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    gl.GetIntegerv(GL_DEPTH_BITS, &bits);
    CHECK((type == GL_FLOAT && bits == 32));
  });
}

TEST_CASE("Float depths keep their bits", "[spec][framebuffers][osmesa]") {
  with_both_libraries([](const Gl& gl) {
    make_target(gl, GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
    const float small = 1e-9f; // no integer of 24 bits can say it
    gl.ClearDepth(small);
    gl.ClearStencil(5);
    gl.Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    CHECK(both(gl, 3, 4) == DepthStencil{small, 5});
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(0, 0, 4, 8);
    gl.ClearStencil(9);
    gl.StencilMask(0x0c);
    gl.Clear(GL_STENCIL_BUFFER_BIT);
    CHECK(both(gl, 3, 4) == DepthStencil{small, 9});
    CHECK(both(gl, 4, 4) == DepthStencil{small, 5});
    gl.Disable(GL_SCISSOR_TEST);
    gl.StencilMask(255);
    // Both tests see them.
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_GREATER);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_EQUAL, 9, 255);
    gl.StencilOp(GL_KEEP, GL_INCR, GL_ZERO);
    gl.DepthRange(0.25, 1);
    square(gl, -1);
    CHECK((both(gl, 0, 0).stencil == 0 && depth(gl, 0, 0) == 0.25f));
    CHECK(both(gl, 7, 7) == DepthStencil{small, 5});
    gl.StencilFunc(GL_ALWAYS, 0, 255);
    gl.DepthRange(0, 1);
    square(gl, -1);
    CHECK((both(gl, 0, 0).stencil == 1 && both(gl, 7, 7).stencil == 6 && depth(gl, 0, 0) == 0.25f));
    // Images of both are drawn and copied as they are.
    const DepthStencil image = {0.3f, 200};
    gl.WindowPos2i(1, 1);
    gl.DrawPixels(1, 1, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, &image);
    CHECK(both(gl, 1, 1) == image);
    uint32_t word = 0;
    gl.ReadPixels(1, 1, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, &word);
    CHECK(word == (uint32_t(0.3f * 16777215.0f) << 8 | 200));
  });
}

TEST_CASE("Depth textures keep floats of [0, 1]", "[spec][framebuffers][osmesa]") {
  with_both_libraries([](const Gl& gl) {
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    const float depths[4] = {-1, 1e-9f, 0.7f, 2};
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, 2, 2, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    float back[4] = {};
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, back);
    CHECK((back[0] == 0 && back[1] == 1e-9f && back[2] == 0.7f && back[3] == 1));
    GLint bits = 0;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_DEPTH_SIZE, &bits);
    CHECK(bits == 32);
    DepthStencil texels[4] = {{0, 1}, {1e-9f, 255}, {0.7f, 17}, {1, 0}}, read[4] = {};
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH32F_STENCIL8, 2, 2, 0, GL_DEPTH_STENCIL,
                  GL_FLOAT_32_UNSIGNED_INT_24_8_REV, texels);
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, read);
    CHECK(std::memcmp(texels, read, sizeof read) == 0);
    // Drawn to and read again: they pass through the plane of a framebuffer object.
    make_target(gl, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    CHECK(both(gl, 1, 0) == texels[1]);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(0, 1, 1, 1);
    gl.ClearDepth(0.25);
    gl.ClearStencil(3);
    gl.Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    texels[2] = {0.25f, 3};
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, read);
    CHECK(std::memcmp(texels, read, sizeof read) == 0);
  });
}

TEST_CASE("Float depths are not blitted to integers", "[spec][framebuffers][osmesa]") {
  with_both_libraries([](const Gl& gl) {
    const GLuint floats = make_target(gl, GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
    gl.ClearDepth(1e-9);
    gl.ClearStencil(40);
    gl.Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    make_target(gl, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, floats);
    for (GLbitfield mask : {GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT}) {
      gl.BlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, mask, GL_NEAREST);
      CHECK(gl.GetError() == GL_INVALID_OPERATION);
    }
    const GLuint others = make_target(gl, GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, floats);
    gl.BlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, others);
    CHECK(both(gl, 6, 6) == DepthStencil{1e-9f, 40});
  });
}

TEST_CASE("The type of a float and a stencil value belongs to GL_DEPTH_STENCIL", "[spec][framebuffers]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  make_target(gl, GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
  uint32_t pixel[2] = {};
  gl.ReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, pixel);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.ReadPixels(0, 0, 1, 1, GL_DEPTH_STENCIL, GL_FLOAT, pixel);
  CHECK(gl.GetError() == GL_INVALID_ENUM);
  gl.DrawPixels(1, 1, GL_RGBA, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, pixel);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH32F_STENCIL8, 1, 1, 0, GL_DEPTH_STENCIL, GL_FLOAT, pixel);
  CHECK(gl.GetError() == GL_INVALID_ENUM);
}
