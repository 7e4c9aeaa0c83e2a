// Framebuffer objects: renderbuffers and textures that are drawn to, sampled, changed, read, copied and
// deleted while a frame waits.
#include "faults/streams.h"

namespace softgl::test {
namespace {

void scribble(Player& p) {
  const Gl& gl = p.gl;
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 30; ++i) {
    const Float4 c = p.random.color();
    gl.Color4fv(c.data());
    const float x = p.random.real(-1, 1), y = p.random.real(-1, 1);
    gl.TexCoord2f(x, y);
    gl.Vertex2f(x, y);
  }
  gl.End();
}

void attachments(Player& p) {
  const Gl& gl = p.gl;
  GLuint framebuffer[2] = {}, renderbuffer[2] = {}, texture = 0;
  gl.GenFramebuffers(2, framebuffer);
  gl.GenRenderbuffers(2, renderbuffer);
  gl.GenTextures(1, &texture);
  p.check();
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 90, 70, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  p.check();
  const GLenum format[2] = {GL_RGBA16, GL_DEPTH24_STENCIL8};
  for (int i = 0; i < 2; ++i) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer[i]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, format[i], 90, 70);
    p.check();
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer[0]);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, renderbuffer[1]);
  gl.Viewport(0, 0, 90, 70);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  p.check();
  scribble(p);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer[1]);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer[0]);
  p.check();
  gl.Enable(GL_TEXTURE_2D);
  scribble(p);
  p.check();
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer[0]);
  gl.BlitFramebuffer(0, 0, 40, 40, 20, 20, 70, 60, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  scribble(p); // samples what it draws to
  p.check();
  const GLuint texel = 0xff00ff00;
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &texel);
  gl.GenerateMipmap(GL_TEXTURE_2D);
  p.check();
  scribble(p);
  gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 30, 30);
  p.check();
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Viewport(0, 0, 64, 64);
  scribble(p);
  gl.DeleteTextures(1, &texture);
  gl.DeleteRenderbuffers(2, renderbuffer);
  gl.DeleteFramebuffers(2, framebuffer);
  gl.Disable(GL_TEXTURE_2D);
  p.check();
  p.picture();
}

/// Four samples a pixel, copied to others, and resolved.
void samples(Player& p) {
  const Gl& gl = p.gl;
  GLuint framebuffer[3] = {}, renderbuffer[6] = {};
  gl.GenFramebuffers(3, framebuffer);
  gl.GenRenderbuffers(6, renderbuffer);
  p.check();
  for (int i = 0; i < 3; ++i) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer[i]);
    for (int k = 0; k < 2; ++k) {
      const GLuint name = renderbuffer[2 * i + k];
      gl.BindRenderbuffer(GL_RENDERBUFFER, name);
      gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, i < 2 ? 4 : 0, k ? GL_DEPTH24_STENCIL8 : GL_RGBA8,
                                        90, 70);
      p.check();
      gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, k ? GL_DEPTH_STENCIL_ATTACHMENT : GL_COLOR_ATTACHMENT0,
                                 GL_RENDERBUFFER, name);
    }
  }
  gl.Viewport(0, 0, 90, 70);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer[0]);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  scribble(p);
  p.check();
  const GLbitfield all = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
  for (int i = 1; i < 3; ++i) {
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer[i]);
    gl.BlitFramebuffer(0, 0, 90, 70, 0, 0, 90, 70, all, GL_NEAREST);
    p.check();
    scribble(p);
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Viewport(0, 0, 64, 64);
  gl.DeleteRenderbuffers(6, renderbuffer);
  gl.DeleteFramebuffers(3, framebuffer);
  p.check();
  p.picture();
}

} // namespace

const std::vector<Stream>& framebuffer_streams() {
  static const std::vector<Stream> streams = {{"framebuffers.attachments", attachments},
                                              {"framebuffers.samples", samples}};
  return streams;
}

} // namespace softgl::test
