// Framebuffer objects of 8x8 pixels that draw to a texture.
#pragma once

#include "support/gl.h"

namespace softgl::test {

inline GLuint bound_framebuffer(const Gl& gl) {
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.Viewport(0, 0, 8, 8);
  return framebuffer;
}

inline GLuint attach_texture(const Gl& gl, GLint format) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, format, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  return texture;
}

/// Draws the color everywhere.
inline void fill(const Gl& gl, float r, float g, float b, float a) {
  gl.Color4f(r, g, b, a);
  gl.Begin(GL_TRIANGLE_STRIP);
  gl.Vertex2f(-1, -1), gl.Vertex2f(1, -1), gl.Vertex2f(-1, 1), gl.Vertex2f(1, 1);
  gl.End();
}

} // namespace softgl::test
