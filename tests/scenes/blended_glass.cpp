// Four panes of colored glass behind each other, drawn back to front, over an opaque torus.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_blended_glass(Stage& s) {
  const Gl& gl = s.gl;
  gl.ClearColor(0.9f, 0.9f, 0.85f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  camera(s, 4);
  gl.Enable(GL_DEPTH_TEST);
  gl.Color3f(0.3f, 0.3f, 0.35f);
  gl.PushMatrix();
  gl.Rotatef(50, 1, 1, 0);
  torus(s, 0.9f, 0.35f, 24, 12);
  gl.PopMatrix();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl.DepthMask(0);
  for (int i = 0; i < 4; i++) {
    gl.Color4f(i == 0, i == 1, i >= 2, 0.35f);
    gl.PushMatrix();
    gl.Rotatef(20, 0, 1, 0);
    gl.Translatef(-0.6f + 0.4f * float(i), -0.3f + 0.2f * float(i), -0.9f + 0.6f * float(i));
    gl.Begin(GL_TRIANGLE_FAN);
    gl.Vertex2f(-0.8f, -0.6f);
    gl.Vertex2f(0.8f, -0.6f);
    gl.Vertex2f(0.8f, 0.6f);
    gl.Vertex2f(-0.8f, 0.6f);
    gl.End();
    gl.PopMatrix();
  }
}

static SceneRegistration registration{{"blended_glass", draw_blended_glass, false, 224, 168}};

} // namespace softgl::test
