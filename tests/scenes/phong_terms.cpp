// The terms of the illumination model side by side, and all of them with the half vector and the reflection
// vector; above lit per vertex, below per pixel.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_phong_terms(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat ambient[4] = {0.05f, 0.1f, 0.2f, 1}, diffuse[4] = {0.2f, 0.4f, 0.6f, 1},
                white[4] = {1, 1, 1, 1}, emission[4] = {0.15f, 0.05f, 0, 1};
  const GLfloat position[4] = {2, 2, 3, 1};
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Materialfv(GL_FRONT, GL_AMBIENT, ambient);
  gl.Materialfv(GL_FRONT, GL_DIFFUSE, diffuse);
  gl.Materialfv(GL_FRONT, GL_SPECULAR, white);
  gl.Materialfv(GL_FRONT, GL_EMISSION, emission);
  gl.Materialf(GL_FRONT, GL_SHININESS, 30);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, white);
  const GLint terms[6] = {GL_EMISSION_TERM_BIT_SOFTGL, GL_AMBIENT_TERM_BIT_SOFTGL, GL_DIFFUSE_TERM_BIT_SOFTGL,
                          GL_SPECULAR_TERM_BIT_SOFTGL, GL_ALL_TERM_BITS_SOFTGL,    GL_ALL_TERM_BITS_SOFTGL};
  const int size = s.width / 6;
  for (int row = 0; row < 2; ++row)
    for (int i = 0; i < 6; ++i) {
      gl.Viewport(i * size, (1 - row) * size, size, size);
      gl.MatrixMode(GL_PROJECTION);
      gl.LoadIdentity();
      gl.Frustum(-0.45, 0.45, -0.45, 0.45, 1, 10);
      gl.MatrixMode(GL_MODELVIEW);
      gl.LoadIdentity();
      gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
      gl.Translatef(0, 0, -2);
      gl.ShadeModel(row ? GL_PHONG_WIN : GL_SMOOTH);
      gl.LightModeli(GL_LIGHT_MODEL_TERMS_SOFTGL, terms[i]);
      gl.LightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL,
                     i == 5 ? GL_REFLECTION_VECTOR_SOFTGL : GL_HALF_VECTOR_SOFTGL);
      torus(s, 0, 0.7f, 12, 12); // a sphere
    }
}

static SceneRegistration registration{
    {.name = "phong_terms", .draw = draw_phong_terms, .width = 384, .height = 128, .extension = true}};

} // namespace softgl::test
