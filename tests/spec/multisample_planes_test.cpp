// Framebuffer objects of four samples that lack the plane of colors (GL_EXT_framebuffer_object, 4.4.4).
#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

constexpr int kSide = 150; // several tiles

GLuint attach(const Gl& gl, GLenum attachment, GLenum format, int samples) {
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, kSide, kSide);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
  return name;
}

GLuint bind_framebuffer(const Gl& gl) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  gl.BindFramebuffer(GL_FRAMEBUFFER, name);
  return name;
}

/// Triangles of all sizes, and points and lines, near and far.
void draw(const Gl& gl) {
  const auto corner = [&](int i, int k) {
    const float a = 2.4f * float(i) + 2.1f * float(k), r = (i % 7 ? 0.02f : 0.4f) * float(1 + i % 5);
    gl.Color4f(float(k & 1), float(i % 3) / 2, 0.5f, 0.5f);
    gl.Vertex3f(std::cos(float(i) * 1.7f) * 0.9f + r * std::cos(a),
                std::sin(float(i) * 2.3f) * 0.9f + r * std::sin(a), std::sin(float(i + k)) * 0.9f);
  };
  for (const GLenum mode : {GL_TRIANGLES, GL_LINES, GL_POINTS}) {
    gl.Begin(mode);
    for (int i = 0; i < 600; ++i)
      for (int k = 0; k < (mode == GL_TRIANGLES ? 3 : mode == GL_LINES ? 2 : 1); ++k) corner(i, k);
    gl.End();
  }
}

std::vector<GLuint> depths(const Gl& gl, bool color, GLenum depth_format) {
  const CurrentContext current{gl};
  const GLuint target = bind_framebuffer(gl);
  attach(gl, GL_DEPTH_ATTACHMENT, depth_format, 0);
  const GLuint drawn = bind_framebuffer(gl);
  attach(gl, GL_DEPTH_ATTACHMENT, depth_format, 4);
  if (color) attach(gl, GL_COLOR_ATTACHMENT0, GL_RGBA8, 4);
  for (const GLuint framebuffer : {target, drawn}) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (framebuffer == drawn && color) continue;
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
  }
  REQUIRE(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  gl.Viewport(0, 0, kSide, kSide);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  for (int frame = 0; frame < 3; ++frame) {
    draw(gl);
    gl.Finish();
  }
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
  gl.BlitFramebuffer(0, 0, kSide, kSide, 0, 0, kSide, kSide, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, target);
  std::vector<GLuint> depth(size_t(kSide) * kSide);
  gl.ReadPixels(0, 0, kSide, kSide, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth.data());
  CHECK(gl.GetError() == GL_NO_ERROR);
  return depth;
}

} // namespace

TEST_CASE("Depths of samples are the same without colors", "[spec][multisample]") {
  const auto format =
      GENERATE(GLenum(GL_DEPTH_COMPONENT24), GLenum(GL_DEPTH_COMPONENT16), GLenum(GL_DEPTH_COMPONENT32F));
  const std::vector<GLuint> with = depths(softgl_library(), true, format);
  CHECK((depths(softgl_library(), false, format) == with)); // 22,500 numbers are not printed
}
