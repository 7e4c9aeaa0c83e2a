// A lit pot: one white light from above, shiny red material, depth test.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_teapot(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat position[4] = {2, 4, 3, 0}, red[4] = {0.75f, 0.15f, 0.1f, 1},
                white[4] = {0.8f, 0.8f, 0.8f, 1};
  gl.ClearColor(0.15f, 0.18f, 0.22f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  camera(s, 4.2f);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_NORMALIZE);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, red);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 40);
  gl.Rotatef(25, 1, 0, 0);
  gl.Rotatef(-20, 0, 1, 0);
  teapot(s, 40);
}

static SceneRegistration registration{{"teapot", draw_teapot, false, 320, 240}};

} // namespace softgl::test
