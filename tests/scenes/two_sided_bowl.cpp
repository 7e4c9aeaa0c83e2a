// Half a sphere seen from both sides: two-sided lighting with separate specular colour.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_two_sided_bowl(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat front[4] = {0.2f, 0.5f, 0.8f, 1}, back[4] = {0.8f, 0.5f, 0.1f, 1}, white[4] = {1, 1, 1, 1}, position[4] = {1, 2, 3, 1};
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  camera(s, 3.5f);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, front);
  gl.Materialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
  gl.Materialf(GL_FRONT, GL_SHININESS, 20);
  gl.Materialf(GL_BACK, GL_SHININESS, 90);
  const GLdouble plane[4] = {0.3, 1, 0.5, 0};
  gl.ClipPlane(GL_CLIP_PLANE0, plane);
  gl.Enable(GL_CLIP_PLANE0);
  gl.Rotatef(70, 1, 0.2f, 0);
  torus(s, 0.8f, 0.5f, 36, 18);
}

static SceneRegistration registration{{"two_sided_bowl", draw_two_sided_bowl, false, 224, 168}};

} // namespace softgl::test
