// A tunnel of rings that fades into exponential fog; the camera stands inside, so the near plane clips.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_fog_tunnel(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat fog[4] = {0.55f, 0.6f, 0.7f, 1};
  gl.ClearColor(fog[0], fog[1], fog[2], 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  camera(s, 0);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_FOG);
  gl.Fogi(GL_FOG_MODE, GL_EXP2);
  gl.Fogf(GL_FOG_DENSITY, 0.08f);
  gl.Fogfv(GL_FOG_COLOR, fog);
  for (int i = 0; i < 16; i++) {
    gl.PushMatrix();
    gl.Translatef(0, 0, 1.0f - 2.0f * float(i));
    gl.Rotatef(float(i) * 7, 0, 0, 1);
    gl.Color3f(i & 1 ? 0.9f : 0.3f, 0.4f, i & 2 ? 0.8f : 0.2f);
    torus(s, 1.6f, 0.5f, 14, 8);
    gl.PopMatrix();
  }
}

static SceneRegistration registration{{"fog_tunnel", draw_fog_tunnel, false, 256, 192}};

} // namespace softgl::test
