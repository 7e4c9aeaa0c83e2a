// Per-pixel lighting of a coarse sphere and a torus: spot, positional and directional light, a local viewer.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_phong_sphere(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat diffuse[4] = {0.1f, 0.4f, 0.7f, 1}, white[4] = {1, 1, 1, 1}, dim[4] = {0.3f, 0.25f, 0.2f, 1};
  const GLfloat near_light[4] = {1, 1.5f, 2, 1}, far_light[4] = {-1, 0.2f, 0.3f, 0},
                spot[4] = {0, 0.4f, 3, 1}, toward[3] = {0.1f, -0.2f, -1};
  gl.ClearColor(0.1f, 0.1f, 0.12f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  camera(s, 4);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, near_light);
  gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.05f);
  gl.Lightfv(GL_LIGHT1, GL_POSITION, far_light);
  gl.Lightfv(GL_LIGHT1, GL_DIFFUSE, dim);
  gl.Lightfv(GL_LIGHT2, GL_POSITION, spot);
  gl.Lightfv(GL_LIGHT2, GL_SPOT_DIRECTION, toward);
  gl.Lightf(GL_LIGHT2, GL_SPOT_CUTOFF, 14);
  gl.Lightf(GL_LIGHT2, GL_SPOT_EXPONENT, 3);
  gl.Lightfv(GL_LIGHT2, GL_DIFFUSE, white);
  gl.Lightfv(GL_LIGHT2, GL_SPECULAR, white);
  for (GLenum light : {GL_LIGHT0, GL_LIGHT1, GL_LIGHT2}) gl.Enable(light);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
  gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, diffuse);
  gl.Materialfv(GL_FRONT, GL_SPECULAR, white);
  gl.Materialf(GL_FRONT, GL_SHININESS, 40);
  gl.ShadeModel(GL_PHONG_WIN);
  gl.Rotatef(55, 1, 0.1f, 0);
  torus(s, 1.2f, 0.3f, 12, 6);
  torus(s, 0.01f, 0.7f, 8, 8);
}

static SceneRegistration registration{
    {.name = "phong_sphere", .draw = draw_phong_sphere, .width = 240, .height = 180, .extension = true}};

} // namespace softgl::test
