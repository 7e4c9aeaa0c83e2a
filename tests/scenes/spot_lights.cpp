// Three colored spots with attenuation on a tessellated wall, local viewer.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_spot_lights(Stage& s) {
  const Gl& gl = s.gl;
  gl.ClearColor(0, 0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  camera(s, 3);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
  for (int i = 0; i < 3; i++) {
    const GLenum light = GL_LIGHT0 + GLenum(i);
    const GLfloat color[4] = {i == 0 ? 1.0f : 0.2f, i == 1 ? 1.0f : 0.2f, i == 2 ? 1.0f : 0.2f, 1};
    const GLfloat position[4] = {float(i - 1) * 0.6f, 0.3f, 1, 1},
                  direction[3] = {float(1 - i) * 0.3f, -0.2f, -1};
    gl.Enable(light);
    gl.Lightfv(light, GL_DIFFUSE, color);
    gl.Lightfv(light, GL_SPECULAR, color);
    gl.Lightfv(light, GL_POSITION, position);
    gl.Lightfv(light, GL_SPOT_DIRECTION, direction);
    gl.Lightf(light, GL_SPOT_CUTOFF, 30);
    gl.Lightf(light, GL_SPOT_EXPONENT, 8);
    gl.Lightf(light, GL_LINEAR_ATTENUATION, 0.2f);
    gl.Lightf(light, GL_QUADRATIC_ATTENUATION, 0.1f);
  }
  const GLfloat grey[4] = {0.7f, 0.7f, 0.7f, 1};
  gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, grey);
  gl.Materialfv(GL_FRONT, GL_SPECULAR, grey);
  gl.Materialf(GL_FRONT, GL_SHININESS, 60);
  gl.Normal3f(0, 0, 1);
  for (int y = 0; y < 32; y++) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int x = 0; x <= 40; x++)
      for (int k = 1; k >= 0; k--) gl.Vertex3f(float(x) * 0.08f - 1.6f, float(y + k) * 0.08f - 1.28f, 0);
    gl.End();
  }
}

static SceneRegistration registration{{"spot_lights", draw_spot_lights, false, 256, 192}};

} // namespace softgl::test
