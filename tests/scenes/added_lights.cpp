// Lights that are added one by one to what the first has drawn, under an alpha test: fragments of equal
// depth, and among them nearer ones, which hide those that come later in the same draw. On the right with
// four samples a pixel.
#include <cmath>

#include "scenes/shapes.h"

namespace softgl::test {
namespace {

// A hill of n by n cells, `nearer` than the first one.
void hill(const Gl& gl, int n, float nearer, float light) {
  const auto vertex = [&](int x, int y) {
    const float u = float(x) / float(n), v = float(y) / float(n);
    gl.Color4f(light * u, light * v, light * (1 - u), 0.5f + 0.5f * std::sin(9 * u + 7 * v + light));
    gl.Vertex3f(1.8f * u - 0.9f, 1.8f * v - 0.9f, 0.6f * std::sin(3 * u) * std::sin(3 * v) - nearer);
  };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1);
      vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1);
    }
}

void draw_lights(const Gl& gl) {
  gl.ClearColor(0.1f, 0.1f, 0.2f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  for (int cells : {3, 24}) {
    gl.Begin(GL_TRIANGLES);
    hill(gl, cells, 0, 0.3f);
    gl.End();
    gl.Enable(GL_ALPHA_TEST);
    gl.AlphaFunc(GL_GEQUAL, 0.5f);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    for (float nearer : {0.0f, 0.05f}) {
      gl.Begin(GL_TRIANGLES);
      hill(gl, cells, 0, 0.1f);
      hill(gl, cells, nearer, 0.15f);
      hill(gl, cells, 0, 0.2f);
      gl.End();
    }
    gl.Disable(GL_ALPHA_TEST);
    gl.Disable(GL_BLEND);
  }
  gl.Disable(GL_DEPTH_TEST);
}

void renderbuffer(const Gl& gl, GLenum attachment, GLenum format, int width, int height) {
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 4, format, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
}

void draw_added_lights(Stage& s) {
  const Gl& gl = s.gl;
  const int half = s.width / 2;
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  gl.BindFramebuffer(GL_FRAMEBUFFER, name);
  renderbuffer(gl, GL_COLOR_ATTACHMENT0, GL_RGBA8, half, s.height);
  renderbuffer(gl, GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, half, s.height);
  gl.Viewport(0, 0, half, s.height);
  draw_lights(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  draw_lights(gl);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, name);
  gl.BlitFramebuffer(0, 0, half, s.height, half, 0, s.width, s.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

SceneRegistration registration{{"added_lights", draw_added_lights, false, 192, 144}};

} // namespace
} // namespace softgl::test
